// Shows that a closed mesh is star-shaped around a point o, which proves that it is embedded.
//
// Two facts are tested: o lies strictly on the inner side of the plane of every facet, and one ray
// from o meets exactly one facet. Then the radial projection to a sphere around o is one to one:
//
// The projection of each facet is one to one and keeps its orientation. The two facets at an edge
// run oppositely along it, so their projections lie on both sides of the edge. Hence the number of
// facets above a direction does not change across edges; it is 1 above all directions except the
// directions of edges and vertices. If two facets had a common point x in the interior of one of
// them, two facets would lie above some directions near the direction of x. If x is inside an edge
// of one of them, the two facets at this edge cover all directions near x, so the other facet is
// one of these two. Else x is a vertex of both, and it is the same vertex, as vertices have
// different places. So facets meet in common vertices and edges only. A second component, or a
// second ring of facets around a vertex, would lie above some directions, too.
//
// Every comparison is a filter with an error bound or an exact predicate; if a filter does not
// decide, the mesh is not seen to be star-shaped, which costs time only. A vertex that is not an
// input point is a box of doubles around the vertex, and what the box does not decide, is not
// decided. The mean of the vertices is rounded, which does not matter: o may be any point of
// doubles. It may be moved by less than any distance, too, as it is strictly inside; so the ray
// need not meet edges.
//
// Tested by tests/space/star_shape_test.cpp.

#include "plumb/space/mesh/star_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb {
namespace {

/// Tests one mesh.
class StarTest {
 public:
  StarTest(const MeshFacets& facets, std::span<const SpacePoint> point, const Point3Table& points)
      : facets_(facets), point_(point), points_(points), planes_(points.planes()) {}

  Sign run() {
    if (!find_centre()) return Sign::Zero;
    const Sign orientation = common_orientation();
    if (orientation == Sign::Zero || !is_hit_once(orientation)) return Sign::Zero;
    return orientation;
  }

 private:
  PointBox place(std::uint32_t v) const { return points_.box(point_[v]); }

  /// Sets the centre to a mean of the vertices, with weights from 1 to 65/64. The true centre of a
  /// symmetric mesh is level with vertices, and boxes would not tell which of them are above it.
  /// Returns false if the centre is not finite.
  bool find_centre() {
    Point3 sum;
    double weights = 0;
    for (std::uint32_t v = 0; v < point_.size(); ++v) {
      const double weight = 1 + static_cast<double>(v * 2654435769U) * 0x1p-38;
      const PointBox p = place(v);
      sum = {sum.x + weight * p.mid[0], sum.y + weight * p.mid[1], sum.z + weight * p.mid[2]};
      weights += weight;
    }
    centre_ = {sum.x / weights, sum.y / weights, sum.z / weights};
    return std::isfinite(centre_.x) && std::isfinite(centre_.y) && std::isfinite(centre_.z);
  }

  /// Returns the common sign of the volumes of the cones from the centre over all facets. Returns
  /// Zero if they differ or are not known. The inner side of a facet is the negative side if its
  /// jump is -1.
  Sign common_orientation() const {
    const PointBox centre{{centre_.x, centre_.y, centre_.z}, 0};
    Sign common = Sign::Zero;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const std::int32_t jump = facets_.jump[f];
      const FilteredSign side = rung::side_filter(centre, planes_.row(facets_.plane[f]));
      if (!is_decided(side) || side == FilteredSign::Zero || (jump != 1 && jump != -1)) {
        return Sign::Zero;
      }
      const Sign own = static_cast<Sign>(static_cast<int>(side) * jump);
      if (f > 0 && own != common) return Sign::Zero;
      common = own;
    }
    return common;
  }

