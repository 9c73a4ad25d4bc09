#include "plumb/space/mesh_crossings.h"

#include <algorithm>
#include <array>

#include "plumb/base/box_tree.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/space/box_frame.h"
#include "plumb/space/facet_triangles.h"
#include "plumb/space/mesh_fans.h"
#include "plumb/space/oriented_boxes.h"
#include "plumb/space/packed_boxes.h"
#include "plumb/space/space_boxes.h"

namespace plumb {
namespace {

using FacetPairs = std::vector<std::pair<FacetId, FacetId>>;

struct Corner {
  VertexId vertex;
  SpacePoint point;
};

struct Triangle {
  std::array<Corner, 3> corner;
  PlaneId plane;
  FacetId facet;
  std::uint8_t fans;       ///< bit i: corner i has a fan (mesh_fans.h)
  std::uint8_t diagonals;  ///< bit i: the side from corner i to the next is no edge of the facet

  bool is_diagonal(std::size_t i) const { return (diagonals >> i & 1U) != 0; }
};

constexpr std::size_t next(std::size_t i) { return i == 2 ? 0 : i + 1; }

/// Exact signs about corners. Constructed points (vertices with fractions for coordinates) go to
/// rationals.
class CornerSigns {
 public:
  explicit CornerSigns(const Point3Table& points) : points_(points) {}

  Sign side_of(const Corner& c, const Triangle& t) const { return side(points_, c.point, t.plane); }

  /// Requires that a b crosses the plane of p and q, which is not parallel to it. Positive: p q passes
  /// a b counter-clockwise, seen from a.
  Sign pass(const Corner& a, const Corner& b, const Corner& p, const Corner& q) const {
    if (are_inputs(a, b) && are_inputs(p, q)) return orient3d(at(a), at(b), at(p), at(q));
    return orient3d(exact_at(a), exact_at(b), exact_at(p), exact_at(q));
  }

  /// The turn of three points of a plane, seen from its positive side.
  Sign turn(PlaneId plane, const Corner& a, const Corner& b, const Corner& c) const {
    const FlatView view = FlatView::of_plane(points_.planes(), plane);
    if (are_inputs(a, b) && c.point.is_input()) {
      return orient2d(flat(at(a), view), flat(at(b), view), flat(at(c), view));
    }
    return orient2d(flat(exact_at(a), view), flat(exact_at(b), view), flat(exact_at(c), view));
  }

 private:
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

// ---------------------------------------------------------------- two triangles

/// How the corners of two triangles coincide.
struct Common {
  std::size_t count = 0;
  std::array<std::size_t, 2> of_first{};
  std::array<std::size_t, 2> of_second{};
};

/// Bit i: corner i of s is one of t's. Most pairs need no more.
unsigned shared_corners(const Triangle& s, const Triangle& t) {
  unsigned shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexId v = s.corner[i].vertex;
    const unsigned is_shared = static_cast<unsigned>(v == t.corner[0].vertex) |
                               static_cast<unsigned>(v == t.corner[1].vertex) |
                               static_cast<unsigned>(v == t.corner[2].vertex);
    shared |= is_shared << i;
  }
  return shared;
}

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

class PairTest {
 public:
  explicit PairTest(const Point3Table& points) : signs_(points) {}

