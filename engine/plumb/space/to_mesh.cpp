// From a complex to a mesh: vertices by cones, faces by facets, and the cells that the mesh cannot
// represent.
//
// A vertex of the complex may touch the solid with several cones; a manifold mesh needs a vertex
// for each. Corners of the shown sides of facets are joined around every edge, where two sides
// bound the same part of the solid; the classes are the cones. Where an edge has more than two
// shown sides, the solid behind them decides which two sides belong together: a side with the solid
// behind it is followed by the side that closes the solid. If each edge has two shown sides, as on
// most solids, and no vertex is to be split, a walk around each vertex tells whether it has more
// than one cone.
//
// With threads, corners are joined while points are rounded and cells counted; then consecutive
// sides make their faces in parallel, and the faces are joined in the order of the sides.
//
// Facets that are triangles or, if the options allow it, simple polygons stay whole; others are cut
// into triangles between vertices of the complex, so there are no T-junctions. Points are rounded
// to the nearest doubles, once each, by exact arithmetic.
//
// Tested by tests/space/to_mesh_test.cpp.

#include "plumb/space/to_mesh.h"

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

#include "plumb/base/internal/parallel.h"
#include "plumb/base/internal/parallel_ranges.h"
#include "plumb/base/internal/part_charges.h"
#include "plumb/base/internal/union_find.h"
#include "plumb/base/internal/work_log.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/rounded_point3.h"
#include "plumb/space/mesh/closure_report.h"
#include "plumb/space/planar/facet_triangles.h"

namespace plumb {
namespace {

/// The bytes that are charged for each edge use (Weiler).
constexpr std::uint64_t kBytesPerUse = 60;
/// If there are fewer edge uses, vertices or sides, starting a thread takes more time than it
/// saves.
constexpr std::size_t kLeastUses = 4000;
constexpr std::size_t kLeastVertices = 1000;
constexpr std::size_t kLeastSides = 1000;

/// Calls visit(use) for all uses of a facet.
template <class Visit>
void for_uses(const SpaceComplex& complex, FacetId f, const Visit& visit) {
  for (const UseId first : complex.cycles_of(f)) {
    UseId u = first;
    do {
      visit(u);
      u = complex.use_next[u];
    } while (u != first);
  }
}

// ---------------------------------------------------------------- cones

/// Returns the number of the corner of a use, seen from a side.
std::uint32_t corner_of_use(UseId u, bool side) { return 2 * u.value() + (side ? 1 : 0); }
/// Returns the number of the corner of inner vertex i, an index of SpaceComplex::inner, seen from a
/// side. These corners come after those of uses.
std::uint32_t corner_of_inner(const SpaceComplex& complex, std::size_t i, bool side) {
  return static_cast<std::uint32_t>(2 * (complex.use_count() + i) + (side ? 1 : 0));
}

/// Corners of the sides of facets, joined where sides bound the same part of the solid along an
/// edge.
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
  std::size_t size() const { return classes_.size(); }
  /// Returns the cone of a corner.
  std::uint32_t root(std::uint32_t c) { return classes_.root(c); }
  /// Joins two cones. If a facet is around a vertex twice, one of the two vertices remains.
  void join(std::uint32_t a, std::uint32_t b) { classes_.unite(a, b); }

 private:
  /// A shown side at an edge.
  struct Entry {
    UseId use;
    bool side;
    bool is_solid_after;
  };

  /// Joins the corners of sides that bound the same part of the solid along an edge. A use of 2e is
  /// followed by the positive side of its facet, and the solid is behind the shown side.
  void join_around(EdgeId e) {
    ring_.clear();
    const UseId first = complex_.edge_use[e];
    if (!first.is_valid() || join_two(first)) return;
    UseId u = first;
    do {
      const SidesAtUse shown = shown_at(u);
      if (shown.is_before) ring_.push_back({u, shown.before_side, false});
      if (shown.is_after) ring_.push_back({u, !shown.before_side, true});
      u = complex_.use_radial[u];
    } while (u != first);
    // Shown sides alternate between those before and those behind a part of the solid.
    if (ring_.size() > 2) ++crowded_edges_;
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (ring_[i].is_solid_after) join_ends(ring_[i], ring_[i + 1 == ring_.size() ? 0 : i + 1]);
    }
  }

