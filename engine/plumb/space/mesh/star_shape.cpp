// Shows that a closed mesh is star-shaped around a point o, which proves that it is embedded.
//
// Two facts are tested: o lies strictly on the inner side of the plane of every facet, and one ray
// from o meets exactly one facet. Then the radial projection to a sphere around o is one to one:
//
// The projection of each facet is one to one and keeps its orientation. The two facets at an edge
// run oppositely along it, so their projections lie on both sides of the edge. Hence the number of
// facets above a direction does not change across edges; it is 1 above all directions except those
// of edges and vertices. If two facets had a common point x in the interior of one of them, two
// facets would lie above some directions near that of x. If x is inside an edge of one of them, the
// two facets at this edge cover all directions near x, so the other facet is one of these two. Else
// x is a vertex of both, and it is the same vertex, as vertices have different places. So facets
// meet in common vertices and edges only. A second component, or a second ring of facets around a
// vertex, would lie above some directions, too.
//
// Every comparison is a filter with an error bound or an exact predicate; if a filter does not
// decide, the mesh is not seen to be star-shaped, which costs time only. The mean of the vertices
// is rounded, which does not matter: o may be any point of doubles. It may be moved by less than
// any distance, too, as it is strictly inside; so the ray need not meet edges.
//
// Tested by tests/space/star_shape_test.cpp.

#include "plumb/space/mesh/star_shape.h"

#include <cmath>
#include <cstdint>

#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point3_signs.h"

namespace plumb {
namespace {

/// The test of one mesh.
class StarTest {
 public:
  StarTest(const MeshFacets& facets, std::span<const SpacePoint> point, const PlaneTable& planes)
      : facets_(facets), point_(point), planes_(planes) {}

  Sign run() {
    if (!find_centre()) return Sign::Zero;
    const Sign orientation = common_orientation();
    if (orientation == Sign::Zero || !is_hit_once(orientation)) return Sign::Zero;
    return orientation;
  }

 private:
  const Point3& place(std::uint32_t v) const { return planes_.point(point_[v].input()); }

  /// Sets the centre to the mean of the vertices. Returns false if one of them is no input point,
  /// or if the mean is not finite.
  bool find_centre() {
    Point3 sum;
    for (std::uint32_t v = 0; v < point_.size(); ++v) {
      if (!point_[v].is_input()) return false;
      const Point3& p = place(v);
      sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
    }
    const auto count = static_cast<double>(point_.size());
    centre_ = {sum.x / count, sum.y / count, sum.z / count};
    return std::isfinite(centre_.x) && std::isfinite(centre_.y) && std::isfinite(centre_.z);
  }

  /// Returns the sign that the volumes of the cones from the centre over all facets have; Zero if
  /// they differ or are not known. The inner side of a facet is the negative one if its jump is -1.
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

  /// Whether the ray from the centre along x meets exactly one facet. Only facets whose normal away
  /// from the centre runs along x can be met. False if one that would be met is nearly parallel to
  /// the ray.
  bool is_hit_once(Sign orientation) const {
    std::size_t hits = 0;
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      const PlaneRow& row = planes_.row(facets_.plane[f]);
      const double side = static_cast<int>(orientation) * facets_.jump[f];
      const auto error = static_cast<double>(row.normal_error);
      if (side * row.n[0] > error || !surrounds_ray(facets_.corners(f))) continue;
      if (!(side * row.n[0] < -error)) return false;
      ++hits;
    }
    return hits == 1;
  }

  /// Whether a polygon, seen along x, surrounds the ray: an odd number of its sides runs past it.
  /// So that the ray meets neither vertices nor edges, it is thought to be moved a little along z,
  /// and by much less along y: ends of sides that are level with it are below, and it lies to the
  /// left of sides through it that run up.
  bool surrounds_ray(std::span<const std::uint32_t> corners) const {
    bool is_inside = false;
    std::uint32_t from = corners.back();
    bool is_from_above = place(from).y > centre_.y;
    for (const std::uint32_t to : corners) {
      const bool is_to_above = place(to).y > centre_.y;
      if (is_to_above != is_from_above) {
        const Sign turn = orient2d(seen(place(from)), seen(place(to)), seen(centre_));
        const Sign left = is_to_above ? Sign::Positive : Sign::Negative;
        if (turn == Sign::Zero || turn == left) is_inside = !is_inside;
      }
      from = to;
      is_from_above = is_to_above;
    }
    return is_inside;
  }
  static Point2 seen(const Point3& p) { return {p.y, p.z}; }

  const MeshFacets& facets_;
  const std::span<const SpacePoint> point_;
  const PlaneTable& planes_;
  Point3 centre_;
};

}  // namespace

Sign star_orientation(const MeshFacets& facets, std::span<const SpacePoint> point,
                      const PlaneTable& planes) {
  return StarTest(facets, point, planes).run();
}

}  // namespace plumb
