// Boxes around points and cells, and frames of axes for them.
//
// Invariant: every box contains its cell, in spite of rounding and of flushing of subnormals to
// zero. The bounds are stated at each sum. A cell lies within the box of its vertices, as cells are
// parts of planes and lines between them. The number of expected pairs is an estimate, which only
// affects the speed: for boxes at random places the probability that two overlap along an axis is
// about the sum of their mean sides, divided by the width of all.
//
// Tested by tests/space/find_contacts_test.cpp, tests/space/mesh_crossings_test.cpp and
// tests/space/space_locator_test.cpp.

#include "plumb/space/complex/space_boxes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace plumb {

namespace {

/// Returns the box of all of space.
Box3 everywhere() {
  constexpr double kInfinity = Box3::kInfinity;
  return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}};
}

}  // namespace

// The error of a sum of two doubles is one rounding, at most 2^-52 of the sum, plus the loss if
// subnormal operands are flushed.
Box3 box_of(const PointBox& point) {
  if (point.radius == 0) return {point.mid, point.mid};
  Box3 box;
  if (!std::isfinite(point.radius)) return everywhere();
  for (std::size_t i = 0; i < 3; ++i) {
    const double slack = 0x1p-50 * (std::fabs(point.mid[i]) + point.radius) + 0x1p-1000;
    box.low[i] = point.mid[i] - (point.radius + slack);
    box.high[i] = point.mid[i] + (point.radius + slack);
  }
  return box;
}

Box3 box_of_constructed(const Point3Table& points, SpacePoint p) {
  const PointBox point = points.box(p);
  if (!is_far(point)) return box_of(point);
  Box3 box = box_of(points.near_box(p));
  for (std::size_t i = 0; i < 3; ++i) {
    if (point.mid[i] == 0) continue;
    // Along this axis, the far part of the point is not 0, so the point exceeds all doubles.
    const bool is_above = point.mid[i] > 0;
    box.low[i] = is_above ? std::numeric_limits<double>::max() : -Box3::kInfinity;
    box.high[i] = is_above ? Box3::kInfinity : std::numeric_limits<double>::lowest();
  }
  return box;
}

Box3 box_of(const SpaceComplex& complex, EdgeId e) {
  Box3 box = box_of(complex, complex.origin[2 * e.value()]);
  box.add(box_of(complex, complex.origin[2 * e.value() + 1]));
  return box;
}

Box3 box_of(const SpaceComplex& complex, FacetId f) {
  Box3 box;
  const UseId first = complex.cycles_of(f).front();
  UseId u = first;
  do {
    box.add(box_of(complex, complex.use_origin(u)));
    u = complex.use_next[u];
  } while (u != first);
  return box;
}

Box3 box_of(const SpaceComplex& complex) {
  Box3 box;
  for (std::size_t v = 0; v < complex.vertex_count(); ++v) box.add(box_of(complex, VertexId(v)));
  return box;
}

namespace {

constexpr Matrix3 kCoordinateAxes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

/// Turns the matrix in the plane of axes i and j so that m[i][j] becomes 0, and the rows of `axes`
/// with it: one step of C. Jacobi's method. The smaller root t of t^2 + 2 theta t - 1 = 0 is the
/// tangent of the angle.
void rotate(Matrix3& m, Matrix3& axes, std::size_t i, std::size_t j) {
  if (m[i][j] == 0) return;
  const double theta = (m[j][j] - m[i][i]) / (2 * m[i][j]);
  const double t = (theta < 0 ? -1 : 1) / (std::fabs(theta) + std::hypot(theta, 1.0));
  const double c = 1 / std::hypot(t, 1.0), s = t * c;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = m[k][i], y = m[k][j];
    m[k][i] = c * x - s * y;
    m[k][j] = s * x + c * y;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = m[i][k], y = m[j][k];
    m[i][k] = c * x - s * y;
    m[j][k] = s * x + c * y;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = axes[i][k], y = axes[j][k];
    axes[i][k] = c * x - s * y;
    axes[j][k] = s * x + c * y;
  }
}

}  // namespace

Matrix3 principal_axes(Matrix3 m) {
  constexpr int kSweeps = 8;
  Matrix3 axes = kCoordinateAxes;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    rotate(m, axes, 0, 1);
    rotate(m, axes, 0, 2);
    rotate(m, axes, 1, 2);
  }
  for (const Vector3& axis : axes) {
    if (!std::isfinite(axis[0] + axis[1] + axis[2])) return kCoordinateAxes;
  }
  return axes;
}

namespace {

/// Returns the middle of a box.
Vector3 middle(const Box3& b) {
  return {b.low[0] / 2 + b.high[0] / 2, b.low[1] / 2 + b.high[1] / 2, b.low[2] / 2 + b.high[2] / 2};
}

/// Returns the sum of d d^T over the vectors d of all edges with finite ends.
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

// The value at the middle is off by less than 8 roundings of its terms, and so are half the sides;
// flushed subnormals lose less than 2^-1000 (the components of axes are at most about 1).
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
    u = complex.use_next[u];
  } while (u != first);
  return box;
}

// The pairs of all boxes, times for each axis the part of the whole width that both mean sides
// have.
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
    // Boxes that are as wide as everything overlap along this axis in any case.
    if (sides[k] < width) pairs *= sides[k] / width;
  }
  return pairs;
}

bool has_many_pairs(double expected, std::size_t items) {
  return std::isfinite(expected) && expected > 8 * static_cast<double>(items) + 1000;
}

}  // namespace plumb
