// The search for pairs of facets that cross: candidates by boxes, then one exact test for each.
//
// Up to 32 triangles are compared pair by pair. For larger meshes, no tree of boxes is good for all
// of them, so three trees are tried in turn. Packed boxes (16 bits a coordinate) serve meshes of
// one scale: 7 to 8 steps a triangle for spheres and scans. They are given up after 32 steps a
// triangle, which bounds the lost time by a constant factor. Then boxes of many scales go to a tree
// of doubles; triangles that are long and thin, or very many around a vertex or in one facet, go to
// oriented boxes, which leave out pairs of one group, and pairs around a vertex are found by boxes
// of their directions.
//
// Every tree reports each pair whose boxes meet, so the result does not depend on the tree that is
// used. The pairs are sorted, and repetitions are dropped.
//
// Tested by tests/space/mesh_crossings_test.cpp.

#include "plumb/space/mesh/mesh_crossings.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>

#include "plumb/base/internal/box_tree.h"
#include "plumb/space/bounds/oriented_boxes.h"
#include "plumb/space/complex/space_boxes.h"
#include "plumb/space/mesh/triangle_crossing.h"
#include "plumb/space/planar/facet_triangles.h"

namespace plumb {
namespace {

using FacetPairs = std::vector<std::pair<FacetId, FacetId>>;

// ---------------------------------------------------------------- all pairs

/// The search in one mesh.
class CrossingSearch {
 public:
  CrossingSearch(const SpaceComplex& complex, std::span<const std::uint8_t> has_fan, BoxOrder order,
                 Context& context)
      : complex_(complex),
        has_fan_(has_fan),
        order_(order),
        context_(context),
        memory_(context),
        test_(complex.points()) {}

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
  static constexpr std::uint64_t kBytesPerThinTriangle = 640;
  static constexpr std::uint64_t kStepsPerTriangle = 32;
  static constexpr std::size_t kFew = 32;

  /// Tests all pairs. If the first tree cannot find them in a few steps for each box, one of two
  /// other trees is used: one for boxes of many scales, and one for boxes that are much larger than
  /// their triangles.
  void find_all() {
    checkpoint();
    if (triangles_.size() <= kFew) return find_among_few();
    bool is_given_up = false;  // Whether a packed tree is possible, but takes too many steps.
    if (const auto tree = tree_of_points()) {
      if (find_in(*tree)) return;
      is_given_up = true;
    }
    const std::vector<Box3> boxes = boxes_of_triangles();
    checkpoint();
    if (!is_given_up) {
      const PackedBoxTree packed(boxes);
      if (packed.fits() && find_in(packed)) return;
      is_given_up = packed.fits();
    }
    const TriangleGroups groups = group_triangles(triangles_, complex_.vertex_count());
    checkpoint();
    if (is_given_up || groups.pairs > kStepsPerTriangle * triangles_.size() ||
        has_many_pairs(expected_pairs(boxes, boxes), boxes.size())) {
      find_thin(boxes, groups.of);
      find_around_hubs(groups);
    } else {
      find_in(BoxTree(boxes), [](std::uint32_t i) { return i; });
    }
  }

  /// Returns the packed tree of the triangles along the coordinate axes, or nothing if their boxes
  /// do not fit, too many of them may meet, or a vertex is a constructed point.
  std::optional<PackedBoxTree> tree_of_points() const {
    std::vector<Point3> points;
    points.reserve(complex_.vertex_count());
    for (const SpacePoint p : complex_.vertex_point) {
      if (!p.is_input()) return {};
      points.push_back(complex_.planes().point(p.input()));
    }
    std::vector<std::array<std::uint32_t, 3>> corners;
    corners.reserve(triangles_.size());
    for (const FacetTriangle& t : triangles_) {
      corners.push_back(
          {t.corner[0].vertex.value(), t.corner[1].vertex.value(), t.corner[2].vertex.value()});
    }
    std::optional<PackedBoxTree> tree(std::in_place, points, corners, order_);
    if (!tree->fits() || has_many_pairs(tree->expected_pairs(), corners.size())) tree.reset();
    return tree;
  }

  /// Tests the pairs of a few triangles, for which a tree takes more time than it saves.
  void find_among_few() {
    const std::vector<Box3> boxes = boxes_by([&](VertexId v) { return box_of(complex_, v); });
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
        if (boxes[i].meets(boxes[j])) look_at(i, j);
      }
    }
  }