  /// Whether the ray from the centre along x meets exactly one facet. It can only meet facets whose
  /// normal away from the centre has a positive x component. Returns false if a facet that would be
  /// met is nearly parallel to the ray, or if it is not known whether one is met.
  bool is_hit_once(Sign orientation) const {
    std::size_t hits = 0;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const PlaneRow& row = planes_.row(facets_.plane[f]);
      const double side = static_cast<int>(orientation) * facets_.jump[f];
      const auto error = static_cast<double>(row.normal_error);
      if (side * row.n[0] > error) continue;
      const std::optional<bool> is_hit = surrounds_ray(facets_.corners(f));
      if (!is_hit) return false;
      if (!*is_hit) continue;
      if (!(side * row.n[0] < -error)) return false;
      ++hits;
    }
    return hits == 1;
  }

  /// Whether a polygon, seen along x, surrounds the ray: an odd number of its sides runs past it.
  /// So that the ray meets neither vertices nor edges, it is thought to be moved a little along z,
  /// and by much less along y: ends of sides that are level with it are below, and it lies to the
  /// left of sides through it that run up. Nothing if it is not known.
  std::optional<bool> surrounds_ray(std::span<const std::uint32_t> corners) const {
    bool is_inside = false;
    PointBox from = place(corners.back());
    std::optional<bool> is_from_above = is_above(from);
    for (const std::uint32_t corner : corners) {
      const PointBox to = place(corner);
      const std::optional<bool> is_to_above = is_above(to);
      if (!is_from_above || !is_to_above) return std::nullopt;
      if (*is_to_above != *is_from_above) {
        const std::optional<Sign> turn = turn_at_centre(from, to);
        if (!turn) return std::nullopt;
        const Sign left = *is_to_above ? Sign::Positive : Sign::Negative;
        if (turn == Sign::Zero || turn == left) is_inside = !is_inside;
      }
      from = to;
      is_from_above = is_to_above;
    }
    return is_inside;
  }

  /// Whether y of a vertex is greater than y of the centre. Returns nothing if the box does not
  /// decide. The difference is rounded, so it must be at least twice the radius.
  std::optional<bool> is_above(const PointBox& p) const {
    if (p.radius == 0) return p.mid[1] > centre_.y;
    const double y = p.mid[1] - centre_.y;
    if (!(std::fabs(y) > 2 * p.radius)) return std::nullopt;
    return y > 0;
  }

  /// Returns the sign of the turn from one vertex to another around the centre, seen along x.
  /// Nothing if the boxes do not tell. With all differences from the centre at most m and radii at
  /// most r <= m, the determinant has an error of less than 6.1 m r + 11 u m^2, u = 2^-53, if
  /// nothing underflows, and what does is far below the smallest normal number.
  std::optional<Sign> turn_at_centre(const PointBox& from, const PointBox& to) const {
    if (from.radius == 0 && to.radius == 0) {
      return orient2d(Point2{from.mid[1], from.mid[2]}, Point2{to.mid[1], to.mid[2]},
                      Point2{centre_.y, centre_.z});
    }
    const double ay = from.mid[1] - centre_.y, az = from.mid[2] - centre_.z;
    const double by = to.mid[1] - centre_.y, bz = to.mid[2] - centre_.z;
    const double m = std::max({std::fabs(ay), std::fabs(az), std::fabs(by), std::fabs(bz)});
    const double r = std::max(from.radius, to.radius);
    if (!(r <= m)) return std::nullopt;
    const double turn = ay * bz - az * by;
    const double bound = 8 * m * (r + 0x1p-51 * m) + std::numeric_limits<double>::min();
    if (turn > bound) return Sign::Positive;
    if (turn < -bound) return Sign::Negative;
    return std::nullopt;
  }

  const MeshFacets& facets_;
  const std::span<const SpacePoint> point_;
  const Point3Table& points_;
  const PlaneTable& planes_;
  Point3 centre_;
};

}  // namespace

Sign star_orientation(const MeshFacets& facets, std::span<const SpacePoint> point,
                      const Point3Table& points) {
  return StarTest(facets, point, points).run();
}

}  // namespace plumb
