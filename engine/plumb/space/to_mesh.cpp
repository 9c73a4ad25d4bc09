// From a complex to a mesh: vertices by cones, faces by facets, and what the mesh cannot show.
//
// A vertex of the complex may touch the solid with several cones; a manifold mesh needs a vertex
// for each. Corners of the shown sides of facets are joined around every edge, where two sides
// bound the same part of the solid; the classes are the cones. Where an edge has more than two
// shown sides, the solid behind them says which two belong together: after a side with the solid
// behind it comes the side that closes it.
//
// Facets that are triangles or, if the options allow it, simple polygons stay whole; others are cut
// into triangles between vertices of the complex, so there are no T-junctions. Points are rounded
// to the nearest doubles, once each, by exact arithmetic.
//
// Tested by tests/space/to_mesh_test.cpp.

#include "plumb/space/to_mesh.h"

#include <algorithm>
#include <array>

#include "plumb/base/internal/union_find.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/rounded_point3.h"
#include "plumb/space/planar/facet_triangles.h"

namespace plumb {
namespace {

/// The bytes that are charged for each edge use (Weiler).
constexpr std::uint64_t kBytesPerUse = 60;

/// Calls visit(use) for all uses of a facet.
template <class Visit>
void for_uses(const SpaceComplex& complex, FacetId f, const Visit& visit) {
  for (const UseId first : complex.cycles_of(f)) {
    UseId u = first;
    do {
      visit(u);
      u = complex.use_next[u.value()];
    } while (u != first);
  }
}

// ---------------------------------------------------------------- cones

/// Corners of the sides of facets, joined where sides bound the same part of the solid along an
/// edge. The corner of use u seen from side s is 2 u + s; inner vertices of facets have corners
/// after those.
class Cones {
 public:
  Cones(const SpaceComplex& complex, std::span<const std::array<std::uint8_t, 2>> shown)
      : complex_(complex),
        shown_(shown),
        classes_(2 * (complex.use_count() + complex.inner.size())) {
    for (std::uint32_t e = 0; e < complex.edge_count(); ++e) join_around(EdgeId(e));
  }

  /// Returns the number of edges with more than two shown sides.
  std::uint32_t crowded_edges() const { return crowded_edges_; }
  /// Returns the corner of a use seen from a side.
  static std::uint32_t corner(UseId u, bool side) { return 2 * u.value() + (side ? 1 : 0); }
  /// Returns the corner of inner vertex i, an index of SpaceComplex::inner, seen from a side.
  std::uint32_t corner_of_inner(std::size_t i, bool side) const {
    return static_cast<std::uint32_t>(2 * (complex_.use_count() + i) + (side ? 1 : 0));
  }
  std::size_t size() const { return classes_.size(); }
  /// Returns the cone of a corner.
  std::uint32_t root(std::uint32_t c) { return classes_.root(c); }
  /// Joins two cones. A facet that is around one vertex twice keeps one vertex there.
  void join(std::uint32_t a, std::uint32_t b) { classes_.unite(a, b); }

 private:
  /// A shown side at an edge.
  struct Entry {
    UseId use;
    bool side;
    bool is_solid_after;
  };

  /// Joins the corners of sides that bound the same part of the solid along an edge. After a use of
  /// 2e comes the positive side of its facet; the solid is behind what is shown.
  void join_around(EdgeId e) {
    ring_.clear();
    const UseId first = complex_.edge_use[e.value()];
    if (!first.is_valid()) return;
    UseId u = first;
    do {
      const auto& shown = shown_[complex_.use_facet[u.value()].value()];
      const bool is_reverse = SpaceComplex::is_reverse(complex_.use_halfedge[u.value()]);
      // The sides of the facet behind which the solid lies before and after it.
      const bool before = is_reverse, after = !is_reverse;
      if (shown[before ? 1 : 0] != 0) ring_.push_back({u, before, false});
      if (shown[after ? 1 : 0] != 0) ring_.push_back({u, after, true});
      u = complex_.use_radial[u.value()];
    } while (u != first);
    // Shown sides alternate between those before and those behind a part of the solid.
    if (ring_.size() > 2) ++crowded_edges_;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (ring_[i].is_solid_after) join_ends(ring_[i], ring_[i + 1 == ring_.size() ? 0 : i + 1]);
    }
  }

  /// Joins the corners of two sides at both ends of an edge.
  void join_ends(const Entry& a, const Entry& b) {
    // Two sides that run the same way along the edge have their corners at the same ends.
    const bool is_same_way =
        complex_.use_halfedge[a.use.value()] == complex_.use_halfedge[b.use.value()];
    const UseId a_end = complex_.use_next[a.use.value()], b_end = complex_.use_next[b.use.value()];
    join(corner(a.use, a.side), corner(is_same_way ? b.use : b_end, b.side));
    join(corner(a_end, a.side), corner(is_same_way ? b_end : b.use, b.side));
  }

