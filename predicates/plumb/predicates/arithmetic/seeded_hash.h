// Hashes for tables of what files contain, and a hash set of ids.
//
// If a hash function is known, a file can be made of points that all have one hash: a table then
// takes quadratic time, or, if it grows where keys crowd, all memory. So each process chooses a
// random function of its own. No result of plumb may depend on it: tables are searched and never
// iterated.
//
// Two different keys have one hash with a probability of 2^-32, whatever they are: the hash is the
// upper half of a sum of products of 32-bit words of the key with random 64-bit words. A fixed
// permutation comes after that, so that consecutive keys do not give consecutive hashes.
//
// Sources: D. Lemire, O. Kaser, Strongly universal string hashing is fast, The Computer Journal 57
// (2014); the permutation is that of MurmurHash3 (A. Appleby).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#pragma GCC visibility push(default)
namespace plumb {

/// Returns hashes of 32 bits, all of which are equally good.
struct SeededHash {
  std::size_t operator()(std::uint64_t key) const;
  std::size_t operator()(const std::array<std::uint64_t, 3>& key) const;
};

/// A hash set of ids whose keys are elsewhere, for tables that give equal objects one id.
///
/// It has open addressing, 8 bytes for each entry, and at most two of three entries taken. Unlike a
/// hash set of a library it finds or adds in one search, and can fetch entries ahead, as large
/// tables wait for memory and not for arithmetic. Nothing is ever removed.
class IdIndex {
 public:
  /// Reserves memory for so many ids in all.
  void reserve(std::size_t ids) {
    const std::size_t entries = std::bit_ceil(ids + ids / 2 + 1);
    if (entries > entries_.size()) rehash(entries);
  }

  /// Fetches what find_or_add() will read for this hash.
  void prefetch(std::uint32_t hash) const {
    if (!entries_.empty()) __builtin_prefetch(&entries_[hash & mask()]);
  }

  /// Returns the id with this hash for which is_same(id) holds; if there is none, adds and returns
  /// `next`. Requires next < 2^32 - 1, and hashes that are equal for equal objects and good in all
  /// bits (SeededHash).
  template <class IsSame>
  std::uint32_t find_or_add(std::uint32_t hash, std::uint32_t next, IsSame is_same) {
    if (3 * (count_ + 1) > 2 * entries_.size()) rehash(std::bit_ceil(2 * count_ + 2));
    std::size_t at = hash & mask();
    for (; entries_[at].id != kNone; at = (at + 1) & mask()) {
      if (entries_[at].hash == hash && is_same(entries_[at].id)) return entries_[at].id;
    }
    entries_[at] = {next, hash};
    ++count_;
    return next;
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  struct Entry {
    std::uint32_t id = kNone;
    std::uint32_t hash = 0;
  };

  std::size_t mask() const { return entries_.size() - 1; }

  void rehash(std::size_t entries) {
    std::vector<Entry> old(entries);
    old.swap(entries_);
    for (const Entry& e : old) {
      if (e.id == kNone) continue;
      std::size_t at = e.hash & mask();
      while (entries_[at].id != kNone) at = (at + 1) & mask();
      entries_[at] = e;
    }
  }

  std::vector<Entry> entries_;  // Their number is 0 or a power of two.
  std::size_t count_ = 0;
};

}  // namespace plumb
#pragma GCC visibility pop