  /// Have triangles of different facets a common point that is in no common vertex or edge of the facets?
  bool operator()(const Triangle& s, const Triangle& t) const {
    const unsigned shared = shared_corners(s, t);
    if ((shared & s.fans) != 0) return false;
    if (shared == 0) return s.plane == t.plane ? overlap_in_plane(s, t) : cross(s, t);
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
  /// Both run around the triangle with the positive side up, so that on one side of a common edge
  /// they run along it in one direction.
  static bool meet_at_side(const Triangle& s, const Triangle& t, const Common& common) {
    const auto [i, j] = common.of_first;
    const auto [k, l] = common.of_second;
    const bool s_forward = next(i) == j, t_forward = next(k) == l;
    if (s.is_diagonal(s_forward ? i : j) || t.is_diagonal(t_forward ? k : l)) return true;
    return s.plane == t.plane && s_forward == t_forward;
  }

  // ---------------------------------------------------------------- one common corner

  bool meet_at_corner(const Triangle& s, std::size_t i, const Triangle& t, std::size_t j) const {
    const Corner &v = s.corner[i], &a = s.corner[next(i)], &b = s.corner[next(next(i))];
    const Corner &c = t.corner[next(j)], &d = t.corner[next(next(j))];
    if (s.plane == t.plane) {
      return is_in_sector(s.plane, v, a, b, c) || is_in_sector(s.plane, v, a, b, d) ||
             is_in_sector(s.plane, v, c, d, a) || is_in_sector(s.plane, v, c, d, b);
    }
    const Sign side_a = signs_.side_of(a, t), side_b = signs_.side_of(b, t);
    if (side_a == side_b) return false;  // both 0: one plane
    const Sign side_c = signs_.side_of(c, s), side_d = signs_.side_of(d, s);
    if (side_c == side_d) return false;
    // Both meet the common line of the planes in a piece that begins at v. The same way?
    if (side_a == Sign::Zero) return is_in_sector(t.plane, v, c, d, a);
    if (side_b == Sign::Zero) return is_in_sector(t.plane, v, c, d, b);
    return signs_.pass(a, b, v, c) * side_a != Sign::Negative &&
           signs_.pass(a, b, d, v) * side_a != Sign::Negative;
  }

  /// Is x, in the plane, between the rays v a and v b (or on one), counter-clockwise from the first?
  /// Requires less than a half-turn between them.
  bool is_in_sector(PlaneId plane, const Corner& v, const Corner& a, const Corner& b,
                    const Corner& x) const {
    return signs_.turn(plane, v, a, x) != Sign::Negative &&
           signs_.turn(plane, v, x, b) != Sign::Negative;
  }

  // ---------------------------------------------------------------- no common corner

  /// Convex polygons are apart when one is strictly beyond a side of the other.
  bool overlap_in_plane(const Triangle& s, const Triangle& t) const {
    return !is_beyond_a_side(s, t) && !is_beyond_a_side(t, s);
  }
  bool is_beyond_a_side(const Triangle& s, const Triangle& t) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto is_beyond = [&](const Corner& x) {
        return signs_.turn(s.plane, s.corner[i], s.corner[next(i)], x) == Sign::Negative;
      };
      if (std::ranges::all_of(t.corner, is_beyond)) return true;
    }
    return false;
  }

  /// Different planes: where they meet, a side of one meets the other.
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
  static bool is_one_side(const std::array<Sign, 3>& sides) {
    return sides[0] != Sign::Zero && sides[0] == sides[1] && sides[1] == sides[2];
  }

  /// Of a side in t's plane the ends are enough: where its inside alone meets t, a side of t
  /// meets it.
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
  bool contains(const Triangle& t, const Corner& x) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (signs_.turn(t.plane, t.corner[i], t.corner[next(i)], x) == Sign::Negative) return false;
    }
    return true;
  }
  bool is_pierced(const Triangle& t, const Corner& a, const Corner& b, Sign side_of_a) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Sign pass = signs_.pass(a, b, t.corner[i], t.corner[next(i)]);
      if (pass * side_of_a == Sign::Negative) return false;
    }
    return true;
  }

  CornerSigns signs_;
};

// ---------------------------------------------------------------- all pairs

class CrossingSearch {
 public:
  CrossingSearch(const SpaceComplex& complex, Context& context)
      : complex_(complex), context_(context), memory_(context), test_(complex.points()) {}

