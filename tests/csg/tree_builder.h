// Trees of constructive solid geometry, node after node.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/csg/csg_tree.h"

namespace plumb::testing {

/// Builds a tree in preorder, one node after the other.
class TreeBuilder {
 public:
  void open(CsgKind kind, const std::vector<double>& numbers = {},
            const std::vector<std::uint32_t>& indices = {}) {
    CsgTree::Node node;
    node.kind = kind;
    node.first_number = static_cast<std::uint32_t>(tree_.numbers.size());
    node.number_count = static_cast<std::uint32_t>(numbers.size());
    node.first_index = static_cast<std::uint32_t>(tree_.indices.size());
    node.index_count = static_cast<std::uint32_t>(indices.size());
    node.line = static_cast<std::uint32_t>(tree_.nodes.size());
    node.column = 1;
    tree_.numbers.insert(tree_.numbers.end(), numbers.begin(), numbers.end());
    tree_.indices.insert(tree_.indices.end(), indices.begin(), indices.end());
    open_.push_back(tree_.nodes.size());
    tree_.nodes.push_back(node);
  }
  void close() {
    tree_.nodes[open_.back()].end = static_cast<std::uint32_t>(tree_.nodes.size());
    open_.pop_back();
  }
  void leaf(CsgKind kind, const std::vector<double>& numbers,
            const std::vector<std::uint32_t>& indices = {}) {
    open(kind, numbers, indices);
    close();
  }
  void cube(double x, double y, double z) { leaf(CsgKind::Cube, {x, y, z, 0}); }
  void shift(double x, double y, double z) {
    open(CsgKind::Multmatrix, {1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z});
  }
  CsgTree take() {
    tree_.nodes[0].end = static_cast<std::uint32_t>(tree_.nodes.size());
    return std::move(tree_);
  }

 private:
  CsgTree tree_;
  std::vector<std::size_t> open_;
};

}  // namespace plumb::testing
