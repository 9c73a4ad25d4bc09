// Exact homogeneous coordinates of the points of a Point3Table, in fixed widths and in integers of
// GMP, the forms that compare them, and their rounding to the nearest doubles. plane_exact.h
// explains the notation and the limits (L).
//
// Every kind of point obeys the bounds of the three-plane point, |x| < 2^(O+2M-5), |w| < 2^(3M-6):
//   three planes   plane_exact.h
//   line x plane   with s(y) = n.y + d: x = a s(b) - b s(a), w = s(b) - s(a).
//                  |s| < 3 2^(M-3) 2^b + 2^(O-2) < 2^(O-1) for (N,D,b) = (1,2,29), (2,3,61),
//                  (4,6,125), |x| < 2^(b+O), |w| < 2^O
//   input          x = X, w = 1
//
// Parts of a point x = P0 + P1 R (plane_exact.h). On a line through a plane of the frame,
// s(y) = s0(y) + d R with the same d for all y; so w has no R, and P1 = (a - b) d on scale 0. A
// point that does not depend on the frame has P1 = 0.
#pragma once

#include <array>
#include <optional>
#include <type_traits>

#include "plumb/predicates/arithmetic/nearest_quotient.h"
#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/space/plane_exact.h"
#include "plumb/predicates/space/point3_table.h"
#include "plumb/predicates/space/point_as_line.h"
#include "plumb/predicates/space/rounded_point3.h"

namespace plumb::exact3 {

/// A point before it is loaded.
struct PointOperand {
  std::array<Operand, 3> planes;           ///< Its planes; the first plane_count are set.
  std::size_t plane_count = 0;             ///< 3, 1 for a point on a line, 0 for an input point.
  std::array<const Point3*, 2> ends = {};  ///< The points of the line, or twice the input point.
  Grid grid;                               ///< The grid of the ends.
  int width = 0;                           ///< The least width that holds it, as Operand::width.
};

/// Whether the point depends on the frame.
bool has_frame(const PointOperand& operand);

/// Returns the operand of as_line(source).
PointOperand operand(const Point3Table& points, const PointSource& source);
/// Returns the operand of a point of any kind.
PointOperand operand(const Point3Table& points, SpacePoint point);

/// Returns a coordinate of a point.
inline double coordinate(const Point3& p, std::size_t axis) {
  return axis == 0 ? p.x : (axis == 1 ? p.y : p.z);
}

/// Whether a plane is orthogonal to an axis, as its definition shows: stored coefficients are 0, or
/// the corners have the same coordinate.
bool is_across(const PlaneTable& planes, PlaneId plane, std::size_t axis);

/// Returns the coordinate of all points of a plane if it is seen to be a double, as it is if the
/// plane has corners, or the equation x = d with a short number d. Requires is_across().
std::optional<double> coordinate_across(const PlaneTable& planes, PlaneId plane, std::size_t axis);

/// Returns a coordinate of a point that two of its planes determine together, if their definitions
/// show it to be a double: both go through the two input points of as_line(), which have the same
/// coordinate, or both are parallel to another axis and go through one input point.
std::optional<double> coordinate_along(const PlaneTable& planes, const PointSource& source,
                                       std::size_t axis);

/// Returns the least width that holds coordinates of so many bits.
int width_of_bits(int bits);

/// Loads a part of a point in the number types of Plane = FixedPlane<W> or BigPlane. Returns false
/// if a common scale breaks (L). Requires that operand.width is at most the width of W.
template <class Plane>
bool load_point(const PointOperand& operand, Part part, PointOf<Plane>& point);

/// Returns a part of a plane in the number types of Plane.
template <class Plane>
Plane load_as(const Operand& operand, Part part);

/// Returns the side of the point on the plane, the sign of (n.x + d w) w. Unsure if a common scale
/// breaks (L).
template <class Plane>
FilteredSign side_sign(PointOf<Plane> point, Plane plane);

/// Returns the order of two points along an axis, the sign of x - y. Unsure if a common scale
/// breaks (L).
template <class Plane>
FilteredSign axis_order(const PointOf<Plane>& x, const PointOf<Plane>& y, std::size_t axis);

// These are instantiated in point3_exact.cpp for the four plane types.

/// Returns a part of the exact point as integers (x, y, z, w) on one scale.
IntegerRow integer_row(const PointOperand& operand, Part part = Part::Finite);

/// Returns the fingerprint of a point whose residues are all zero. It is computed from (P0, P1, w)
/// after the common factor was removed.
Fingerprint primitive_fingerprint(const PointOperand& operand);

/// Calls question<Plane>() -> FilteredSign with plane types from the narrowest that `width` allows
/// to integers of any length, until one decides, and returns the sign. Calls `count` with the stage
/// that decides.
template <class Question, class Count>
Sign point_ladder(int width, const Question& question, const Count& count) {
  FilteredSign s = FilteredSign::Unsure;
  const auto tell = [&](Rung rung, FilteredSign sign) {
    if (is_decided(sign)) count(rung);
    return sign;
  };
  if (width <= Narrow::kIndex) {
    s = tell(Rung::Small, question.template operator()<FixedPlane<Narrow>>());
  }
  if (!is_decided(s) && width <= Medium::kIndex) {
    s = tell(Rung::Exact, question.template operator()<FixedPlane<Medium>>());
  }
  if (!is_decided(s) && width <= Wide::kIndex) {
    s = tell(Rung::Exact, question.template operator()<FixedPlane<Wide>>());
  }
  if (!is_decided(s)) s = tell(Rung::Big, question.template operator()<BigPlane>());
  return decided(s);
}

}  // namespace plumb::exact3

// The nearest doubles to a point.
namespace plumb::exact3 {

/// Returns the rounded point, given in `clear` the nearest doubles of coordinates that are known to
/// be no doubles, and 0 for the others. Each of the others must be shown by a plane across its axis
/// or by the line (coordinate_across(), coordinate_along()); if one is not, returns nothing.
std::optional<RoundedPoint3> with_coordinates_across(std::array<double, 3> clear,
                                                     const PlaneTable& planes,
                                                     const PointSource& source);

/// Returns the rounded point of a line and a plane through input points or across an axis, or of
/// three planes that define such a point (as_line()), as some 100 bits show it; nothing for other
/// sources, and under the conditions of rung::rounded_filter(). Cost: about 120 ns.
std::optional<RoundedPoint3> rounded_on_line(const PlaneTable& planes, const PointSource& source);

/// Returns the rounded point of exact coordinates, as rung::rounded_fixed(). Requires that the
/// point does not depend on the frame.
template <int X, int W>
std::optional<RoundedPoint3> rounded_fixed(const Homogeneous<Fixed<X>, Fixed<W>>& point,
                                           const PlaneTable& planes, const PointSource& source) {
  if (!rounds_to_nearest()) return {};
  const TwofoldScaled w = top_bits(point.w);
  std::array<double, 3> clear;
  for (std::size_t i = 0; i < 3; ++i) clear[i] = nearest_quotient(point.x[i], w, point.scale);
  return with_coordinates_across(clear, planes, source);
}

}  // namespace plumb::exact3
