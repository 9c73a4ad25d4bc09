// The exact test of two triangles, and boxes of directions.
//
// By the number of common corners (docs/design/meshes.md, "Does the mesh meet itself?"):
//   0, two planes   the triangles meet along a piece of the planes' common line whose ends are
//                   where a side of one meets the other; so it is enough to test sides against
//                   triangles
//   0, one plane    convex polygons are apart if and only if the line of a side separates them
//   1               both triangles are cones near the vertex, within their sectors; they meet
//                   elsewhere if and only if the sectors have another direction in common
//   2               in different planes they share the line of the edge only; in one plane they
//                   overlap if and only if both lie on the same side of it
//   3               they are one triangle of two facets: they overlap
//
// All signs are exact: orient3d and orient2d of input points, rationals for constructed ones. Boxes
// of directions are computed in doubles with a bound for their errors.
//
// Tested by tests/space/mesh_crossings_test.cpp.

#include "plumb/space/mesh/triangle_crossing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/space/planar/triangulate.h"

namespace plumb {
namespace {

using Corner = TriangleCorner;
using Triangle = FacetTriangle;

constexpr std::size_t next(std::size_t i) { return i == 2 ? 0 : i + 1; }

/// Exact signs about corners. Constructed points (vertices with fractions for coordinates) are
/// converted to rationals.
class CornerSigns {
 public:
  explicit CornerSigns(const Point3Table& points) : points_(points) {}

  Sign side_of(const Corner& c, const Triangle& t) const { return side(points_, c.point, t.plane); }

  /// Returns the sign of the turn from p to q around a b. It is Positive if the turn is
  /// counter-clockwise, seen from a. Requires that a b crosses the plane of p and q, and is not
  /// parallel to it.
  Sign pass(const Corner& a, const Corner& b, const Corner& p, const Corner& q) const {
    if (are_inputs(a, b) && are_inputs(p, q)) return orient3d(at(a), at(b), at(p), at(q));
    return orient3d(exact_at(a), exact_at(b), exact_at(p), exact_at(q));
  }

  /// Returns the turn of three points of a plane, seen from its positive side.
  Sign turn(PlaneId plane, const Corner& a, const Corner& b, const Corner& c) const {
    const FlatView view = FlatView::of_plane(points_.planes(), plane);
    if (are_inputs(a, b) && c.point.is_input()) {
      return orient2d(flat(at(a), view), flat(at(b), view), flat(at(c), view));
    }
    return orient2d(flat(exact_at(a), view), flat(exact_at(b), view), flat(exact_at(c), view));
  }

  /// Whether two triangles of one plane have a common point. Convex polygons are apart if and only
  /// if one is strictly beyond a side of the other.
  bool overlap_in_plane(const Triangle& s, const Triangle& t) const {
    const FlatView view = FlatView::of_plane(points_.planes(), s.plane);
    const auto seen = [&](const Triangle& u, auto at) {
      return std::array{flat(at(u.corner[0]), view), flat(at(u.corner[1]), view),
                        flat(at(u.corner[2]), view)};
    };
    const auto overlap = [&](auto at) {
      const auto p = seen(s, at), q = seen(t, at);
      return !is_beyond_a_side(p, q) && !is_beyond_a_side(q, p);
    };
    const auto is_input = [](const Corner& c) { return c.point.is_input(); };
    if (std::ranges::all_of(s.corner, is_input) && std::ranges::all_of(t.corner, is_input)) {
      return overlap([this](const Corner& c) -> const Point3& { return at(c); });
    }
    return overlap([this](const Corner& c) { return exact_at(c); });
  }

 private:
  /// Whether t is strictly beyond a side of s. Both run counter-clockwise.
  template <class Point>
  static bool is_beyond_a_side(const std::array<Point, 3>& s, const std::array<Point, 3>& t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto is_beyond = [&](const Point& x) {
        return orient2d(s[i], s[next(i)], x) == Sign::Negative;
      };
      if (std::ranges::all_of(t, is_beyond)) return true;
    }
    return false;
  }

