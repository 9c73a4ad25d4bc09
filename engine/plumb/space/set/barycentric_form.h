// Exact barycentric weights in a triangle of space, seen along an axis. Internal.
#pragma once

#include <array>
#include <cstddef>

#include "plumb/predicates/point.h"
#include "plumb/predicates/rational.h"
#include "plumb/predicates/space/plane_table.h"
#include "plumb/space/planar/triangulate.h"

namespace plumb {

/// The weights of the three corners of a triangle at a point, as fractions with one denominator.
struct BarycentricWeights {
  std::array<Integer, 3> numerator;
  Integer denominator;  ///< Positive.

  /// Whether a weight is negative.
  [[nodiscard]] bool has_negative() const {
    return numerator[0].sign() < 0 || numerator[1].sign() < 0 || numerator[2].sign() < 0;
  }
  /// Replaces negative weights by 0; the others keep their ratio, and add up to 1.
  void move_inside();
  /// Returns the weights, each rounded to the nearest double.
  [[nodiscard]] std::array<double, 3> rounded() const;
  /// Returns the weights in lowest terms.
  [[nodiscard]] std::array<Rational, 3> exact() const;
};

/// Returns the weights of a point on the line of the corners i and (i + 1) % 3 of a triangle. These
/// two corners must be given, and the third one can be null. `point` has its coordinates as
/// homogeneous() returns them. The point divides the line in the ratio in which it divides one
/// coordinate, so this takes three products of integers.
[[nodiscard]] BarycentricWeights weights_on_edge(const std::array<const Point3*, 3>& corners,
                                                 std::size_t i, const IntegerRow& point);

/// A triangle, prepared for the weights of many points.
///
/// Let c0, c1, c2 be the corners and x the point in homogeneous coordinates (X w, Y w, w) in the
/// view. The weight of c0 is det(x, c1, c2) w(c0) / (w(x) det(c0, c1, c2)), and so on. All numbers
/// are integers, and nothing is reduced to lowest terms. The third weight is 1 minus the others. So
/// a point costs seven products of integers.
class BarycentricForm {
 public:
  /// Requires corners that do not lie on a line in the view, as homogeneous() returns them.
  BarycentricForm(FlatView view, const std::array<IntegerRow, 3>& corners);

  /// Returns the weights of a point, given as homogeneous() returns it. They add up to 1. A point
  /// off the plane of the triangle is seen along the axis of the view.
  [[nodiscard]] BarycentricWeights at(const IntegerRow& point) const;

 private:
  using Row = std::array<Integer, 3>;

  FlatView view_;
  std::array<Row, 2> form_;  ///< The weight of corner i is form_[i].x / (w(x) area_).
  Integer area_;
};

}  // namespace plumb
