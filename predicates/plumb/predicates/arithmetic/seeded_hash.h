// Hash functions for tables of data from files, and a hash set of ids.
//
// If the hash function were known, an attacker could write a file of points that all have the same
// hash. A hash table of these points would take quadratic time to build. A table that grows
// whenever keys collide would grow until no memory is left. Therefore each process chooses a random
// hash function. No result of plumb may depend on the hash function: tables are searched and never
// iterated.
//
// The probability that two different keys have the same hash is 2^-32. Each 32-bit word of a key is
// multiplied by a random 64-bit word, and the products are added. A fixed permutation of the 32-bit
// words maps the upper half of this sum to the hash, so that consecutive keys do not have
// consecutive hashes.
//
// Sources: D. Lemire, O. Kaser, Strongly universal string hashing is fast, The Computer Journal 57
// (2014); the permutation is taken from MurmurHash3 (A. Appleby).
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#pragma GCC visibility push(default)
namespace plumb {

/// A function object that returns 32-bit hashes of keys. All bits of a hash are equally random.
struct SeededHash {
  std::size_t operator()(std::uint64_t key) const;
  std::size_t operator()(const std::array<std::uint64_t, 3>& key) const;
};

/// A hash set of ids. A table uses it to give equal objects the same id. The set does not store the
/// objects themselves.
///
/// The set uses open addressing with 8 bytes for each entry. At most two thirds of the entries are
/// occupied. Unlike a hash set of the standard library, the set finds or adds an id in one search.
/// It also offers a function that prefetches entries, because searches in large tables are limited
/// by the latency of memory. Ids are never removed.
class IdIndex {
 public:
  /// Reserves memory for `ids` ids, including the ids that are already in the set.
  void reserve(std::size_t ids) {
    const std::size_t entries = std::bit_ceil(ids + ids / 2 + 1);
    if (entries > entries_.size()) rehash(entries);
  }

  /// Prefetches the entry that find_or_add() will read first for this hash.
  void prefetch(std::uint32_t hash) const {
    if (!entries_.empty()) __builtin_prefetch(&entries_[hash & mask()]);
  }

  /// Returns the id with this hash for which is_same(id) is true. If there is no such id, adds and
  /// returns `next`. Requires next < 2^32 - 1. Also requires that equal objects have equal hashes,
  /// and that all bits of a hash are equally random, as in SeededHash.
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

  /// Returns the id with this hash for which is_same(id) is true, or 2^32 - 1 if there is none.
  template <class IsSame>
  std::uint32_t find(std::uint32_t hash, IsSame is_same) const {
    if (entries_.empty()) return kNone;
    for (std::size_t at = hash & mask(); entries_[at].id != kNone; at = (at + 1) & mask()) {
      if (entries_[at].hash == hash && is_same(entries_[at].id)) return entries_[at].id;
    }
    return kNone;
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

  std::vector<Entry> entries_;  // The number of entries is 0 or a power of two.
  std::size_t count_ = 0;
};

}  // namespace plumb
#pragma GCC visibility pop
