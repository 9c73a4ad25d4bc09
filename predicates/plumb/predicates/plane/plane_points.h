// Signed area of closed polygons, simple or not.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Sign of the signed area enclosed by the closed polygon through the given points: Positive when
/// it winds counter-clockwise on balance, Zero for instance for a symmetric bow-tie. Reversal flips
/// the sign, rotation of the list keeps it. O(n) doubles when the filter decides, else O(n) exact
/// terms.
Sign polygon_area_sign(const PointTable2& points, std::span<const std::uint32_t> polygon);

/// Twice the signed area, exactly.
Rational twice_polygon_area(const PointTable2& points, std::span<const std::uint32_t> polygon);

// The points of an arrangement: input points, and crossings of lines through input points, under
// one numbering.
//
// Dense index: input point i is i, crossing k is inputs.size() + k. Lines are named by two input
// points, never by crossings, so predicates have the same degree however a point came about.

struct PlanePoints {
  PointTable2 inputs;
  std::vector<Crossing2> crossings;  ///< between lines through points of `inputs`

  std::size_t size() const { return inputs.size() + crossings.size(); }
};

/// Read-only view of PlanePoints, or of a table alone. Valid as long as what it views is unchanged.
class PlanePointsView {
 public:
  PlanePointsView(const PointTable2& inputs) : inputs_(&inputs) {}
  PlanePointsView(const PlanePoints& points)
      : inputs_(&points.inputs), crossings_(points.crossings) {}

  std::size_t size() const { return inputs_->size() + crossings_.size(); }
  const PointTable2& inputs() const { return *inputs_; }
  bool is_input(std::uint32_t i) const { return i < inputs_->size(); }
  /// Requires !is_input(i).
  const Crossing2& crossing(std::uint32_t i) const { return crossings_[i - inputs_->size()]; }

 private:
  const PointTable2* inputs_;
  std::span<const Crossing2> crossings_;
};

/// Lexicographic order of two points, in any kind.
Sign compare_xy(const PlanePointsView& points, std::uint32_t i, std::uint32_t j);
Sign compare_xy(const PlanePointsView& points, const Crossing2& p, std::uint32_t i);

/// Order by x alone.
Sign compare_x(const PlanePointsView& points, std::uint32_t i, std::uint32_t j);
Sign compare_x(const PlanePointsView& points, const Crossing2& p, std::uint32_t i);

/// Side of the line through input points a -> b on which point i, of any kind, lies: Positive =
/// left.
inline Sign orient2d(const PlanePointsView& points, std::uint32_t a, std::uint32_t b,
                     std::uint32_t i) {
  return points.is_input(i) ? orient2d(points.inputs(), a, b, i)
                            : orient2d(points.inputs(), a, b, points.crossing(i));
}

RationalPoint2 exact(const PlanePointsView& points, std::uint32_t i);

/// The nearest doubles of an input point; of a crossing, its approximation (not correctly rounded).
inline Point2 approx(const PlanePointsView& points, std::uint32_t i) {
  if (points.is_input(i)) return points.inputs().approx(i);
  return {points.crossing(i).x, points.crossing(i).y};
}

}  // namespace plumb
#pragma GCC visibility pop