  /// Computes the same result for an edge with two uses, each with one shown side, as nearly all
  /// edges are. Returns false for any other edge.
  bool join_two(UseId u) {
    const UseId v = complex_.use_radial[u];
    if (v == u || complex_.use_radial[v] != u) return false;
    const SidesAtUse of_u = shown_at(u), of_v = shown_at(v);
    if (of_u.is_before == of_u.is_after || of_v.is_before == of_v.is_after) return false;
    const Entry a = entry(u, of_u), b = entry(v, of_v);
    if (a.is_solid_after) join_ends(a, b);
    if (b.is_solid_after) join_ends(b, a);
    return true;
  }

  /// Which sides of the facet of a use are shown: the side before it around the edge, and the side
  /// after it.
  struct SidesAtUse {
    bool is_before;
    bool is_after;
    bool before_side;  ///< The side before it.
  };
  SidesAtUse shown_at(UseId u) const {
    const auto& shown = shown_[complex_.use_facet[u].value()];
    const bool is_reverse = SpaceComplex::is_reverse(complex_.use_halfedge[u]);
    return {shown[is_reverse ? 1 : 0] != 0, shown[is_reverse ? 0 : 1] != 0, is_reverse};
  }
  /// Returns the only shown side at a use.
  static Entry entry(UseId u, const SidesAtUse& shown) {
    return {u, shown.before_side != shown.is_after, shown.is_after};
  }

  /// Joins the corners of two sides at both ends of an edge.
  void join_ends(const Entry& a, const Entry& b) {
    // If two sides have the same direction along the edge, their corners are at the same ends.
    const bool is_same_way = complex_.use_halfedge[a.use] == complex_.use_halfedge[b.use];
    const UseId a_end = complex_.use_next[a.use], b_end = complex_.use_next[b.use];
    join(corner_of_use(a.use, a.side), corner_of_use(is_same_way ? b.use : b_end, b.side));
    join(corner_of_use(a_end, a.side), corner_of_use(is_same_way ? b_end : b.use, b.side));
  }

  const SpaceComplex& complex_;
  std::span<const std::array<std::uint8_t, 2>> shown_;
  UnionFind classes_;  // The classes of corners.
  std::vector<Entry> ring_;
  std::uint32_t crowded_edges_ = 0;
};

// ---------------------------------------------------------------- vertices

using Shown = IdVector<FacetId, std::array<std::uint8_t, 2>>;

/// Returns for each facet which of its sides are shown.
Shown shown_sides(const SpaceComplex& complex, std::span<const FacetSide> sides) {
  Shown shown(complex.facet_count());
  for (const FacetSide& s : sides) shown[s.facet][s.is_reversed ? 1 : 0] = 1;
  return shown;
}

/// Calls visit(vertex, corner) for all corners of a side.
template <class Visit>
void for_corners(const SpaceComplex& complex, const FacetSide& s, const Visit& visit) {
  for_uses(complex, s.facet,
           [&](UseId u) { visit(complex.use_origin(u), corner_of_use(u, s.is_reversed)); });
  const std::uint32_t begin = complex.inner_begin[s.facet];
  const auto inner = complex.inner_of(s.facet);
  for (std::size_t i = 0; i < inner.size(); ++i) {
    visit(inner[i], corner_of_inner(complex, begin + i, s.is_reversed));
  }
}

/// A corner of a side: its vertex, and a number that depends on the step.
using NumberedCorner = std::pair<VertexId, std::uint32_t>;

