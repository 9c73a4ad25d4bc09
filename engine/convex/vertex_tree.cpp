#include "plumb/convex/vertex_tree.h"

#include <algorithm>
#include <cmath>

#include "plumb/predicates/point3_signs.h"

namespace plumb {
namespace {

std::size_t middle_of(std::size_t begin, std::size_t end) { return begin + (end - begin) / 2; }

}  // namespace

VertexTree::VertexTree(const SpaceComplex& complex, std::vector<VertexId> vertices)
    : c_(complex), vertices_(std::move(vertices)) {
  if (!vertices_.empty()) build(0, vertices_.size(), 0);
}

void VertexTree::build(std::size_t begin, std::size_t end, std::size_t node) {
  if (boxes_.size() <= node) boxes_.resize(node + 1);
  Box3 box;
  for (std::size_t i = begin; i < end; ++i) {
    const PointBox at = c_.points().box(c_.vertex_point[vertices_[i].value()]);
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], at.mid[k] - at.radius);
      box.high[k] = std::max(box.high[k], at.mid[k] + at.radius);
    }
  }
  boxes_[node] = box;
  if (end - begin <= kLeaf) return;
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
  }
  const std::size_t middle = middle_of(begin, end);
  const auto at = [&](VertexId v) { return c_.points().box(c_.vertex_point[v.value()]).mid[axis]; };
  const auto from = vertices_.begin();
  std::nth_element(from + static_cast<std::ptrdiff_t>(begin),
                   from + static_cast<std::ptrdiff_t>(middle),
                   from + static_cast<std::ptrdiff_t>(end),
                   [&](VertexId v, VertexId w) { return at(v) != at(w) ? at(v) < at(w) : v < w; });
  build(begin, middle, 2 * node + 1);
  build(middle, end, 2 * node + 2);
}

/// Not when the corner farthest to that side is surely not beyond the plane.
bool VertexTree::can_hold(PlaneId plane, Sign side, const Box3& box) const {
  const PlaneRow& row = c_.planes().row(plane);
  const double s = side == Sign::Positive ? 1 : -1;
  double value = s * row.d, size = std::abs(row.d);
  for (std::size_t k = 0; k < 3; ++k) {
    const double n = s * row.n[k], x = n > 0 ? box.high[k] : box.low[k];
    value += n * x;
    size += std::abs(x);
  }
  return !(value <
           -(static_cast<double>(row.normal_error) * size + static_cast<double>(row.offset_error)));
}

VertexId VertexTree::find(PlaneId plane, Sign side) const {
  return vertices_.empty() ? VertexId() : find(plane, side, 0, vertices_.size(), 0);
}

VertexId VertexTree::find(PlaneId plane, Sign side, std::size_t begin, std::size_t end,
                          std::size_t node) const {
  if (!can_hold(plane, side, boxes_[node])) return {};
  if (end - begin > kLeaf) {
    const std::size_t middle = middle_of(begin, end);
    const VertexId v = find(plane, side, begin, middle, 2 * node + 1);
    return v.is_valid() ? v : find(plane, side, middle, end, 2 * node + 2);
  }
  for (std::size_t i = begin; i < end; ++i) {
    const SpacePoint x = c_.vertex_point[vertices_[i].value()];
    if (plumb::side(c_.points(), x, plane) == side) return vertices_[i];
  }
  return {};
}

}  // namespace plumb
