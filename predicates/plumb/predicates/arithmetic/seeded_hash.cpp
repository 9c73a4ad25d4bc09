#include "plumb/predicates/arithmetic/seeded_hash.h"

#include <random>

namespace plumb {
namespace {

constexpr std::size_t kMostWords = 3;
using Factors = std::array<std::uint64_t, 1 + 2 * kMostWords>;

/// Returns random factors.
Factors drawn() {
  std::random_device random;  // Each call returns 32 bits.
  Factors factors{};
  for (std::uint64_t& f : factors) f = std::uint64_t{random()} << 32U | random();
  return factors;
}

/// Returns a permutation of the hash. The function is one to one.
std::uint32_t mixed(std::uint32_t h) {
  h = (h ^ h >> 16U) * 0x85ebca6bU;
  h = (h ^ h >> 13U) * 0xc2b2ae35U;
  return h ^ h >> 16U;
}

template <std::size_t N>
std::uint32_t hash_of(const std::array<std::uint64_t, N>& key) {
  static_assert(N <= kMostWords);
  static const Factors factors = drawn();
  std::uint64_t sum = factors[0];
  for (std::size_t i = 0; i < N; ++i) {
    sum += factors[2 * i + 1] * (key[i] & 0xffff'ffffU) + factors[2 * i + 2] * (key[i] >> 32U);
  }
  return mixed(static_cast<std::uint32_t>(sum >> 32U));
}

}  // namespace

std::size_t SeededHash::operator()(std::uint64_t key) const { return hash_of(std::array{key}); }

std::size_t SeededHash::operator()(const std::array<std::uint64_t, 3>& key) const {
  return hash_of(key);
}

}  // namespace plumb
