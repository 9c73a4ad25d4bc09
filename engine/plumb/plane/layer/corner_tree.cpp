#include "plumb/plane/layer/corner_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace plumb {

CornerTree::CornerTree(std::vector<Point2> points)
    : points_(std::move(points)), order_(points_.size()), rank_(points_.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  is_left_.assign(points_.size(), 1);
  std::size_t nodes = 1;
  for (std::size_t leaf = kLeaf; leaf < points_.size(); leaf *= 2) nodes = 2 * nodes + 1;
  // The sizes of the ranges of one level differ by at most one, so one more level may be needed.
  nodes = 2 * nodes + 1;
  box_.resize(nodes);
  count_.assign(nodes, 0);
  if (!order_.empty()) build(root());
  for (std::uint32_t r = 0; r < order_.size(); ++r) rank_[order_[r]] = r;
}

/// Splits the points at the median of the longer side of their box. Recursion is as deep as the
/// tree, which has at most 32 levels.
void CornerTree::build(Node node) {
  Box box{points_[order_[node.begin]], points_[order_[node.begin]]};
  for (std::uint32_t r = node.begin; r < node.end; ++r) {
    const Point2 p = points_[order_[r]];
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  box_[node.index] = box;
  count_[node.index] = node.end - node.begin;
  if (node.is_leaf()) return;
  const bool is_wide = box.high.x - box.low.x > box.high.y - box.low.y;
  const auto at = [this](std::uint32_t r) {
    return order_.begin() + static_cast<std::ptrdiff_t>(r);
  };
  std::nth_element(at(node.begin), at(node.middle()), at(node.end),
                   [&](std::uint32_t i, std::uint32_t j) {
                     const Point2 p = points_[i], q = points_[j];
                     return is_wide ? p.x < q.x : p.y < q.y;
                   });
  build(node.lower());
  build(node.upper());
}

CornerTree::Box CornerTree::box_around(std::span<const Point2> points) {
  Box box{points.front(), points.front()};
  for (const Point2 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

/// Whether doubles prove that the whole box lies to the right of the line from a to b. The corner
/// that is farthest to the left decides. The error of the determinant is less than 4 u times the
/// sum of the magnitudes of its products, for u = 2^-53, unless the products underflow.
bool CornerTree::is_right_of(const Box& box, Point2 a, Point2 b) {
  constexpr double kError = 1e-15, kLeastSum = 1e-290;
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double x = dy < 0 ? box.high.x : box.low.x, y = dx > 0 ? box.high.y : box.low.y;
  const double up = dx * (y - a.y), down = dy * (x - a.x);
  const double sum = std::fabs(up) + std::fabs(down);
  return sum > kLeastSum && up - down < -kError * sum;
}

void CornerTree::remove(std::uint32_t i) {
  is_left_[i] = 0;
  for (Node node = root();; node = rank_[i] < node.middle() ? node.lower() : node.upper()) {
    --count_[node.index];
    if (node.is_leaf()) return;
  }
}

}  // namespace plumb