  const SpaceComplex& complex_;
  std::span<const std::array<std::uint8_t, 2>> shown_;
  UnionFind classes_;  // Classes of corners.
  std::vector<Entry> ring_;
  std::uint32_t crowded_edges_ = 0;
};

// ---------------------------------------------------------------- faces

/// Makes a mesh of sides of facets.
class MeshMaker {
 public:
  MeshMaker(const SpaceComplex& complex, std::span<const FacetSide> sides,
            const ToMeshOptions& options, Context& context)
      : complex_(complex),
        sides_(sides),
        options_(options),
        context_(context),
        shown_(shown_sides(complex, sides)),
        cones_(complex, shown_),
        cutter_(complex) {}

  MeshOfComplex run() {
    number_vertices();
    add_points();
    cutter_.use_nearest(nearest_);
    out_.mesh.face_begin.reserve(sides_.size() + 1);
    out_.mesh.corners.reserve(3 * sides_.size());
    out_.facet.reserve(sides_.size());
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      if (i % 4096 == 0) context_.checkpoint("faces of the mesh", i, sides_.size());
      add_faces(sides_[i]);
    }
    out_.report.non_manifold_edges = cones_.crowded_edges();
    return std::move(out_);
  }

 private:
  using Shown = std::vector<std::array<std::uint8_t, 2>>;

  /// Returns for each facet which of its sides are shown.
  static Shown shown_sides(const SpaceComplex& complex, std::span<const FacetSide> sides) {
    Shown shown(complex.facet_count());
    for (const FacetSide& s : sides) shown[s.facet.value()][s.is_reversed ? 1 : 0] = 1;
    return shown;
  }

  /// Calls visit(vertex, corner) for all corners of a side.
  template <class Visit>
  void for_corners(const FacetSide& s, const Visit& visit) {
    for_uses(complex_, s.facet,
             [&](UseId u) { visit(complex_.use_origin(u), Cones::corner(u, s.is_reversed)); });
    const std::uint32_t begin = complex_.inner_begin[s.facet.value()];
    const auto inner = complex_.inner_of(s.facet);
    for (std::size_t i = 0; i < inner.size(); ++i) {
      visit(inner[i], cones_.corner_of_inner(begin + i, s.is_reversed));
    }
  }

  /// Makes a vertex for each cone, or for all cones of a vertex of the complex, in the order of the
  /// complex.
  void number_vertices() {
    if (options_.split_vertices) {
      for (const FacetSide& s : sides_) keep_corners_together(s);
    }
    std::vector<std::uint32_t> first(complex_.vertex_count(), kNone);
    // Most vertices have one cone, kept in `first`; further ones go to a list that stays short.
    std::vector<std::pair<VertexId, std::uint32_t>> others;
    for (const FacetSide& s : sides_) {
      for_corners(s, [&](VertexId v, std::uint32_t corner) {
        const std::uint32_t cone = cones_.root(corner);
        std::uint32_t& known = first[v.value()];
        if (known == kNone) known = cone;
        if (known != cone) others.emplace_back(v, cone);
      });
    }
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    number_.resize(options_.split_vertices ? cones_.size() : first.size(), kNone);
    auto other = others.begin();
    for (std::uint32_t v = 0; v < first.size(); ++v) {
      if (first[v] == kNone) continue;
      add_vertex(VertexId(v), first[v]);
      if (other != others.end() && other->first == VertexId(v)) ++out_.report.non_manifold_vertices;
      for (; other != others.end() && other->first == VertexId(v); ++other) {
        if (options_.split_vertices) add_vertex(VertexId(v), other->second);
      }
    }
  }
  void add_vertex(VertexId v, std::uint32_t cone) {
    number_[options_.split_vertices ? cone : v.value()] =
        static_cast<std::uint32_t>(vertex_.size());
    vertex_.push_back(v);
  }
  /// Returns the vertex of the mesh at a corner.
  std::uint32_t number(VertexId v, std::uint32_t corner) {
    return number_[options_.split_vertices ? cones_.root(corner) : v.value()];
  }

  /// Joins the cones of a side's corners at one vertex.
  void keep_corners_together(const FacetSide& s) {
    corners_.clear();
    for_corners(s, [&](VertexId v, std::uint32_t c) { corners_.emplace_back(v, cones_.root(c)); });
    if (corners_.size() == 3) return;
    std::sort(corners_.begin(), corners_.end());
    for (std::size_t i = 1; i < corners_.size(); ++i) {
      if (corners_[i].first == corners_[i - 1].first) {
        cones_.join(corners_[i].second, corners_[i - 1].second);
      }
    }
  }

