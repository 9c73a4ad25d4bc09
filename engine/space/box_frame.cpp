#include "plumb/space/box_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plumb/space/principal_axes.h"
#include "plumb/space/space_boxes.h"

namespace plumb {
namespace {

Vector3 middle(const Box3& b) {
  return {b.low[0] / 2 + b.high[0] / 2, b.low[1] / 2 + b.high[1] / 2, b.low[2] / 2 + b.high[2] / 2};
}

/// The sum of d d^T of all edges with finite ends.
Matrix3 covariance(std::span<const SpaceComplex* const> complexes) {
  Matrix3 sum{};
  for (const SpaceComplex* c : complexes) {
    for (std::size_t e = 0; e < c->edge_count(); ++e) {
      const Vector3 p = middle(plumb::box_of(*c, c->origin[2 * e]));
      const Vector3 q = middle(plumb::box_of(*c, c->origin[2 * e + 1]));
      const Vector3 d{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
      if (!std::isfinite(d[0] * d[0] + d[1] * d[1] + d[2] * d[2])) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) sum[i][j] += d[i] * d[j];
      }
    }
  }
  return sum;
}

}  // namespace

BoxFrame BoxFrame::of_edges(std::span<const SpaceComplex* const> complexes) {
  BoxFrame frame;
  frame.axis_ = principal_axes(covariance(complexes));
  frame.is_turned_ = true;
  return frame;
}

/// The value at the middle is off by less than 8 roundings of its terms, as are half the sides; flushed subnormals
/// lose less than 2^-1000 (the axes' components are at most about 1).
Box3 BoxFrame::turned(const Box3& box) const {
  if (!is_turned_) return box;
  constexpr double kInfinity = Box3::kInfinity;
  const Vector3 c = middle(box);
  Box3 result;
  for (std::size_t k = 0; k < 3; ++k) {
    double value = 0, reach = 0, size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double r = axis_[k][i], half = box.high[i] / 2 - box.low[i] / 2;
      value += r * c[i];
      reach += std::fabs(r) * half;
      size += std::fabs(r) * (std::fabs(c[i]) + half);
    }
    const double slack = 0x1p-48 * size + 0x1p-990;
    const bool is_known = std::isfinite(value) && std::isfinite(reach + slack);
    result.low[k] = is_known ? value - (reach + slack) : -kInfinity;
    result.high[k] = is_known ? value + (reach + slack) : kInfinity;
  }
  return result;
}

Box3 BoxFrame::box_of(const SpaceComplex& complex, VertexId v) const {
  return turned(plumb::box_of(complex, v));
}

Box3 BoxFrame::box_of(const SpaceComplex& complex, EdgeId e) const {
  Box3 box = box_of(complex, complex.origin[2 * e.value()]);
  box.add(box_of(complex, complex.origin[2 * e.value() + 1]));
  return box;
}

Box3 BoxFrame::box_of(const SpaceComplex& complex, FacetId f) const {
  Box3 box;
  const UseId first = complex.cycles_of(f).front();
  UseId u = first;
  do {
    box.add(box_of(complex, complex.use_origin(u)));
    u = complex.use_next[u.value()];
  } while (u != first);
  return box;
}

double expected_pairs(std::span<const Box3> a, std::span<const Box3> b) {
  Box3 all;
  Vector3 sides{};
  for (const auto& [boxes, count] : {std::pair(a, a.size()), std::pair(b, b.size())}) {
    for (const Box3& box : boxes) {
      all.add(box);
      for (std::size_t k = 0; k < 3; ++k) {
        sides[k] += (box.high[k] - box.low[k]) / static_cast<double>(count);
      }
    }
  }
  double pairs = static_cast<double>(a.size()) * static_cast<double>(b.size());
  for (std::size_t k = 0; k < 3; ++k) {
    const double width = all.high[k] - all.low[k];
    if (!std::isfinite(sides[k])) return std::numeric_limits<double>::infinity();
    if (sides[k] < width) pairs *= sides[k] / width;
  }
  return pairs;
}

bool has_many_pairs(double expected, std::size_t items) {
  return std::isfinite(expected) && expected > 8 * static_cast<double>(items) + 1000;
}

}  // namespace plumb
