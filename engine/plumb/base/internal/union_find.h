// Disjoint classes of 0, 1, 2, ...
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace plumb {

/// Union-find with path halving. The root of a class is its least element, so roots do not depend
/// on the order of the unions. Each operation takes amortized O(log n) time.
class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::size_t size() const { return parent_.size(); }
  /// Returns the root of the class of i.
  std::uint32_t root(std::uint32_t i) {
    for (;;) {
      const std::uint32_t parent = parent_[i], beyond = parent_[parent];
      if (parent == beyond) return parent;
      parent_[i] = beyond;
      i = beyond;
    }
  }
  /// Unites the classes of i and j. Returns false if i and j were already in the same class.
  bool unite(std::uint32_t i, std::uint32_t j) {
    i = root(i);
    j = root(j);
    if (i == j) return false;
    parent_[std::max(i, j)] = std::min(i, j);
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace plumb