  FacetPairs run() {
    memory_.add(kBytesPerCorner * complex_.use_count(), "boxes of triangles");
    gather_triangles();
    find_all();
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

 private:
  static constexpr std::uint64_t kBytesPerCorner = 100;
  static constexpr std::uint64_t kBytesPerThinTriangle = 400;
  static constexpr std::uint64_t kStepsPerTriangle = 32;

  /// What the first tree cannot find in a few steps a box is left to one of two others: boxes of many scales, or boxes that
  /// tell little.
  void find_all() {
    checkpoint();
    const std::vector<Box3> boxes = boxes_of_triangles();
    checkpoint();
    const PackedBoxTree packed(boxes);
    if (packed.fits() && find_in(packed)) return;
    found_.clear();
    if (packed.fits() || has_many_pairs(expected_pairs(boxes, boxes), boxes.size())) {
      find_thin(boxes);
    } else {
      find_in(BoxTree(boxes));
    }
  }

  /// False: pairs are missing. Of spheres, and of triangles strewn about, the steps are 7 to 13 for each.
  bool find_in(const PackedBoxTree& tree) {
    std::uint64_t left = kStepsPerTriangle * (triangles_.size() + 256);
    const auto may_go_on = [&] {
      if (--left % 4096 == 0) checkpoint();
      return left > 0;
    };
    const auto look = [this](std::uint32_t i, std::uint32_t j) { look_at(i, j); };
    return tree.for_each_pair_inside(look, may_go_on);
  }
  void find_in(const BoxTree& tree) {
    std::uint64_t visited = 0;
    tree.for_each_pair_inside([&](std::uint32_t i, std::uint32_t j) {
      if (++visited % 4096 == 0) checkpoint();
      look_at(i, j);
    });
  }
  /// Of triangles that are thin and run in more directions than one.
  void find_thin(std::span<const Box3> boxes) {
    memory_.add(kBytesPerThinTriangle * triangles_.size(), "oriented boxes of triangles");
    std::vector<OrientedBoxTree::Triangle> corners;
    corners.reserve(triangles_.size());
    for (const Triangle& t : triangles_) {
      const auto box = [&](std::size_t i) { return complex_.points().box(t.corner[i].point); };
      corners.push_back({box(0), box(1), box(2)});
    }
    std::uint64_t steps = 0;
    OrientedBoxTree(corners).for_each_pair_inside(
        [&](std::uint32_t i, std::uint32_t j) {
          if (boxes[i].meets(boxes[j])) look_at(i, j);
        },
        [&] {
          if (++steps % 4096 == 0) checkpoint();
        });
  }
  void checkpoint() { context_.checkpoint("crossings of the mesh with itself", 0, 0); }

  void look_at(std::uint32_t i, std::uint32_t j) {
    const Triangle &s = triangles_[i], &t = triangles_[j];
    if (s.facet == t.facet || !test_(s, t)) return;
    if (found_.size() % 4096 == 0) memory_.add(4096 * sizeof(found_[0]), "crossings of the mesh");
    found_.push_back(std::minmax(s.facet, t.facet));
  }

  void gather_triangles() {
    triangles_.reserve(complex_.use_count());
    FacetTriangles facets(complex_);
    const std::vector<std::uint8_t> has_fan = find_fans(complex_);
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      facets.for_each(FacetId(f), [&](VertexId a, VertexId b, VertexId c) {
        const auto fans = has_fan[a.value()] | has_fan[b.value()] << 1 | has_fan[c.value()] << 2;
        triangles_.push_back({{corner(a), corner(b), corner(c)},
                              complex_.facet_plane[f],
                              FacetId(f),
                              static_cast<std::uint8_t>(fans),
                              0});
      });
      if (!is_triangle(FacetId(f))) mark_diagonals(FacetId(f));
    }
  }
  Corner corner(VertexId v) const { return {v, complex_.vertex_point[v.value()]}; }
  bool is_triangle(FacetId f) const {
    return !triangles_.empty() && (triangles_.size() == 1 || triangles_.rbegin()[1].facet != f);
  }

  /// Of the last triangles, those of facet f: sides that are not on its boundary.
  void mark_diagonals(FacetId f) {
    boundary_.clear();
    for (const UseId first : complex_.cycles_of(f)) {
      UseId u = first;
      do {
        boundary_.emplace_back(complex_.use_origin(u),
                               complex_.use_origin(complex_.use_next[u.value()]));
        u = complex_.use_next[u.value()];
      } while (u != first);
    }
    std::sort(boundary_.begin(), boundary_.end());
    for (auto t = triangles_.rbegin(); t != triangles_.rend() && t->facet == f; ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::pair side(t->corner[i].vertex, t->corner[next(i)].vertex);
        if (!std::ranges::binary_search(boundary_, side)) t->diagonals |= 1U << i;
      }
    }
  }

  /// Along the axes, or in a frame where fewer of them meet.
  std::vector<Box3> boxes_of_triangles() const {
    std::vector<Box3> boxes = boxes_by([&](VertexId v) { return box_of(complex_, v); });
    const double pairs = expected_pairs(boxes, boxes);
    if (!has_many_pairs(pairs, boxes.size())) return boxes;
    const BoxFrame frame = BoxFrame::of_edges(std::array{&complex_});
    std::vector<Box3> turned = boxes_by([&](VertexId v) { return frame.box_of(complex_, v); });
    return is_better_frame(expected_pairs(turned, turned), pairs) ? turned : boxes;
  }
  template <class BoxOf>
  std::vector<Box3> boxes_by(const BoxOf& box_of_vertex) const {
    std::vector<Box3> boxes;
    boxes.reserve(triangles_.size());
    for (const Triangle& t : triangles_) {
      Box3 box = box_of_vertex(t.corner[0].vertex);
      box.add(box_of_vertex(t.corner[1].vertex));
      box.add(box_of_vertex(t.corner[2].vertex));
      boxes.push_back(box);
    }
    return boxes;
  }

  const SpaceComplex& complex_;
  Context& context_;
  MemoryCharge memory_;
  PairTest test_;
  std::vector<Triangle> triangles_;
  std::vector<std::pair<VertexId, VertexId>> boundary_;
  FacetPairs found_;
};

}  // namespace

std::vector<std::pair<FacetId, FacetId>> find_mesh_crossings(const SpaceComplex& complex,
                                                             Context& context) {
  return CrossingSearch(complex, context).run();
}

}  // namespace plumb