/// Joins the cones of the corners that a side has at one vertex.
void keep_corners_together(const SpaceComplex& complex, std::span<const FacetSide> sides,
                           Cones& cones) {
  std::vector<NumberedCorner> corners;
  for (const FacetSide& s : sides) {
    corners.clear();
    for_corners(complex, s, [&](VertexId v, std::uint32_t corner) {
      corners.emplace_back(v, cones.root(corner));
    });
    if (corners.size() == 3) continue;
    std::sort(corners.begin(), corners.end());
    for (std::size_t i = 1; i < corners.size(); ++i) {
      if (corners[i].first == corners[i - 1].first) {
        cones.join(corners[i].second, corners[i - 1].second);
      }
    }
  }
}

/// The vertices of the mesh.
struct MeshNumbers {
  /// If vertices are split, the vertex of the mesh for each corner. Otherwise, the vertex of the
  /// mesh for each vertex of the complex.
  std::vector<std::uint32_t> number;
  std::vector<VertexId> vertex;     ///< The vertex of the complex of each vertex of the mesh.
  std::uint64_t non_manifold = 0;   ///< The number of vertices with several cones.
  std::uint64_t crowded_edges = 0;  ///< The number of edges with more than two shown sides.
};

/// Makes a vertex for each cone, or one for all cones of a vertex of the complex, in the order of
/// the complex.
MeshNumbers number_vertices(const SpaceComplex& complex, std::span<const FacetSide> sides,
                            bool split_vertices, Cones& cones) {
  if (split_vertices) keep_corners_together(complex, sides, cones);
  std::vector<std::uint32_t> first(complex.vertex_count(), kNone);
  // Most vertices have one cone, which is stored in `first`. Further cones go to a list that
  // remains short.
  std::vector<NumberedCorner> others;
  for (const FacetSide& s : sides) {
    for_corners(complex, s, [&](VertexId v, std::uint32_t corner) {
      const std::uint32_t cone = cones.root(corner);
      std::uint32_t& known = first[v.value()];
      if (known == kNone) known = cone;
      if (known != cone) others.emplace_back(v, cone);
    });
  }
  std::sort(others.begin(), others.end());
  others.erase(std::unique(others.begin(), others.end()), others.end());
  MeshNumbers result;
  result.number.resize(split_vertices ? cones.size() : first.size(), kNone);
  const auto add = [&](VertexId v, std::uint32_t cone) {
    result.number[split_vertices ? cone : v.value()] =
        static_cast<std::uint32_t>(result.vertex.size());
    result.vertex.push_back(v);
  };
  auto other = others.begin();
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    if (first[i] == kNone) continue;
    const VertexId v(i);
    add(v, first[i]);
    if (other != others.end() && other->first == v) ++result.non_manifold;
    for (; other != others.end() && other->first == v; ++other) {
      if (split_vertices) add(v, other->second);
    }
  }
  if (split_vertices) {  // The numbers of corners are those of their cones.
    for (std::uint32_t c = 0; c < cones.size(); ++c)
      result.number[c] = result.number[cones.root(c)];
  }
  result.crowded_edges = cones.crowded_edges();
  return result;
}

/// Whether each facet shows one side and has no inner vertices, and each edge has two uses.
bool has_two_uses_at_edges(const SpaceComplex& complex, const Shown& shown) {
  if (!complex.inner.empty()) return false;
  for (const auto& sides : shown) {
    if (sides[0] == sides[1]) return false;
  }
  for (std::uint32_t e = 0; e < complex.edge_count(); ++e) {
    const UseId u = complex.edge_use[EdgeId(e)];
    if (!u.is_valid()) return false;
    const UseId v = complex.use_radial[u];
    if (v == u || complex.use_radial[v] != u) return false;
  }
  return true;
}