  /// Adds the face or faces of a side.
  void add_faces(const FacetSide& s) {
    corners_.clear();
    for_corners(s, [&](VertexId v, std::uint32_t c) { corners_.emplace_back(v, number(v, c)); });
    // Corners come in the order of the cycle, counter-clockwise from the positive side.
    if (corners_.size() == 3 || can_be_polygon(s.facet)) {
      face_.clear();
      for (const auto& [v, number] : corners_) face_.push_back(number);
      add_face(s);
      return;
    }
    std::sort(corners_.begin(), corners_.end());
    cutter_.for_each(s.facet, [&](VertexId a, VertexId b, VertexId c) {
      face_ = {number_at(a), number_at(b), number_at(c)};
      add_face(s);
    });
  }
  std::uint32_t number_at(VertexId v) const {
    return std::ranges::lower_bound(corners_, v, {}, [](const auto& c) { return c.first; })->second;
  }

  /// Whether the facet may stay one polygon. Requires its corners, in order, in corners_.
  bool can_be_polygon(FacetId f) {
    if (options_.faces == MeshFaces::Triangles) return false;
    if (complex_.cycles_of(f).size() > 1 || !complex_.inner_of(f).empty()) return false;
    seen_.resize(complex_.vertex_count(), 0);
    ++polygons_;
    for (const auto& [v, number] : corners_) {
      const bool is_double = complex_.vertex_point[v.value()].is_input();
      if (!is_double && options_.faces == MeshFaces::PlanarPolygons) return false;
      if (seen_[v.value()] == polygons_) return false;
      seen_[v.value()] = polygons_;
    }
    return true;
  }

  void add_face(const FacetSide& s) {
    if (s.is_reversed) std::reverse(face_.begin(), face_.end());
    out_.mesh.add_face(face_);
    out_.facet.push_back(s.facet);
  }

  void add_points() {
    out_.mesh.points.reserve(vertex_.size());
    nearest_.resize(complex_.vertex_count());
    for (std::uint32_t i = 0; i < vertex_.size(); ++i) {
      const SpacePoint p = complex_.vertex_point[vertex_[i].value()];
      RoundedPoint3& nearest = nearest_[vertex_[i].value()];
      const bool is_first = i == 0 || vertex_[i] != vertex_[i - 1];
      if (is_first) nearest = rounded(complex_.points(), p);
      out_.mesh.points.push_back(nearest.at);
      if (options_.keeps_exact && !nearest.is_exact) {
        out_.mesh.exact.emplace_back(i, exact(complex_.points(), p));
      }
    }
  }

  const SpaceComplex& complex_;
  std::span<const FacetSide> sides_;
  const ToMeshOptions& options_;
  Context& context_;
  Shown shown_;
  Cones cones_;
  FacetTriangles cutter_;
  MeshOfComplex out_;
  // The vertex of the mesh of each cone if vertices are split, else of each vertex.
  std::vector<std::uint32_t> number_;
  std::vector<VertexId> vertex_;        // The vertex of the complex of each vertex of the mesh.
  std::vector<RoundedPoint3> nearest_;  // One entry for each vertex of the complex with a number.
  std::vector<std::pair<VertexId, std::uint32_t>> corners_;  // Those of the side being written.
  std::vector<std::uint32_t> face_;
  std::vector<std::uint32_t> seen_;  // The last polygon at each vertex, counted by polygons_.
  std::uint32_t polygons_ = 0;
};

// ---------------------------------------------------------------- what is left out

/// Counts marked cells outside the closure of the interior, and unmarked cells in it, by whether
/// they lie inside or on its boundary.
class ClosureCount {
 public:
  ClosureCount(const SpaceComplex& complex, ToMeshReport& report)
      : complex_(complex), report_(report) {}

