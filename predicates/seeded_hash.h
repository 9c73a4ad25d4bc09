// Hashes for tables of what files say. Whoever knows a hash function can write a file of points that all have one hash: a table
// then takes quadratic time, and one that grows where keys crowd, such as tsl::robin_map, all the memory that there is. So each
// process draws a function of its own. Nothing that plumb answers may depend on it: tables are asked, never walked through.
//
// Two different keys have one hash with a probability of 2^-32, whatever they are: the upper half of a sum of products, of words
// of 32 bits with random ones of 64. A fixed permutation comes after that, so that keys in a row do not make hashes in a row.
//
// Sources: Lemire and Kaser, "Strongly universal string hashing is fast" (2014); the permutation is MurmurHash3's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#pragma GCC visibility push(default)
namespace plumb {

/// 32 bits, all of them as good as each other.
struct SeededHash {
  std::size_t operator()(std::uint64_t key) const;
  std::size_t operator()(const std::array<std::uint64_t, 3>& key) const;
};

}  // namespace plumb
#pragma GCC visibility pop