/// Returns the number of corners in the cone of the corner at the origin of a use. Requires
/// has_two_uses_at_edges(). The walk leaves each corner through the edge through which it did not
/// enter.
std::uint32_t corners_of_cone(const SpaceComplex& complex, UseId first) {
  std::uint32_t count = 0;
  UseId u = first;
  // The walk leaves through the edge of u, not through the edge before it.
  bool is_leaving_ahead = true;
  do {
    const UseId through = is_leaving_ahead ? u : complex.use_prev[u];
    const UseId other = complex.use_radial[through];
    const bool is_same_way = complex.use_halfedge[through] == complex.use_halfedge[other];
    const bool is_at_origin = is_leaving_ahead == is_same_way;
    u = is_at_origin ? other : complex.use_next[other];
    is_leaving_ahead = !is_at_origin;
    ++count;
  } while (u != first);
  return count;
}

/// Computes the result of number_vertices() without splitting. Requires has_two_uses_at_edges(). A
/// walk around a vertex determines whether it has one cone.
MeshNumbers number_by_walks(const SpaceComplex& complex) {
  std::vector<UseId> first(complex.vertex_count());
  std::vector<std::uint32_t> corners(complex.vertex_count(), 0);
  for (std::uint32_t u = 0; u < complex.use_count(); ++u) {
    const std::uint32_t v = complex.use_origin(UseId(u)).value();
    first[v] = UseId(u);
    ++corners[v];
  }
  MeshNumbers result;
  result.number.resize(first.size(), kNone);
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    if (corners[v] == 0) continue;
    result.number[v] = static_cast<std::uint32_t>(result.vertex.size());
    result.vertex.emplace_back(v);
    if (corners_of_cone(complex, first[v]) != corners[v]) ++result.non_manifold;
  }
  return result;
}

using NearestPoints = IdVector<VertexId, RoundedPoint3>;

/// Returns the vertices at corners of the sides in ascending order. It contains at least all
/// vertices that number_vertices() numbers.
std::vector<VertexId> corner_vertices(const SpaceComplex& complex,
                                      std::span<const FacetSide> sides) {
  IdVector<VertexId, std::uint8_t> is_corner(complex.vertex_count(), 0);
  // Each facet has a side, so the links need not be followed.
  if (sides.size() == complex.facet_count()) {
    for (std::uint32_t u = 0; u < complex.use_count(); ++u) {
      is_corner[complex.use_origin(UseId(u))] = 1;
    }
    for (const VertexId v : complex.inner) is_corner[v] = 1;
  } else {
    for (const FacetSide& s : sides) {
      for_uses(complex, s.facet, [&](UseId u) { is_corner[complex.use_origin(u)] = 1; });
      for (const VertexId v : complex.inner_of(s.facet)) is_corner[v] = 1;
    }
  }
  std::vector<VertexId> vertices;
  for (std::uint32_t v = 0; v < is_corner.size(); ++v) {
    if (is_corner[VertexId(v)] != 0) vertices.emplace_back(v);
  }
  return vertices;
}

/// Returns the nearest doubles of each vertex at a corner of the sides.
NearestPoints nearest_points(const SpaceComplex& complex, std::span<const FacetSide> sides,
                             Context& context) {
  const std::vector<VertexId> vertices = corner_vertices(complex, sides);
  NearestPoints nearest(complex.vertex_count());
  run_ranges(context, vertices.size(), kLeastVertices,
             [&](std::size_t, std::size_t begin, std::size_t end, Context& own) {
               own.check_limits("rounding");
               for (std::size_t i = begin; i < end; ++i) {
                 nearest[vertices[i]] =
                     rounded(complex.points(), complex.vertex_point[vertices[i]]);
               }
             });
  return nearest;
}

/// Adds the points of the vertices to the mesh, and lists those that were rounded.
void add_points(const SpaceComplex& complex, std::span<const VertexId> vertices,
                const NearestPoints& nearest, bool keeps_exact, MeshOfComplex& out) {
  PolygonMesh& mesh = out.mesh;
  mesh.points.reserve(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const VertexId v = vertices[i];
    mesh.points.push_back(nearest[v].at);
    if (nearest[v].is_exact) continue;
    out.rounded.emplace_back(i, v);
    if (keeps_exact) mesh.exact.emplace_back(i, exact(complex.points(), complex.vertex_point[v]));
  }
}

