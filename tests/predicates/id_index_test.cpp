// Ids are found by their keys, whatever the hashes: beside std::map.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <map>
#include <vector>

#include "plumb/predicates/arithmetic/seeded_hash.h"

namespace plumb::id_index_test {
namespace {

/// Numbers keys in the order in which they first come, by the index and by a map.
class Numbered {
 public:
  /// `hashes` hashes at most: the fewer, the more keys share one.
  explicit Numbered(std::uint32_t hashes) : hashes_(hashes) {}

  IdIndex index;

  std::uint32_t by_index(std::uint32_t key) {
    const auto next = static_cast<std::uint32_t>(keys_.size());
    const std::uint32_t id = index.find_or_add(hash_of(key), next, [&](std::uint32_t i) {
      EXPECT_LT(i, next);
      return keys_[i] == key;
    });
    if (id == next) keys_.push_back(key);
    return id;
  }
  std::uint32_t by_map(std::uint32_t key) {
    return map_.try_emplace(key, static_cast<std::uint32_t>(map_.size())).first->second;
  }
  std::uint32_t hash_of(std::uint32_t key) const { return key * 0x9e3779b9U % hashes_; }

 private:
  std::uint32_t hashes_;
  std::vector<std::uint32_t> keys_;
  std::map<std::uint32_t, std::uint32_t> map_;
};

RC_GTEST_PROP(IdIndex, NumbersKeysAsAMapDoes, ()) {
  Numbered numbered(*rc::gen::inRange(1U, 2000U));
  if (*rc::gen::arbitrary<bool>()) numbered.index.reserve(*rc::gen::inRange<std::size_t>(0, 500));
  for (const std::uint32_t key :
       *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(0U, 300U))) {
    numbered.index.prefetch(numbered.hash_of(key));
    RC_ASSERT(numbered.by_index(key) == numbered.by_map(key));
  }
}

// The last place of the table, from where a search goes on at the first: hashes that end in ones.
TEST(IdIndex, GoesOnFromTheLastPlace) {
  IdIndex index;
  for (std::uint32_t id = 0; id < 100; ++id) {
    EXPECT_EQ(index.find_or_add(~0U, id, [](std::uint32_t) { return false; }), id);
  }
  for (std::uint32_t id = 0; id < 100; ++id) {
    EXPECT_EQ(index.find_or_add(~0U, 100, [&](std::uint32_t i) { return i == id; }), id);
  }
}

// What has another hash is not asked about.
TEST(IdIndex, AsksAboutIdsOfTheHashAlone) {
  IdIndex index;
  for (std::uint32_t id = 0; id < 1000; ++id) {
    const auto asks_none = [](std::uint32_t) {
      ADD_FAILURE();
      return false;
    };
    index.find_or_add(id << 8U, id, asks_none);  // crowded in every table of less than 2^18 places
  }
}

// A table that is given room does not grow: two walks over as many ids, one with room, find the
// same.
TEST(IdIndex, GrowsWithoutLoss) {
  IdIndex grown, roomy;
  roomy.reserve(100000);
  for (std::uint32_t id = 0; id < 100000; ++id) {
    const auto is = [&](std::uint32_t i) { return i == id; };
    const std::uint32_t hash = id * 2654435761U;
    ASSERT_EQ(grown.find_or_add(hash, id, is), roomy.find_or_add(hash, id, is));
  }
  for (std::uint32_t id = 0; id < 100000; ++id) {
    const auto is = [&](std::uint32_t i) { return i == id; };
    ASSERT_EQ(grown.find_or_add(id * 2654435761U, 100000, is), id);
  }
}

}  // namespace
}  // namespace plumb::id_index_test