  static bool are_inputs(const Corner& a, const Corner& b) {
    return a.point.is_input() && b.point.is_input();
  }
  const Point3& at(const Corner& c) const { return points_.planes().point(c.point.input()); }
  RationalPoint3 exact_at(const Corner& c) const { return exact(points_, c.point); }

  static Point2 flat(const Point3& p, FlatView view) {
    const std::array c{p.x, p.y, p.z};
    return {c[view.coordinate(0)], c[view.coordinate(1)]};
  }
  static RationalPoint2 flat(const RationalPoint3& p, FlatView view) {
    const std::array c{&p.x, &p.y, &p.z};
    return {*c[view.coordinate(0)], *c[view.coordinate(1)]};
  }

  const Point3Table& points_;
};

/// The coincidences of the corners of two triangles.
struct Common {
  std::size_t count = 0;
  std::array<std::size_t, 2> of_first{};
  std::array<std::size_t, 2> of_second{};
};

Common common_corners(const Triangle& s, const Triangle& t) {
  Common common;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (s.corner[i].vertex != t.corner[j].vertex) continue;
      if (common.count < 2) {
        common.of_first[common.count] = i;
        common.of_second[common.count] = j;
      }
      ++common.count;
    }
  }
  return common;
}

/// The exact test by the number of common corners.
class PairTest {
 public:
  explicit PairTest(const Point3Table& points) : signs_(points) {}

  bool run(const Triangle& s, const Triangle& t, bool share_corners) const {
    if (!share_corners) return s.plane == t.plane ? signs_.overlap_in_plane(s, t) : cross(s, t);
    const Common common = common_corners(s, t);
    switch (common.count) {
      case 1:
        return meet_at_corner(s, common.of_first[0], t, common.of_second[0]);
      case 2:
        return meet_at_side(s, t, common);
      default:
        return true;
    }
  }

 private:
  /// Tests triangles with two common corners. Both triangles are counter-clockwise seen from the
  /// positive side. If they are on the same side of a common edge, they have the same direction
  /// along it. A common side that is a diagonal of a facet is not a common edge, so its points are
  /// common points at other places.
  static bool meet_at_side(const Triangle& s, const Triangle& t, const Common& common) {
    const auto [i, j] = common.of_first;
    const auto [k, l] = common.of_second;
    const bool s_forward = next(i) == j, t_forward = next(k) == l;
    if (s.is_diagonal(s_forward ? i : j) || t.is_diagonal(t_forward ? k : l)) return true;
    return s.plane == t.plane && s_forward == t_forward;
  }

  // ---------------------------------------------------------------- one common corner

  /// Tests triangles with one common corner v. In one plane their sectors overlap if and only if a
  /// bounding direction of one lies in the other. In two planes, both sectors must have directions
  /// on both sides of the other's plane, or in it. Then each meets the common line of the planes in
  /// a ray from v, and it remains to test whether these rays are equal.
  bool meet_at_corner(const Triangle& s, std::size_t i, const Triangle& t, std::size_t j) const {
    const Corner &v = s.corner[i], &a = s.corner[next(i)], &b = s.corner[next(next(i))];
    const Corner &c = t.corner[next(j)], &d = t.corner[next(next(j))];
    if (s.plane == t.plane) {
      return is_in_sector(s.plane, v, a, b, c) || is_in_sector(s.plane, v, a, b, d) ||
             is_in_sector(s.plane, v, c, d, a) || is_in_sector(s.plane, v, c, d, b);
    }
    const Sign side_a = signs_.side_of(a, t), side_b = signs_.side_of(b, t);
    if (side_a == side_b) return false;  // If both were 0, the triangles would be in one plane.
    const Sign side_c = signs_.side_of(c, s), side_d = signs_.side_of(d, s);
    if (side_c == side_d) return false;
    // Both meet the common line of the planes in a segment that begins at v. These segments have
    // the same direction if and only if the segment a b crosses the plane of t within the sector of
    // t.
    if (side_a == Sign::Zero) return is_in_sector(t.plane, v, c, d, a);
    if (side_b == Sign::Zero) return is_in_sector(t.plane, v, c, d, b);
    return signs_.pass(a, b, v, c) * side_a != Sign::Negative &&
           signs_.pass(a, b, d, v) * side_a != Sign::Negative;
  }