// ---------------------------------------------------------------- faces

/// Adds the faces of one side after the other to a mesh. It is a class because all sides share the
/// buffers of the current side. Several writers may work at the same time.
class FaceWriter {
 public:
  FaceWriter(const SpaceComplex& complex, const ToMeshOptions& options, const MeshNumbers& numbers,
             std::span<const RoundedPoint3> nearest, MeshOfComplex& out)
      : complex_(complex),
        options_(options),
        numbers_(numbers),
        nearest_(nearest),
        cutter_(complex),
        out_(out) {
    cutter_.use_nearest(nearest);
  }

  /// Adds the face or faces of a side.
  void add_faces(const FacetSide& s) {
    if (add_triangle(s)) return;
    corners_.clear();
    for_corners(complex_, s,
                [&](VertexId v, std::uint32_t c) { corners_.emplace_back(v, number(v, c)); });
    // Corners have the order of the cycle, which is counter-clockwise seen from the positive side.
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

 private:
  /// Adds the face of a facet with three corners and no inner vertices, as most facets are. Returns
  /// false for other facets.
  bool add_triangle(const FacetSide& s) {
    const auto cycles = complex_.cycles_of(s.facet);
    const UseId a = cycles[0], b = complex_.use_next[a], c = complex_.use_next[b];
    if (complex_.use_next[c] != a || cycles.size() > 1 || !complex_.inner_of(s.facet).empty()) {
      return false;
    }
    const auto corner = [&](UseId u) {
      return number(complex_.use_origin(u), corner_of_use(u, s.is_reversed));
    };
    const UseId first = s.is_reversed ? c : a, last = s.is_reversed ? a : c;
    out_.mesh.add_face(std::array{corner(first), corner(b), corner(last)});
    out_.facet.push_back(s.facet);
    return true;
  }

  /// Returns the vertex of the mesh at a corner.
  std::uint32_t number(VertexId v, std::uint32_t corner) const {
    return numbers_.number[options_.split_vertices ? corner : v.value()];
  }
  std::uint32_t number_at(VertexId v) const {
    return std::ranges::lower_bound(corners_, v, {}, [](const auto& c) { return c.first; })->second;
  }

  /// Whether the facet may remain one polygon. Requires its corners in order in corners_.
  bool can_be_polygon(FacetId f) {
    if (options_.faces == MeshFaces::Triangles) return false;
    if (complex_.cycles_of(f).size() > 1 || !complex_.inner_of(f).empty()) return false;
    seen_.resize(complex_.vertex_count(), 0);
    ++polygons_;
    for (const auto& [v, number] : corners_) {
      const bool is_double = nearest_[v.value()].is_exact;
      if (!is_double && options_.faces == MeshFaces::PlanarPolygons) return false;
      if (seen_[v] == polygons_) return false;
      seen_[v] = polygons_;
    }
    return true;
  }

  void add_face(const FacetSide& s) {
    if (s.is_reversed) std::reverse(face_.begin(), face_.end());
    out_.mesh.add_face(face_);
    out_.facet.push_back(s.facet);
  }

  const SpaceComplex& complex_;
  const ToMeshOptions& options_;
  const MeshNumbers& numbers_;
  std::span<const RoundedPoint3> nearest_;  // For each vertex of the complex that has a number.
  FacetTriangles cutter_;
  MeshOfComplex& out_;
  std::vector<NumberedCorner> corners_;  // The corners of the side, with vertices of the mesh.
  std::vector<std::uint32_t> face_;
  // For each vertex, the last polygon at it, as a value of polygons_.
  IdVector<VertexId, std::uint32_t> seen_;
  std::uint32_t polygons_ = 0;
};

/// Appends the faces of a part of the sides to those of the mesh.
void append_faces(const MeshOfComplex& part, MeshOfComplex& out) {
  const auto shift = static_cast<std::uint32_t>(out.mesh.corners.size());
  const auto begins = part.mesh.face_begin.begin();
  out.mesh.corners.insert(out.mesh.corners.end(), part.mesh.corners.begin(),
                          part.mesh.corners.end());
  std::transform(begins + 1, part.mesh.face_begin.end(), std::back_inserter(out.mesh.face_begin),
                 [shift](std::uint32_t begin) { return begin + shift; });
  out.facet.insert(out.facet.end(), part.facet.begin(), part.facet.end());
}

/// Returns the size of the arrays of a part.
std::uint64_t bytes_of_faces(const MeshOfComplex& part) {
  return sizeof(part.mesh.corners[0]) * part.mesh.corners.capacity() +
         sizeof(part.mesh.face_begin[0]) * part.mesh.face_begin.capacity() +
         sizeof(part.facet[0]) * part.facet.capacity();
}

/// The data from which the faces of the sides are made.
struct FaceInput {
  const SpaceComplex& complex;
  std::span<const FacetSide> sides;
  const ToMeshOptions& options;
  const MeshNumbers& numbers;
  const NearestPoints& nearest;
};

/// Adds the faces of the sides to the mesh. The first range of the sides is written directly to the
/// mesh. Each other range is written to a separate part, which is appended.
void add_all_faces(const FaceInput& in, MeshOfComplex& out, Context& context) {
  const std::size_t count = in.sides.size();
  out.mesh.face_begin.reserve(count + 1);
  out.mesh.corners.reserve(3 * count);
  out.facet.reserve(count);
  std::vector<MeshOfComplex> parts(count_ranges(context, count, kLeastSides) - 1);
  PartCharges charges(context, parts.size());
  run_ranges(context, count, kLeastSides,
             [&](std::size_t range, std::size_t begin, std::size_t end, Context& own) {
               MeshOfComplex& part = range == 0 ? out : parts[range - 1];
               const auto charge = [&] {
                 if (range > 0) charges.raise(range - 1, bytes_of_faces(part), "a mesh", own);
               };
               FaceWriter writer(in.complex, in.options, in.numbers, in.nearest, part);
               for (std::size_t i = begin; i < end; ++i) {
                 if (i % 4096 == 0) {
                   own.checkpoint("faces of the mesh", i, count);
                   charge();
                 }
                 writer.add_faces(in.sides[i]);
               }
               charge();
             });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    append_faces(parts[i], out);
    parts[i] = {};
    charges.release(i);
  }
}

