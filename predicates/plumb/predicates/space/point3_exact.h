// Exact homogeneous coordinates of the points of a Point3Table, in fixed widths and mpz, and the
// forms that compare them. The notation and limits (L) are those of plane_exact.h.
//
// Every kind of point meets the bounds of the three-plane point, |x| < 2^(O+2M-5), |w| < 2^(3M-6):
//   three planes   plane_exact.h
//   line x plane   with s(y) = n.y + d: x = a s(b) - b s(a), w = s(b) - s(a).
//                  |s| < 3 2^(M-3) 2^b + 2^(O-2) < 2^(O-1) for (N,D,b) = (1,2,29), (2,3,61),
//                  (4,6,125), |x| < 2^(b+O), |w| < 2^O
//   input          x = X, w = 1
//
// Parts of a point x = P0 + P1 R (plane_exact.h). Of a line through a plane of the frame: s(y) =
// s0(y) + d R with the same d for all y, so that w has no R and P1 = (a - b) d, on scale 0. A point
// that does not depend on the frame has P1 = 0.
#pragma once

#include <array>
#include <optional>
#include <type_traits>

#include "plumb/predicates/arithmetic/nearest_quotient.h"
#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/space/plane_exact.h"
#include "plumb/predicates/space/point3_table.h"
#include "plumb/predicates/space/rounded_point3.h"

namespace plumb::exact3 {

/// A point about to be loaded.
struct PointOperand {
  std::array<Operand, 3> planes;  ///< the first plane_count are set
  std::size_t plane_count = 0;
  std::array<const Point3*, 2> ends = {};  ///< of the line; or twice the input point
  Grid grid;                               ///< of the ends
  int width = 0;
};

/// Does the point depend on the frame?
bool has_frame(const PointOperand& operand);

/// The same point as that of a line and a plane, if two of its planes go through two common input
/// points, as those of neighbours in a mesh do, and the third is not of the frame: fewer and
/// smaller products. Else the source itself.
PointSource as_line(const PlaneTable& planes, const PointSource& source);

/// Of as_line(source).
PointOperand operand(const Point3Table& points, const PointSource& source);
PointOperand operand(const Point3Table& points, SpacePoint point);

/// The least width that can hold coordinates of so many bits.
int width_of_bits(int bits);

/// Loads in the number types of Plane = FixedPlane<W> or BigPlane. Requires operand.width to be at
/// most that of W. Returns false when a common scale breaks (L).
template <class Plane>
bool load_point(const PointOperand& operand, Part part, PointOf<Plane>& point);

template <class Plane>
Plane load_as(const Operand& operand, Part part);

/// Sign of n.x + d (times w^2): the side of the point on the plane; Unsure when a scale breaks (L).
template <class Plane>
FilteredSign side_sign(PointOf<Plane> point, Plane plane);

/// The order of two points along an axis: the sign of x - y; Unsure as above.
template <class Plane>
FilteredSign axis_order(const PointOf<Plane>& x, const PointOf<Plane>& y, std::size_t axis);

// (Instantiated in point3_exact.cpp for the four plane types.)

/// A part of the exact point as integers (x, y, z, w) on one scale.
IntegerRow integer_row(const PointOperand& operand, Part part = Part::Finite);

/// The fingerprint of a point whose residues are all zero: of (P0, P1, w) without a common factor.
Fingerprint primitive_fingerprint(const PointOperand& operand);

/// Calls question<Plane>() -> FilteredSign from the narrowest type allowed to mpz, which decides;
/// `count(rung)` is told which one did.
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

// The nearest doubles to the point of a source.
namespace plumb::exact3 {

/// `clear`: nearest doubles to coordinates that are none, 0 for others. For those a plane through
/// input points or a line has to have one coordinate, or nothing is returned.
std::optional<RoundedPoint3> with_coordinates_across(std::array<double, 3> clear,
                                                     const PlaneTable& planes,
                                                     const PointSource& source);

/// What some 100 bits tell of a line and a plane through input points, or of three planes that are
/// so too (as_line()); nothing for other sources. Cost: ~120 ns. Conditions:
/// rung::rounded_filter().
std::optional<RoundedPoint3> rounded_on_line(const PlaneTable& planes, const PointSource& source);

/// Of the point of a source that does not depend on the frame: what rung::rounded_fixed() finds.
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
