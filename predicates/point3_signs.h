// Signs about points of space, input and constructed, on the frame too. Every answer is exact.
//
// Ladder: identity -> rung::*_filter on the cached boxes -> fixed widths -> mpz.
// Cost: identity ~2 ns, filter 5-12 ns, fixed 100-400 ns for full mantissas, mpz 3-10 us.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "plumb/predicates/plane_exact.h"
#include "plumb/predicates/point3_table.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/rung_counters.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The side of the (canonical) plane: the sign of n.x + d. Positive: where its corners are seen
/// counter-clockwise. `incident`: further planes the caller knows to hold x (the facets around a
/// vertex); a query for one of them, for a defining plane, or for a wall of two of them is Zero
/// without arithmetic. Degree 9, of an input point 3.
/// Identity by defining planes comes first; the others only when the filter cannot tell, because
/// it never can on a plane through x, and reads fewer cache lines.
Sign side(const Point3Table& points, SpacePoint x, PlaneId plane,
          std::span<const PlaneId> incident = {});

/// Is the plane known to hold x by identity alone?
bool is_known_on(const Point3Table& points, SpacePoint x, PlaneId plane,
                 std::span<const PlaneId> incident = {});

/// The order of two points along coordinate axis 0, 1 or 2: the sign of x - y. Degree 13.
Sign compare_axis(const Point3Table& points, SpacePoint x, SpacePoint y, std::size_t axis);

/// Lexicographic order (x, then y, then z).
/// Identity: compare_xyz(x, y) = -compare_xyz(y, x); Zero exactly when equal(x, y).
Sign compare_xyz(const Point3Table& points, SpacePoint x, SpacePoint y);

/// Are they the same point? Boxes, then fingerprints tell different points apart; equal ones are
/// confirmed: one point's three planes on the other.
bool equal(const Point3Table& points, SpacePoint x, SpacePoint y);

/// The sign of y - x along n_p x n_q for two points on the line of p and q (of parallel planes: Zero):
/// boxes, then a plane that defines y and cuts the line, degree 9.
Sign order_along_line(const Point3Table& points, PlaneId p, PlaneId q, SpacePoint x, SpacePoint y);

/// Equal points have equal fingerprints, however they are defined.
Fingerprint fingerprint(const Point3Table& points, SpacePoint x);

/// Of many points, each as above, by one inversion for some hundred. Cost: ~40 ns an input point in place of ~250.
std::vector<Fingerprint> fingerprints(const Point3Table& points, std::span<const SpacePoint> x);

/// (x w, y w, z w, w) with w > 0, maybe with a common factor. Requires !points.depends_on_frame(x). Cost: of a constructed point
/// ~0.5 us, a tenth of exact().
IntegerRow homogeneous(const Point3Table& points, SpacePoint x);

/// The exact coordinates, for output. Requires !points.depends_on_frame(x).
RationalPoint3 exact(const Point3Table& points, SpacePoint x);

/// The exact coordinates of any point: finite + infinite R.
struct FramedPoint3 {
  RationalPoint3 finite;    ///< P0 of P0 + u R
  RationalPoint3 infinite;  ///< u of P0 + u R
};
/// The point, with or without a part that grows with R.
FramedPoint3 exact_parts(const Point3Table& points, SpacePoint x);

/// The rungs; W: exact3::Narrow, Medium, Wide. A fixed rung is Unsure when its operands do not fit.
namespace rung {

/// |n| <= 1: the value is off by normal_error |x|_1 + offset_error for an input point (rounding
/// included, see PlaneRow) and by 3 radius more for a box; 4 radius pays for its roundings.
inline FilteredSign side_filter(const PointBox& x, const PlaneRow& plane) {
  const auto& m = x.mid;
  const double value = plane.n[0] * m[0] + plane.n[1] * m[1] + plane.n[2] * m[2] + plane.d;
  const double size =
      (m[0] < 0 ? -m[0] : m[0]) + (m[1] < 0 ? -m[1] : m[1]) + (m[2] < 0 ? -m[2] : m[2]);
  const double error = static_cast<double>(plane.normal_error) * size +
                       (static_cast<double>(plane.offset_error) + 4 * x.radius);
  if (value > error) return FilteredSign::Positive;
  return value < -error ? FilteredSign::Negative : FilteredSign::Unsure;
}

FilteredSign compare_axis_filter(const PointBox& x, const PointBox& y, std::size_t axis);

/// Of points of the frame (one of them at least), by their directions (frame_filters.h). With
/// 0 for the larger part of a difference it goes on to the smaller one.
FilteredSign far_side_filter(const Point3Table& points, SpacePoint x, PlaneId plane);
FilteredSign far_compare_axis_filter(const Point3Table& points, SpacePoint x, SpacePoint y,
                                     std::size_t axis);
/// Where the part with R is 0.
FilteredSign near_side_filter(const Point3Table& points, SpacePoint x, PlaneId plane);

template <class W>
FilteredSign side_fixed(const Point3Table& points, SpacePoint x, PlaneId plane);
template <class W>
FilteredSign compare_axis_fixed(const Point3Table& points, SpacePoint x, SpacePoint y,
                                std::size_t axis);

Sign side_big(const Point3Table& points, SpacePoint x, PlaneId plane);
Sign compare_axis_big(const Point3Table& points, SpacePoint x, SpacePoint y, std::size_t axis);

/// Identity, then fixed widths, then mpz.
Sign side_without_filter(const Point3Table& points, SpacePoint x, PlaneId plane,
                         std::span<const PlaneId> incident);

}  // namespace rung

inline Sign side(const Point3Table& points, SpacePoint x, PlaneId plane,
                 std::span<const PlaneId> incident) {
  if (!x.is_input() && points.source(x).has_plane(plane)) {
    count_rung(Predicate::SideOfPlane, Rung::Identity);
    return Sign::Zero;
  }
  const FilteredSign s = rung::side_filter(points.box(x), points.planes().row(plane));
  if (is_decided(s)) return decide(Predicate::SideOfPlane, Rung::Filter, s);
  return rung::side_without_filter(points, x, plane, incident);
}

}  // namespace plumb
#pragma GCC visibility pop