// ---------------------------------------------------------------- what is left out

/// Counts marked cells outside of the closure of the interior, and unmarked cells in it. Cells
/// inside of it and on its boundary are counted separately.
class ClosureCount {
 public:
  ClosureCount(const SpaceComplex& complex, ToMeshReport& report)
      : complex_(complex), report_(report) {}

  void run() {
    if (has_only_boundary()) return count_boundary();
    edges_.assign(complex_.edge_count(), kNothing);
    vertices_.assign(complex_.vertex_count(), kNothing);
    look_at_facets();
    look_at_free_cells();
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) {
      count(complex_.edge_mark[e], edges_[e], &ItemCounts::edges);
    }
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
      count(complex_.vertex_mark[v], vertices_[v], &ItemCounts::vertices);
    }
  }

 private:
  /// The volumes around a cell: one bit for marked volumes, and one bit for other volumes.
  using Around = std::uint8_t;
  static constexpr Around kNothing = 0, kMarked = 1, kUnmarked = 2, kBoth = kMarked | kUnmarked;

  /// Whether each facet has volumes of both kinds beside it, and each edge has a facet.
  bool has_only_boundary() const {
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      if (around_facet(FacetId(f)) != kBoth) return false;
    }
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) {
      if (!complex_.edge_use[e].is_valid()) return false;
    }
    return true;
  }
  /// Counts all cells in that case without following links, because each vertex that is not
  /// isolated in a volume has a facet, too.
  void count_boundary() {
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      count(complex_.facet_mark[f], kBoth, &ItemCounts::facets);
    }
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) {
      count(complex_.edge_mark[e], kBoth, &ItemCounts::edges);
    }
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
      const VolumeId isolated_in = complex_.vertex_volume[v];
      count(complex_.vertex_mark[v], isolated_in.is_valid() ? around_volume(isolated_in) : kBoth,
            &ItemCounts::vertices);
    }
  }

  /// Counts the facets, and notes the volumes beside them at their edges and vertices. These are
  /// all volumes around an edge or a vertex with facets.
  void look_at_facets() {
    for (std::uint32_t f = 0; f < complex_.facet_count(); ++f) {
      const Around around = around_facet(FacetId(f));
      count(complex_.facet_mark[f], around, &ItemCounts::facets);
      for (const VertexId v : complex_.inner_of(FacetId(f))) vertices_[v.value()] |= around;
    }
    for (std::uint32_t u = 0; u < complex_.use_count(); ++u) {
      const Around around = around_facet(complex_.use_facet[u]);
      const HalfedgeId h = complex_.use_halfedge[u];
      edges_[h.value() / 2] |= around;
      vertices_[complex_.origin[h.value()].value()] |= around;
    }
  }
  /// Notes the volumes around edges and vertices without facets.
  void look_at_free_cells() {
    for (std::uint32_t e = 0; e < complex_.edge_count(); ++e) {
      if (complex_.edge_use[e].is_valid()) continue;
      const Around around = around_volume(complex_.edge_volume[e]);
      edges_[e] |= around;
      for (const std::uint32_t h : {2 * e, 2 * e + 1}) {
        vertices_[complex_.origin[h].value()] |= around;
      }
    }
    for (std::uint32_t v = 0; v < complex_.vertex_count(); ++v) {
      vertices_[v] |= around_volume(complex_.vertex_volume[v]);
    }
  }

  void count(Mark mark, Around around, std::uint64_t ItemCounts::*kind) {
    if (mark == 1 && (around & kMarked) == 0) ++(report_.dropped.*kind);
    if (mark == 0 && (around & kMarked) != 0) {
      // The member is selected by name, because g++ 12 would increment a copy if the conditional
      // stood before .* itself.
      ItemCounts& counts = (around & kUnmarked) != 0 ? report_.closed : report_.filled;
      ++(counts.*kind);
    }
  }

  Around around_volume(VolumeId v) const {
    if (!v.is_valid()) return kNothing;
    return complex_.volume_mark[v] == 1 ? kMarked : kUnmarked;
  }
  Around around_facet(FacetId f) const {
    const auto& [above, below] = complex_.facet_volume[f];
    return around_volume(above) | around_volume(below);
  }

  const SpaceComplex& complex_;
  ToMeshReport& report_;
  std::vector<Around> edges_, vertices_;  // One entry for each edge and each vertex.
};

