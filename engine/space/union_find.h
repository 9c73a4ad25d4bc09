// Disjoint classes of 0, 1, 2, ...
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace plumb {

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
  /// The root of both is the lesser one.
  void unite(std::uint32_t i, std::uint32_t j) {
    i = root(i);
    j = root(j);
    if (i < j) std::swap(i, j);
    parent_[i] = j;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace plumb
