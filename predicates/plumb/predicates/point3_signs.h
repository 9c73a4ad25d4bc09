// Predicates on points of space: input points, constructed points and points of the frame
// (docs/design/frame.md). Every result is exact.
//
// The stages are identity (of ids), the filters in namespace rung, fixed-width integers, and GMP
// integers. The filters use boxes: the table stores a small box around each point, with doubles as
// coordinates. The page docs/design/numbers.md proves the error bounds and the degrees. Cost:
// identity takes about 2 ns, and a filter takes 5 to 12 ns. A stage of fixed width takes 100 to 400
// ns for coordinates with full mantissas. GMP takes 3 to 10 us.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/space/plane_exact.h"
#include "plumb/predicates/space/point3_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the side of the canonical plane on which x lies, which is the sign of n.x + d. The sign
/// is Positive if x lies on the side from which three input points that define the plane appear
/// counter-clockwise. In `incident`, the caller can list further planes that are known to contain
/// x, such as the planes of the facets at a vertex. In three cases, the result is Zero without
/// arithmetic: `plane` is one of the planes that define x; `plane` is in `incident`; or `plane` is
/// a wall through the common line of two of these planes. The degree in input coordinates is 3 if x
/// is an input point, and 9 otherwise.
///
/// The planes that define x are compared with `plane` before the filter runs. The other two cases
/// are tested only after the filter has returned Unsure. This order misses no case, because the
/// filter returns Unsure for every plane through x. The order saves time, because the filter reads
/// fewer cache lines than the tests of these cases.
Sign side(const Point3Table& points, SpacePoint x, PlaneId plane,
          std::span<const PlaneId> incident = {});

/// Whether the ids alone prove that the plane contains x. The plane may contain x even if the
/// result is false.
bool is_known_on(const Point3Table& points, SpacePoint x, PlaneId plane,
                 std::span<const PlaneId> incident = {});

/// Compares the coordinates of x and y on the given axis (0, 1 or 2): Negative if the coordinate of
/// x is less. The degree in input coordinates is at most 13.
Sign compare_axis(const Point3Table& points, SpacePoint x, SpacePoint y, std::size_t axis);

/// Compares two points lexicographically (x, then y, then z). Swapping x and y flips the sign. The
/// result is Zero if and only if equal(x, y) is true.
Sign compare_xyz(const Point3Table& points, SpacePoint x, SpacePoint y);

/// Whether x and y are the same point. If the boxes of the points are disjoint, the points differ;
/// this decides most pairs. If the boxes intersect, the fingerprints are compared. If the
/// fingerprints are equal, an exact test confirms that the three planes of one point contain the
/// other point.
bool equal(const Point3Table& points, SpacePoint x, SpacePoint y);

/// Returns the sign of y - x in the direction n_p x n_q: Positive if y comes after x. The result is
/// Zero if p and q are parallel. Requires that x and y lie on the line of p and q. If the boxes do
/// not decide, the function chooses a plane that defines y and crosses the line. Then it computes
/// on which side of this plane the point x lies. The degree in input coordinates is 9.
Sign order_along_line(const Point3Table& points, PlaneId p, PlaneId q, SpacePoint x, SpacePoint y);

/// Returns the fingerprint of a point. Equal points have equal fingerprints, even if their
/// definitions differ. Cost: about 250 ns, mostly one modular inversion.
Fingerprint fingerprint(const Point3Table& points, SpacePoint x);

/// Returns the fingerprints of many points: result[i] = fingerprint(points, x[i]). 256 points share
/// one modular inversion, so that an input point takes about 40 ns instead of about 250 ns.
std::vector<Fingerprint> fingerprints(const Point3Table& points, std::span<const SpacePoint> x);

/// Returns four integers (w X, w Y, w Z, w) with w > 0 for the point x = (X, Y, Z). The integers
/// may have a common factor. Requires !points.depends_on_frame(x). Cost: about 0.5 us for a
/// constructed point, which is a tenth of the cost of exact().
IntegerRow homogeneous(const Point3Table& points, SpacePoint x);

/// Returns the exact coordinates of x, for output. Requires !points.depends_on_frame(x).
RationalPoint3 exact(const Point3Table& points, SpacePoint x);

/// The exact coordinates of any point, as the sum finite + infinite * R. R stands for the
/// half-width of the frame, which is larger than every number.
struct FramedPoint3 {
  RationalPoint3 finite;    ///< The part without R.
  RationalPoint3 infinite;  ///< The factor of R; zero if the point does not depend on the frame.
};
/// Returns the exact coordinates of x, which may be a point of the frame.
FramedPoint3 exact_parts(const Point3Table& points, SpacePoint x);

/// The stages of the predicates. Tests and benchmarks can call each stage on its own. W is
/// exact3::Narrow, Medium or Wide. A stage of fixed width returns Unsure if its operands do not fit
/// the width.
namespace rung {

/// Evaluates n.x + d at the midpoint of the box. Returns the sign of the value if its magnitude
/// exceeds the error bound. Otherwise returns Unsure. For an input point x, the error, including
/// rounding errors, is at most normal_error * |x|_1 + offset_error (see PlaneRow). Here |x|_1 is
/// the sum of the magnitudes of the coordinates. For a box, the error grows by at most 3 * radius,
/// since each |n[i]| <= 1. The bound adds 4 * radius, which also covers the rounding of the bound
/// itself.
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

/// Returns the sign of x - y along `axis` if the boxes are disjoint along this axis. Otherwise
/// returns Unsure.
FilteredSign compare_axis_filter(const PointBox& x, const PointBox& y, std::size_t axis);

/// Filters for points that depend on the frame. These filters return Unsure if none of the given
/// points depends on the frame. A point of the frame is a sum finite + infinite * R (FramedPoint3).
/// The filters compute with the vectors `infinite` (filter_stages.h). If component `axis` of this
/// vector is zero for both points, far_compare_axis_filter compares the parts without R.
FilteredSign far_side_filter(const Point3Table& points, SpacePoint x, PlaneId plane);
FilteredSign far_compare_axis_filter(const Point3Table& points, SpacePoint x, SpacePoint y,
                                     std::size_t axis);
/// Filter for the sign of c0, where n.x + d = c0 + c1 R for the plane and the point. Requires that
/// c1 is zero.
FilteredSign near_side_filter(const Point3Table& points, SpacePoint x, PlaneId plane);

template <class W>
FilteredSign side_fixed(const Point3Table& points, SpacePoint x, PlaneId plane);
template <class W>
FilteredSign compare_axis_fixed(const Point3Table& points, SpacePoint x, SpacePoint y,
                                std::size_t axis);

Sign side_big(const Point3Table& points, SpacePoint x, PlaneId plane);
Sign compare_axis_big(const Point3Table& points, SpacePoint x, SpacePoint y, std::size_t axis);

/// Decides on which side of the plane x lies, after side_filter has returned Unsure. The remaining
/// stages are the filter for points of the frame, the tests for further identities, fixed-width
/// integers, and GMP integers.
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
