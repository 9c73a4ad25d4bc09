// Predicates on points of space: input points, constructed points and points of the frame
// (docs/design/frame.md). Every result is exact.
//
// Stages: identity, the filters in namespace rung on the cached boxes, fixed-width integers, GMP
// integers. docs/design/numbers.md proves the bounds and the degrees.
// Cost: identity takes about 2 ns, a filter 5 to 12 ns, a fixed width 100 to 400 ns for coordinates
// with full mantissas, GMP 3 to 10 us.
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

/// Returns the side of the canonical plane on which x lies, the sign of n.x + d: Positive on the
/// side from which three input points that define the plane appear counter-clockwise. `incident`
/// lists further planes that the caller knows to contain x, such as those of the facets around a
/// vertex. The result is Zero without arithmetic if `plane` is one of them, defines x, or is a wall
/// of two such planes. The degree in input coordinates is 9, for an input point 3.
///
/// Defining planes are tested before the filter. The other identities are tested only if the filter
/// returns Unsure: it always does so for a plane through x, and it reads fewer cache lines than
/// they do.
Sign side(const Point3Table& points, SpacePoint x, PlaneId plane,
          std::span<const PlaneId> incident = {});

/// Whether ids alone prove that the plane contains x. A result of false proves nothing.
bool is_known_on(const Point3Table& points, SpacePoint x, PlaneId plane,
                 std::span<const PlaneId> incident = {});

/// Returns the sign of x - y along coordinate axis 0, 1 or 2. The degree in input coordinates is at
/// most 13.
Sign compare_axis(const Point3Table& points, SpacePoint x, SpacePoint y, std::size_t axis);

/// Compares two points lexicographically (x, then y, then z). compare_xyz(x, y) is the negative of
/// compare_xyz(y, x), and it is Zero if and only if equal(x, y).
Sign compare_xyz(const Point3Table& points, SpacePoint x, SpacePoint y);

/// Whether x and y are the same point. Boxes distinguish most different points, fingerprints the
/// rest. Equal fingerprints are confirmed: the three planes of one point must contain the other.
bool equal(const Point3Table& points, SpacePoint x, SpacePoint y);

/// Returns the sign of y - x along n_p x n_q, Positive if y comes after x; Zero if p and q are
/// parallel. Requires that x and y lie on the line of p and q. If the boxes do not decide, it takes
/// the side of x on a plane that defines y and crosses the line, which has degree 9.
Sign order_along_line(const Point3Table& points, PlaneId p, PlaneId q, SpacePoint x, SpacePoint y);

/// Returns the fingerprint of a point. Equal points have equal fingerprints, however they are
/// defined. Cost: about 250 ns, mostly one modular inversion.
Fingerprint fingerprint(const Point3Table& points, SpacePoint x);

/// Returns the fingerprints of many points: result[i] = fingerprint(points, x[i]). One inversion
/// serves 256 points, so that an input point takes about 40 ns instead of about 250 ns.
std::vector<Fingerprint> fingerprints(const Point3Table& points, std::span<const SpacePoint> x);

/// Returns the homogeneous coordinates (x w, y w, z w, w) with w > 0, possibly with a common
/// factor. Requires !points.depends_on_frame(x). Cost: about 0.5 us for a constructed point, a
/// tenth of exact().
IntegerRow homogeneous(const Point3Table& points, SpacePoint x);

/// Returns the exact coordinates, for output. Requires !points.depends_on_frame(x).
RationalPoint3 exact(const Point3Table& points, SpacePoint x);

/// The exact coordinates finite + infinite R of any point, where R is the unbounded half-width of
/// the frame.
struct FramedPoint3 {
  RationalPoint3 finite;    ///< The part without R.
  RationalPoint3 infinite;  ///< The factor of R; zero if the point does not depend on the frame.
};
/// Returns the exact coordinates of x, whether or not it depends on the frame.
FramedPoint3 exact_parts(const Point3Table& points, SpacePoint x);

/// The stages, callable on their own. W is exact3::Narrow, Medium or Wide. A stage of fixed width
/// returns Unsure if its operands do not fit the width.
namespace rung {

/// Returns the sign of n.x + d at the midpoint of the box if it exceeds the error bound, otherwise
/// Unsure. Since each |n[i]| <= 1, the value of an input point has an error of at most
/// normal_error |x|_1 + offset_error, rounding included (see PlaneRow). A box adds at most 3
/// radius; the bound takes 4 radius, which also covers the rounding of the bound.
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

/// Returns the sign of x - y along `axis` if the boxes are disjoint along it, otherwise Unsure.
FilteredSign compare_axis_filter(const PointBox& x, const PointBox& y, std::size_t axis);

/// Filters for points that depend on the frame; Unsure if no argument point does. They evaluate the
/// parts with R, that is the directions of the points (filter_stages.h). If the parts with R of
/// both points are zero along `axis`, far_compare_axis_filter compares the parts without R.
FilteredSign far_side_filter(const Point3Table& points, SpacePoint x, PlaneId plane);
FilteredSign far_compare_axis_filter(const Point3Table& points, SpacePoint x, SpacePoint y,
                                     std::size_t axis);
/// Filters the part without R. Requires that the part with R is zero.
FilteredSign near_side_filter(const Point3Table& points, SpacePoint x, PlaneId plane);

template <class W>
FilteredSign side_fixed(const Point3Table& points, SpacePoint x, PlaneId plane);
template <class W>
FilteredSign compare_axis_fixed(const Point3Table& points, SpacePoint x, SpacePoint y,
                                std::size_t axis);

Sign side_big(const Point3Table& points, SpacePoint x, PlaneId plane);
Sign compare_axis_big(const Point3Table& points, SpacePoint x, SpacePoint y, std::size_t axis);

/// Decides the side with the stages that remain if side_filter returns Unsure: the filter for
/// points of the frame, the other identities, fixed widths, GMP.
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