  void run() {
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      count(complex_.facet_mark[f], around(FacetId(f)), &ItemCounts::facets);
    }
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) {
      count(complex_.edge_mark[e], around(EdgeId(e)), &ItemCounts::edges);
    }
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
      count(complex_.vertex_mark[v], around(VertexId(v)), &ItemCounts::vertices);
    }
  }

 private:
  /// Whether marked volumes, and others, lie around a cell.
  struct Around {
    bool marked = false;
    bool unmarked = false;
  };

  void count(Mark mark, Around around, std::uint64_t ItemCounts::*kind) {
    if (mark == 1 && !around.marked) ++(report_.dropped.*kind);
    if (mark == 0 && around.marked) {
      // By name: g++ 12 increments a copy if the conditional stands before .* itself.
      ItemCounts& counts = around.unmarked ? report_.closed : report_.filled;
      ++(counts.*kind);
    }
  }

  void add(VolumeId v, Around& around) const {
    if (!v.is_valid()) return;
    (complex_.volume_mark[v.value()] == 1 ? around.marked : around.unmarked) = true;
  }
  void add(FacetId f, Around& around) const {
    for (const VolumeId v : complex_.facet_volume[f.value()]) add(v, around);
  }
  void add(EdgeId e, Around& around) const {
    const UseId first = complex_.edge_use[e.value()];
    if (!first.is_valid()) return add(complex_.edge_volume[e.value()], around);
    UseId u = first;
    do {
      add(complex_.volume_after(u), around);
      u = complex_.use_radial[u.value()];
    } while (u != first);
  }

  Around around(FacetId f) const {
    Around result;
    add(f, result);
    return result;
  }
  Around around(EdgeId e) const {
    Around result;
    add(e, result);
    return result;
  }
  Around around(VertexId v) const {
    Around result;
    add(complex_.vertex_volume[v.value()], result);
    const FacetId f = complex_.vertex_facet[v.value()];
    if (f.is_valid()) add(f, result);
    for (const HalfedgeId h : complex_.star_of(v)) add(SpaceComplex::edge_of(h), result);
    return result;
  }

  const SpaceComplex& complex_;
  ToMeshReport& report_;
};

/// Whether a marked volume is volume 0 or meets the frame.
bool is_unbounded(const SpaceComplex& complex) {
  if (complex.volume_count() > 0 && complex.volume_mark[0] == 1) return true;
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    if (complex.facet_mark[f] != kBeyond) continue;
    for (const VolumeId v : complex.facet_volume[f]) {
      if (v.is_valid() && complex.volume_mark[v.value()] == 1) return true;
    }
  }
  return false;
}

}  // namespace

// A side is reversed if the solid lies on the positive side, as faces are to be seen from outside.
std::vector<FacetSide> boundary_sides(const SpaceComplex& complex) {
  std::vector<FacetSide> sides;
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    const Mark above = complex.volume_mark[complex.facet_volume[f][0].value()];
    const Mark below = complex.volume_mark[complex.facet_volume[f][1].value()];
    if ((above == 1) != (below == 1)) sides.push_back({FacetId(f), above == 1});
  }
  return sides;
}

MeshOfComplex mesh_of_sides(const SpaceComplex& complex, std::span<const FacetSide> sides,
                            const ToMeshOptions& options, Context& context) {
  MemoryCharge memory(context);
  memory.add(kBytesPerUse * complex.use_count() + sizeof(RoundedPoint3) * complex.vertex_count(),
             "a mesh");
  return MeshMaker(complex, sides, options, context).run();
}

MeshOfComplex mesh_of_complex(const SpaceComplex& complex, const ToMeshOptions& options,
                              Context& context) {
  MeshOfComplex result;
  if (is_unbounded(complex)) {
    result.report.is_unbounded = true;
    return result;
  }
  result = mesh_of_sides(complex, boundary_sides(complex), options, context);
  ClosureCount(complex, result.report).run();
  return result;
}

bool is_unbounded(const SpaceComplex& complex, FacetId f) {
  bool is_far = false;
  for_uses(complex, f, [&](UseId u) {
    is_far |= complex.vertex_mark[complex.use_origin(u).value()] == kBeyond;
  });
  return is_far;
}

// Facets within the solid, or off it, are shown from their positive side; those at its boundary
// from outside. All facets are shown, so none counts as dropped.
MeshOfComplex soup_of_complex(const SpaceComplex& complex, const ToMeshOptions& options,
                              Context& context) {
  std::vector<FacetSide> sides;
  bool has_far = false;
  for (std::uint32_t f = 0; f < complex.facet_count(); ++f) {
    if (complex.facet_mark[f] == kBeyond) continue;
    if (is_unbounded(complex, FacetId(f))) {
      has_far = true;
      continue;
    }
    const Mark above = complex.volume_mark[complex.facet_volume[f][0].value()];
    const Mark below = complex.volume_mark[complex.facet_volume[f][1].value()];
    sides.push_back({FacetId(f), above == 1 && below != 1});
  }
  MeshOfComplex result = mesh_of_sides(complex, sides, options, context);
  ClosureCount(complex, result.report).run();
  result.report.dropped.facets = 0;
  result.report.is_unbounded = has_far;
  return result;
}

}  // namespace plumb