/// Whether a marked volume is volume 0 or meets the frame.
bool is_unbounded(const SpaceComplex& complex) {
  if (complex.volume_count() > 0 && complex.volume_mark[0] == 1) return true;
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    if (complex.facet_mark[f] != kBeyond) continue;
    for (const VolumeId v : complex.facet_volume[f]) {
      if (v.is_valid() && complex.volume_mark[v] == 1) return true;
    }
  }
  return false;
}

}  // namespace

// A side is reversed if the solid lies on the positive side, because faces must be seen from
// outside.
std::vector<FacetSide> boundary_sides(const SpaceComplex& complex) {
  std::vector<FacetSide> sides;
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    const Mark above = complex.volume_mark[complex.facet_volume[f][0]];
    const Mark below = complex.volume_mark[complex.facet_volume[f][1]];
    if ((above == 1) != (below == 1)) sides.push_back({FacetId(f), above == 1});
  }
  return sides;
}

namespace {

/// Returns the mesh of the sides. Calls `beside` as a job at the same time as the first steps.
MeshOfComplex mesh_beside(const SpaceComplex& complex, std::span<const FacetSide> sides,
                          const ToMeshOptions& options, const std::function<void()>& beside,
                          Context& context) {
  MemoryCharge memory(context);
  memory.add(kBytesPerUse * complex.use_count() + sizeof(RoundedPoint3) * complex.vertex_count(),
             "a mesh");
  MeshOfComplex out;
  MeshNumbers numbers;
  NearestPoints nearest;
  const auto make = [&](std::size_t i, Context& own) {
    if (i == 0) {
      const WorkPhase phase("vertices of the mesh");
      const Shown shown = shown_sides(complex, sides);
      if (!options.split_vertices && has_two_uses_at_edges(complex, shown)) {
        numbers = number_by_walks(complex);
      } else {
        Cones cones(complex, shown);
        numbers = number_vertices(complex, sides, options.split_vertices, cones);
      }
    } else if (i == 1) {
      const WorkPhase phase("rounding");
      nearest = nearest_points(complex, sides, own);
    } else {
      beside();
    }
  };
  if (complex.use_count() < kLeastUses) {
    for (const std::size_t i : {0U, 1U, 2U}) make(i, context);
  } else {
    run_jobs(context, 3, make);
  }
  const WorkPhase phase("faces of the mesh");
  add_points(complex, numbers.vertex, nearest, options.keeps_exact, out);
  add_all_faces({complex, sides, options, numbers, nearest}, out, context);
  out.report.non_manifold_edges = numbers.crowded_edges;
  out.report.non_manifold_vertices = numbers.non_manifold;
  return out;
}

}  // namespace