  /// Whether x, a point of the plane, lies between the rays v a and v b or on one of them,
  /// counter-clockwise from the first. Requires less than half a turn between them.
  bool is_in_sector(PlaneId plane, const Corner& v, const Corner& a, const Corner& b,
                    const Corner& x) const {
    return signs_.turn(plane, v, a, x) != Sign::Negative &&
           signs_.turn(plane, v, x, b) != Sign::Negative;
  }

  // ---------------------------------------------------------------- no common corner

  /// Tests triangles in different planes without common corners. Where they meet, a side of one
  /// meets the other.
  bool cross(const Triangle& s, const Triangle& t) const {
    const std::array<Sign, 3> of_s = sides(s, t);
    if (is_one_side(of_s)) return false;
    const std::array<Sign, 3> of_t = sides(t, s);
    if (is_one_side(of_t)) return false;
    return some_side_meets(s, of_s, t) || some_side_meets(t, of_t, s);
  }
  std::array<Sign, 3> sides(const Triangle& s, const Triangle& t) const {
    return {signs_.side_of(s.corner[0], t), signs_.side_of(s.corner[1], t),
            signs_.side_of(s.corner[2], t)};
  }
  /// Whether all three signs are equal and not 0.
  static bool is_one_side(const std::array<Sign, 3>& sides) {
    return sides[0] != Sign::Zero && sides[0] == sides[1] && sides[1] == sides[2];
  }

  /// Whether a side of s meets t. If the side lies in the plane of t, only its ends are tested. If
  /// only its interior meets t, a side of t meets it.
  bool some_side_meets(const Triangle& s, const std::array<Sign, 3>& sides,
                       const Triangle& t) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Sign here = sides[i], there = sides[next(i)];
      if (here == Sign::Zero && contains(t, s.corner[i])) return true;
      if (here * there == Sign::Negative && is_pierced(t, s.corner[i], s.corner[next(i)], here)) {
        return true;
      }
    }
    return false;
  }
  /// Whether t contains x, a point of its plane.
  bool contains(const Triangle& t, const Corner& x) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (signs_.turn(t.plane, t.corner[i], t.corner[next(i)], x) == Sign::Negative) return false;
    }
    return true;
  }
  /// Whether the segment a b meets t. Requires that its ends are on different sides of the plane of
  /// t. The segment meets t if it passes no side on the outside.
  bool is_pierced(const Triangle& t, const Corner& a, const Corner& b, Sign side_of_a) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Sign pass = signs_.pass(a, b, t.corner[i], t.corner[next(i)]);
      if (pass * side_of_a == Sign::Negative) return false;
    }
    return true;
  }

  CornerSigns signs_;
};

}  // namespace

bool TriangleCrossing::meet_elsewhere(const FacetTriangle& s, const FacetTriangle& t,
                                      bool share_corners) const {
  return PairTest(points_).run(s, t, share_corners);
}