  /// Tests the pairs that a packed tree finds. Returns false if it was abandoned, so that pairs are
  /// missing. For spheres and scanned models, it takes 7 to 8 steps for each triangle.
  bool find_in(const PackedBoxTree& tree) {
    std::uint64_t left = kStepsPerTriangle * (triangles_.size() + 256);
    const auto may_go_on = [&] {
      if (--left % 4096 == 0) checkpoint();
      return left > 0;
    };
    const auto look = [this](std::uint32_t i, std::uint32_t j) { look_at(i, j); };
    return tree.for_each_pair_inside(look, may_go_on);
  }
  template <class TriangleOf>
  void find_in(const BoxTree& tree, const TriangleOf& triangle_of) {
    tree.for_each_pair_inside([&](std::uint32_t i, std::uint32_t j) {
      take_step();
      look_at(triangle_of(i), triangle_of(j));
    });
  }
  /// Tests pairs of thin triangles of several directions, except pairs of one group.
  void find_thin(std::span<const Box3> boxes, std::span<const std::uint32_t> groups) {
    memory_.add(kBytesPerThinTriangle * triangles_.size(), "oriented boxes of triangles");
    std::vector<OrientedBoxTree::Triangle> corners;
    corners.reserve(triangles_.size());
    for (const FacetTriangle& t : triangles_) {
      const auto box = [&](std::size_t i) { return complex_.points().box(t.corner[i].point); };
      corners.push_back({box(0), box(1), box(2)});
    }
    const auto on_step = [this] { take_step(); };
    OrientedBoxTree(corners, groups, on_step)
        .for_each_pair_inside(
            [&](std::uint32_t i, std::uint32_t j) {
              if (boxes[i].meets(boxes[j])) look_at(i, j);
            },
            on_step);
  }
  /// Tests the pairs of one group, which were left out. A facet does not cross itself, and around a
  /// vertex the directions decide.
  void find_around_hubs(const TriangleGroups& groups) {
    std::vector<std::uint32_t> around;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const std::uint32_t g = groups.of[t];
      if (g != kNone && groups.hub[g].is_valid()) around.push_back(t);
    }
    std::ranges::stable_sort(around, {}, [&](std::uint32_t t) { return groups.of[t]; });
    for (auto first = around.begin(), last = first; first != around.end(); first = last) {
      const std::uint32_t g = groups.of[*first];
      while (last != around.end() && groups.of[*last] == g) ++last;
      find_around(groups.hub[g], {first, last});
    }
  }
  /// Tests pairs of triangles around one vertex. If the vertex has a fan, no two of them cross.
  void find_around(VertexId hub, std::span<const std::uint32_t> triangles) {
    std::vector<Box3> boxes;
    for (const std::uint32_t t : triangles) {
      take_step();
      const FacetTriangle& triangle = triangles_[t];
      std::size_t i = 0;
      while (triangle.corner[i].vertex != hub) ++i;
      if ((triangle.fans >> i & 1U) != 0) return;
      const auto box = [&](std::size_t k) {
        return complex_.points().box(triangle.corner[(i + k) % 3].point);
      };
      boxes.push_back(box_of_directions(box(0), box(1), box(2)));
    }
    find_in(BoxTree(boxes), [&](std::uint32_t i) { return triangles[i]; });
  }
  void take_step() {
    if (++steps_ % 4096 == 0) checkpoint();
  }
  void checkpoint() { context_.checkpoint("crossings of the mesh with itself", 0, 0); }

  /// Tests one pair of triangles, and notes their facets if they cross.
  void look_at(std::uint32_t i, std::uint32_t j) {
    if (share_fan(fan_corners_[i], fan_corners_[j])) return;  // Most pairs do.
    const FacetTriangle &s = triangles_[i], &t = triangles_[j];
    if (s.facet == t.facet || !test_(s, t)) return;
    if (found_.size() % 4096 == 0) memory_.add(4096 * sizeof(found_[0]), "crossings of the mesh");
    found_.push_back(std::minmax(s.facet, t.facet));
  }

  void gather_triangles() {
    triangles_.reserve(triangle_count());
    fan_corners_.reserve(triangle_count());
    FacetTriangles facets(complex_);
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      facets.for_each(FacetId(f), [&](VertexId a, VertexId b, VertexId c) {
        const auto fans = has_fan_[a.value()] | has_fan_[b.value()] << 1 | has_fan_[c.value()] << 2;
        triangles_.push_back({{corner(a), corner(b), corner(c)},
                              complex_.facet_plane[f],
                              FacetId(f),
                              static_cast<std::uint8_t>(fans),
                              0});
        fan_corners_.push_back(FanCorners{fan_corner(a), fan_corner(b), fan_corner(c), kNone});
      });
      if (!is_triangle(FacetId(f))) mark_diagonals(FacetId(f));
    }
  }
  /// Returns the number of triangles of all facets. A facet with n corners, h holes and i inner
  /// vertices has n + 2 h + 2 i - 2 of them.
  std::size_t triangle_count() const {
    return complex_.use_count() + 2 * (complex_.cycle.size() + complex_.inner.size()) -
           std::min(4 * complex_.facet_count(), complex_.use_count() + 2 * complex_.cycle.size());
  }
  TriangleCorner corner(VertexId v) const { return {v, complex_.vertex_point[v]}; }
  /// Whether the facet that was collected last has one triangle.
  bool is_triangle(FacetId f) const {
    return !triangles_.empty() && (triangles_.size() == 1 || triangles_.rbegin()[1].facet != f);
  }

  /// Marks the sides of the last triangles, which belong to facet f, that are not on the boundary
  /// of f.
  void mark_diagonals(FacetId f) {
    boundary_.clear();
    for (const UseId first : complex_.cycles_of(f)) {
      UseId u = first;
      do {
        boundary_.emplace_back(complex_.use_origin(u), complex_.use_origin(complex_.use_next[u]));
        u = complex_.use_next[u];
      } while (u != first);
    }
    std::sort(boundary_.begin(), boundary_.end());
    for (auto t = triangles_.rbegin(); t != triangles_.rend() && t->facet == f; ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::pair side(t->corner[i].vertex, t->corner[i == 2 ? 0 : i + 1].vertex);
        if (!std::ranges::binary_search(boundary_, side)) t->diagonals |= 1U << i;
      }
    }
  }

  /// Returns the boxes of the triangles along the coordinate axes, or along the axes of a frame in
  /// which fewer of them meet.
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
    for (const FacetTriangle& t : triangles_) {
      Box3 box = box_of_vertex(t.corner[0].vertex);
      box.add(box_of_vertex(t.corner[1].vertex));
      box.add(box_of_vertex(t.corner[2].vertex));
      boxes.push_back(box);
    }
    return boxes;
  }

  /// The corners of a triangle at which there is a fan, side by side. The other corners are
  /// replaced by kNone.
  using FanCorners __attribute__((vector_size(16))) = std::uint32_t;

  /// Whether two triangles have a common corner with a fan: then they do not cross.
  static bool share_fan(FanCorners s, FanCorners t) {
    const FanCorners none{kNone, kNone, kNone, kNone};
    const auto equal = (s == t) | (s == __builtin_shufflevector(t, t, 1, 2, 0, 3)) |
                       (s == __builtin_shufflevector(t, t, 2, 0, 1, 3));
    const auto shared = std::bit_cast<std::array<std::uint64_t, 2>>(equal & (s != none));
    return (shared[0] | shared[1]) != 0;
  }
  std::uint32_t fan_corner(VertexId v) const {
    return has_fan_[v.value()] != 0 ? v.value() : kNone;
  }

  const SpaceComplex& complex_;
  const std::span<const std::uint8_t> has_fan_;
  const BoxOrder order_;
  Context& context_;
  MemoryCharge memory_;
  TriangleCrossing test_;
  std::vector<FacetTriangle> triangles_;
  std::vector<FanCorners> fan_corners_;  // One entry for each triangle.
  std::vector<std::pair<VertexId, VertexId>> boundary_;
  FacetPairs found_;         // Some pairs occur more than once.
  std::uint64_t steps_ = 0;  // The number of steps in all trees.
};

}  // namespace

std::vector<std::pair<FacetId, FacetId>> find_mesh_crossings(const SpaceComplex& complex,
                                                             std::span<const std::uint8_t> has_fan,
                                                             Context& context, BoxOrder order) {
  return CrossingSearch(complex, has_fan, order, context).run();
}

}  // namespace plumb