MeshOfComplex mesh_of_sides(const SpaceComplex& complex, std::span<const FacetSide> sides,
                            const ToMeshOptions& options, Context& context) {
  return mesh_beside(
      complex, sides, options, [] {}, context);
}

MeshOfComplex mesh_of_complex(const SpaceComplex& complex, const ToMeshOptions& options,
                              Context& context) {
  const WorkPhase phase("mesh from set");
  if (is_unbounded(complex)) {
    MeshOfComplex nothing;
    nothing.report.is_unbounded = true;
    return nothing;
  }
  ToMeshReport counts;
  const auto count = [&] {
    const WorkPhase counting("cells left out");
    ClosureCount(complex, counts).run();
  };
  MeshOfComplex result = mesh_beside(complex, boundary_sides(complex), options, count, context);
  result.report.dropped = counts.dropped;
  result.report.filled = counts.filled;
  result.report.closed = counts.closed;
  return result;
}

ToMeshReport closure_report(const SpaceComplex& complex) {
  ToMeshReport report;
  ClosureCount(complex, report).run();
  return report;
}

bool is_unbounded(const SpaceComplex& complex, FacetId f) {
  bool is_far = false;
  for_uses(complex, f,
           [&](UseId u) { is_far |= complex.vertex_mark[complex.use_origin(u)] == kBeyond; });
  return is_far;
}

// Facets inside or outside of the solid are shown from their positive side, and facets on its
// boundary from outside. All facets are shown, so none counts as dropped.
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
    const Mark above = complex.volume_mark[complex.facet_volume[f][0]];
    const Mark below = complex.volume_mark[complex.facet_volume[f][1]];
    sides.push_back({FacetId(f), above == 1 && below != 1});
  }
  MeshOfComplex result = mesh_of_sides(complex, sides, options, context);
  ClosureCount(complex, result.report).run();
  result.report.dropped.facets = 0;
  result.report.is_unbounded = has_far;
  return result;
}

}  // namespace plumb
