// Disjoint classes of 0, 1, 2, ...
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace plumb {

/// Path halving; the least number of a class is its root, so that roots do not depend on the order
/// of the unions. Amortised O(log n) each.
class UnionFind {
 public:
  explicit UnionFind(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::size_t size() const { return parent_.size(); }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// False if they were in one class already.
  bool unite(std::uint32_t i, std::uint32_t j) {
    i = root(i);
    j = root(j);
    if (i < j) std::swap(i, j);
    parent_[i] = j;
    return i != j;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace plumb
