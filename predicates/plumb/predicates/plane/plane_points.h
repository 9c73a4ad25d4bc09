// Computes signed areas of polygons, and predicates on the points of an arrangement. These points
// are input points and crossings of lines. They are numbered together by one range of indices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the sign of the signed area of the closed polygon through the given points. The polygon
/// need not be simple. Regions around which the polygon runs clockwise count as negative area. So
/// the sign is Positive if the counter-clockwise area exceeds the clockwise area. It is Zero if
/// both areas are equal, as for a symmetric bow-tie. Reversing the list of points flips the sign.
/// Rotating the list keeps the sign. Cost for n corners: O(n) operations on doubles if the filter
/// decides, otherwise O(n) exact terms.
Sign polygon_area_sign(const PointTable2& points, std::span<const std::uint32_t> polygon);

/// Returns twice the exact signed area. Requires a polygon that is not empty.
Rational twice_polygon_area(const PointTable2& points, std::span<const std::uint32_t> polygon);

// The points of an arrangement are numbered as follows: input point i has the index i, and crossing
// k has the index inputs.size() + k. Such an index is called a dense index. A line is always given
// by two input points, never by crossings. Therefore the degree of a predicate does not grow with
// the number of constructions.

/// Input points, and crossings of lines through input points.
struct PlanePoints {
  PointTable2 inputs;                ///< The input points.
  std::vector<Crossing2> crossings;  ///< Crossings of lines through points of `inputs`.

  std::size_t size() const { return inputs.size() + crossings.size(); }
};

/// A read-only view of PlanePoints, or of a PointTable2 (without crossings). The view is valid
/// until the viewed object changes.
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

/// Compares two points, which may be input points or crossings, lexicographically (x, then y).
Sign compare_xy(const PlanePointsView& points, std::uint32_t i, std::uint32_t j);
/// Compares a crossing p, which need not be in the table, with point i lexicographically.
Sign compare_xy(const PlanePointsView& points, const Crossing2& p, std::uint32_t i);

/// Compares two points by x alone.
Sign compare_x(const PlanePointsView& points, std::uint32_t i, std::uint32_t j);
/// Compares a crossing p, which need not be in the table, with point i by x alone.
Sign compare_x(const PlanePointsView& points, const Crossing2& p, std::uint32_t i);

/// Returns the side of a line on which point i lies: Positive if it lies to the left. The line is
/// directed from input point a to input point b. Point i may be an input point or a crossing.
inline Sign orient2d(const PlanePointsView& points, std::uint32_t a, std::uint32_t b,
                     std::uint32_t i) {
  return points.is_input(i) ? orient2d(points.inputs(), a, b, i)
                            : orient2d(points.inputs(), a, b, points.crossing(i));
}

/// Returns the exact coordinates of an input point or a crossing.
RationalPoint2 exact(const PlanePointsView& points, std::uint32_t i);

/// Returns approximate coordinates. For an input point, these are the nearest doubles. For a
/// crossing, they are the stored approximation, which is not correctly rounded.
inline Point2 approx(const PlanePointsView& points, std::uint32_t i) {
  if (points.is_input(i)) return points.inputs().approx(i);
  return {points.crossing(i).x, points.crossing(i).y};
}

}  // namespace plumb
#pragma GCC visibility pop