namespace {

/// A unit vector, and a bound for the error of each coordinate. The bound is infinite if nothing is
/// known.
struct Direction {
  std::array<double, 3> unit{};
  double error = Box3::kInfinity;
};

/// Returns the direction from one point to another. The difference is first scaled by its largest
/// coordinate, so that nothing overflows, and no subnormal number is lost.
Direction direction(const PointBox& from, const PointBox& to) {
  std::array<double, 3> d;
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    d[i] = to.mid[i] - from.mid[i];
    most = std::max(most, std::fabs(d[i]));
  }
  // If the points are too close together, or coordinates overflow, there is no direction.
  if (!(most > 0x1p-1000 && most < Box3::kInfinity)) return {};
  double square = 0;
  for (double& x : d) x /= most, square += x * x;
  // Let a vector be at least 1 long and off by r in each coordinate, so by sqrt(3) r in length;
  // then its unit vector is off by 2 sqrt(3) r at most, which is below 4 r. 2^-40 covers all
  // roundings.
  const double error = 4 * ((from.radius + to.radius) / most) + 0x1p-40;
  if (!(error < 0x1p-3)) return {};
  const double length = std::sqrt(square);
  for (double& x : d) x /= length;
  return {d, error};
}

}  // namespace

// A triangle of a large facet belongs to the group of the facet. Each other triangle belongs to the
// corner with the most triangles. If there are several, the greatest vertex is used, so that the
// choice is unique.
TriangleGroups group_triangles(std::span<const FacetTriangle> triangles, std::size_t vertex_count) {
  constexpr std::uint32_t kMany = TriangleGroups::kMany;
  std::vector<std::uint32_t> degree(vertex_count, 0), group_at(vertex_count, kNone);
  for (const FacetTriangle& t : triangles) {
    for (const TriangleCorner& corner : t.corner) ++degree[corner.vertex.value()];
  }
  TriangleGroups groups;
  groups.of.assign(triangles.size(), kNone);
  const auto add_group = [&groups](VertexId hub) {
    groups.hub.push_back(hub);
    return static_cast<std::uint32_t>(groups.hub.size() - 1);
  };
  const auto busyness = [&degree](const TriangleCorner& corner) {
    return std::pair(degree[corner.vertex.value()], corner.vertex);
  };
  for (std::size_t begin = 0, end = 0; begin < triangles.size(); begin = end) {
    while (end < triangles.size() && triangles[end].facet == triangles[begin].facet) ++end;
    const bool is_large = end - begin > kMany;
    const std::uint32_t facet_group = is_large ? add_group({}) : kNone;
    for (std::size_t t = begin; t < end; ++t) {
      const VertexId hub = std::ranges::max(triangles[t].corner, {}, busyness).vertex;
      std::uint32_t& group = group_at[hub.value()];
      const bool is_around = !is_large && degree[hub.value()] > kMany;
      if (is_around && group == kNone) group = add_group(hub);
      groups.of[t] = is_around ? group : facet_group;
    }
  }
  // A triangle makes a pair with each earlier triangle of its group.
  std::vector<std::uint64_t> size(groups.hub.size(), 0);
  for (const std::uint32_t g : groups.of) {
    if (g != kNone) groups.pairs += size[g]++;
  }
  return groups;
}

// The unit vectors towards the side form an arc of a great circle between those towards its ends.
// Such an arc is within chord^2 / 4 of its chord: for half the chord x the distance is 1 - sqrt(1 -
// x^2) <= x^2, for every arc up to half a turn. So the box around both ends, widened by that and by
// the errors, holds the arc.
Box3 box_of_directions(const PointBox& centre, const PointBox& a, const PointBox& b) {
  const Direction to_a = direction(centre, a), to_b = direction(centre, b);
  const double error = std::max(to_a.error, to_b.error);
  if (!(error < 1)) return {{-2, -2, -2}, {2, 2, 2}};
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double step = std::fabs(to_a.unit[i] - to_b.unit[i]) + 2 * error;
    square += step * step;
  }
  const double widened = square / 4 + 2 * error;
  Box3 box;
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = std::min(to_a.unit[i], to_b.unit[i]) - widened;
    box.high[i] = std::max(to_a.unit[i], to_b.unit[i]) + widened;
  }
  return box;
}

}  // namespace plumb
