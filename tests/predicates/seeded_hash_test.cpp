// Whatever the keys, hashes are as if drawn by lot: few equal ones, in all bits and in the low
// ones.
#include "plumb/predicates/arithmetic/seeded_hash.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <unordered_set>

namespace plumb::seeded_hash_test {
namespace {

using Key = std::array<std::uint64_t, 3>;

/// Of 2^16 hashes of 32 bits half a pair is equal on average; of their lower 16 bits 63 % are
/// different ones.
void expect_spread(const std::string& name, const std::function<std::size_t(std::uint64_t)>& hash) {
  constexpr std::uint64_t kCount = 1U << 16U;
  std::unordered_set<std::size_t> all, low;
  for (std::uint64_t k = 0; k < kCount; ++k) {
    const std::size_t h = hash(k);
    EXPECT_LT(h, std::size_t{1} << 32U);
    all.insert(h);
    low.insert(h % kCount);
  }
  EXPECT_GE(all.size(), kCount - 16) << name;
  EXPECT_GE(low.size(), kCount * 6 / 10) << name;
}

TEST(SeededHash, SpreadsKeysThatCountInAnyPlace) {
  const SeededHash hash;
  for (const unsigned shift : {0U, 1U, 8U, 16U, 31U, 32U, 33U, 40U, 48U}) {
    const std::string by = " << " + std::to_string(shift);
    expect_spread("k" + by, [&](std::uint64_t k) { return hash(k << shift); });
    for (std::size_t i = 0; i < 3; ++i) {
      expect_spread("k" + by + " in word " + std::to_string(i), [&](std::uint64_t k) {
        Key key{7, 7, 7};
        key[i] = k << shift;
        return hash(key);
      });
    }
  }
}

// Factors of two words that were the same, or one a multiple of the other, would let sums of words
// cancel.
TEST(SeededHash, TellsWordsApart) {
  const SeededHash hash;
  expect_spread("k, -k, 0", [&](std::uint64_t k) { return hash(Key{k, ~k, 0}); });
  expect_spread("0, k, -k", [&](std::uint64_t k) { return hash(Key{0, k, ~k}); });
  expect_spread("halves", [&](std::uint64_t k) { return hash(k << 32U | (~k & 0xffff'ffffU)); });
  EXPECT_NE(hash(Key{1, 2, 3}), hash(Key{3, 2, 1}));
}

// Where two parts of 32 bits had one factor, keys in which they are exchanged would have one hash.
TEST(SeededHash, TellsPartsOfWordsApart) {
  const SeededHash hash;
  const auto key = [](std::size_t part, std::uint64_t value, std::size_t other,
                      std::uint64_t more) {
    Key k{};
    k[part / 2] |= value << 32 * (part % 2);
    k[other / 2] |= more << 32 * (other % 2);
    return k;
  };
  for (std::size_t part = 0; part < 6; ++part) {
    for (std::size_t other = 0; other < part; ++other) {
      int equal = 0;
      for (std::uint64_t k = 0; k < 100; ++k) {
        equal +=
            hash(key(part, 2 * k, other, 2 * k + 1)) == hash(key(part, 2 * k + 1, other, 2 * k));
      }
      EXPECT_LT(equal, 3) << part << " and " << other;
    }
  }
}

TEST(SeededHash, IsTheSameEachTime) {
  EXPECT_EQ(SeededHash{}(17), SeededHash{}(17));
  EXPECT_EQ(SeededHash{}(Key{1, 2, 3}), SeededHash{}(Key{1, 2, 3}));
}

}  // namespace
}  // namespace plumb::seeded_hash_test
