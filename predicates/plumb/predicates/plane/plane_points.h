// The signed area of polygons; and the points of an arrangement, input points and crossings under
// one numbering, with their order and orientation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the sign of the area that the closed polygon through the given points encloses, simple
/// or not: Positive if it winds counter-clockwise on balance, Zero for instance for a symmetric
/// bow-tie. Reversal flips the sign, rotation of the list keeps it. O(n) doubles if the filter
/// decides, otherwise O(n) exact terms.
Sign polygon_area_sign(const PointTable2& points, std::span<const std::uint32_t> polygon);

/// Returns twice the signed area, exactly. Requires a polygon that is not empty.
Rational twice_polygon_area(const PointTable2& points, std::span<const std::uint32_t> polygon);

// The points of an arrangement have a dense index: input point i is i, crossing k is
// inputs.size() + k. Lines are given by two input points, never by crossings, so predicates have
// the same degree however a point came about.

/// Input points, and crossings of lines through input points.
struct PlanePoints {
  PointTable2 inputs;                ///< The input points.
  std::vector<Crossing2> crossings;  ///< Crossings of lines through points of `inputs`.

  std::size_t size() const { return inputs.size() + crossings.size(); }
};

/// A read-only view of PlanePoints, or of a table alone. Valid as long as these are unchanged.
class PlanePointsView {
 public:
  PlanePointsView(const PointTable2& inputs) : inputs_(&inputs) {}
  PlanePointsView(const PlanePoints& points)
      : inputs_(&points.inputs), crossings_(points.crossings) {}

  std::size_t size() const { return inputs_->size() + crossings_.size(); }
  const PointTable2& inputs() const { return *inputs_; }
  bool is_input(std::uint32_t i) const { return i < inputs_->size(); }
  /// Returns the crossing with dense index i. Requires !is_input(i).
  const Crossing2& crossing(std::uint32_t i) const { return crossings_[i - inputs_->size()]; }

 private:
  const PointTable2* inputs_;
  std::span<const Crossing2> crossings_;
};

/// Returns the lexicographic order of two points of any kind.
Sign compare_xy(const PlanePointsView& points, std::uint32_t i, std::uint32_t j);
/// Returns that of a crossing, which need not be in the table, and a point.
Sign compare_xy(const PlanePointsView& points, const Crossing2& p, std::uint32_t i);

/// Returns the order of two points by x alone.
Sign compare_x(const PlanePointsView& points, std::uint32_t i, std::uint32_t j);
/// Returns that of a crossing and a point.
Sign compare_x(const PlanePointsView& points, const Crossing2& p, std::uint32_t i);

/// Returns the side of the line through input points a -> b on which point i of any kind lies;
/// Positive is left.
inline Sign orient2d(const PlanePointsView& points, std::uint32_t a, std::uint32_t b,
                     std::uint32_t i) {
  return points.is_input(i) ? orient2d(points.inputs(), a, b, i)
                            : orient2d(points.inputs(), a, b, points.crossing(i));
}

/// Returns the exact coordinates of a point of any kind.
RationalPoint2 exact(const PlanePointsView& points, std::uint32_t i);

/// Returns the nearest doubles of an input point, or the approximation of a crossing, which is not
/// correctly rounded.
inline Point2 approx(const PlanePointsView& points, std::uint32_t i) {
  if (points.is_input(i)) return points.inputs().approx(i);
  return {points.crossing(i).x, points.crossing(i).y};
}

}  // namespace plumb
#pragma GCC visibility pop
