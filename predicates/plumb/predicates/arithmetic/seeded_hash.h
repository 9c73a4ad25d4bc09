// Hashes for tables of what files say. Whoever knows a hash function can write a file of points
// that all have one hash: a table then takes quadratic time, and one that grows where keys crowd,
// all the memory that there is. So each process draws a function of its own. Nothing that plumb
// answers may depend on it: tables are asked, never walked through.
//
// Two different keys have one hash with a probability of 2^-32, whatever they are: the upper half
// of a sum of products, of words of 32 bits with random ones of 64. A fixed permutation comes after
// that, so that keys in a row do not make hashes in a row.
//
// Sources: Lemire and Kaser, "Strongly universal string hashing is fast" (2014); the permutation is
// MurmurHash3's.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#pragma GCC visibility push(default)
namespace plumb {

/// 32 bits, all of them as good as each other.
struct SeededHash {
  std::size_t operator()(std::uint64_t key) const;
  std::size_t operator()(const std::array<std::uint64_t, 3>& key) const;
};

// A hash set of ids whose keys lie elsewhere: for tables that give equal things one id.
//
// Open addressing, 8 bytes an entry, two entries in three taken at most. Beside a hash set of a
// library it finds or adds in one walk, and takes hints of what will be looked for: large tables
// wait for memory, not for arithmetic. There is no removal.

class IdIndex {
 public:
  /// Makes room for so many ids in all.
  void reserve(std::size_t ids) {
    const std::size_t entries = std::bit_ceil(ids + ids / 2 + 1);
    if (entries > entries_.size()) rehash(entries);
  }

  /// Fetches what find_or_add will read for this hash.
  void prefetch(std::uint32_t hash) const {
    if (!entries_.empty()) __builtin_prefetch(&entries_[hash & mask()]);
  }

  /// The id of this hash for which is_same(id); if there is none `next`, which is added. Hashes:
  /// all their bits are good (SeededHash), and equal for ids that are the same. next < 2^32 - 1.
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

  std::vector<Entry> entries_;  // none, or a power of two of them
  std::size_t count_ = 0;
};

}  // namespace plumb
#pragma GCC visibility pop
