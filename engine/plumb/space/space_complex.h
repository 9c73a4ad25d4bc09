// A marked subdivision of space. Every set of space is stored in this form. The vertices, edges,
// facets and volumes are stored in flat arrays. Each of these cells has a mark that states whether
// its points belong to the set.
//
// Notation
//   edge e       lies on the line where two planes p and q intersect; edge_planes[e] = {p, q}.
//                Half-edge 2 e has the direction of the cross product of n_p and n_q, the normals
//                of these planes. The other half-edge, 2 e + 1, has the opposite direction
//   use u        is an edge use: one occurrence of an edge on the boundary of a facet (K. Weiler,
//                The radial edge structure, in: Geometric Modeling for CAD Applications, 1988). The
//                use runs along use_halfedge[u]. Seen from the positive side of the (canonical)
//                plane of the facet, the facet is to the left of the use. The corner of a use is
//                the corner of its facet at the origin of the use. The corner sweeps
//                counter-clockwise from use_halfedge[u] to the reverse of use_halfedge[use_prev[u]]
//   radial       is the cyclic order of all uses of edge e. The order is counter-clockwise for a
//                viewer who looks against the direction of half-edge 2 e. A volume lies between
//                each use and the next use. After a use of half-edge 2 e, this volume is on the
//                positive side of the use's facet. After a use of half-edge 2 e + 1, this volume is
//                on the negative side
//   facet f      has a plane, a mark, boundary cycles (the outer cycle first, then the holes), and
//                vertices inside it. It also has one volume on its positive side [0], and one
//                volume on its negative side [1]
//   volume 0     is the volume that reaches to infinity, if the set is bounded. If the set is
//                unbounded, volume 0 is the volume outside the frame
//
// The sphere map of a vertex (local_maps.h) is not stored, because it can be read from these
// arrays. The points of the map are the half-edges that leave the vertex. The arcs of the map are
// the corners of uses at the vertex. The faces of the map are the parts of volumes around the
// vertex. These parts are found from the sides of facets.
//
// Free cells:
// - For an edge without uses, edge_volume holds the volume that contains the edge, and edge_use
//   holds the invalid id.
// - For a vertex inside a facet, vertex_facet holds the facet, and the facet's list in `inner`
//   contains the vertex. The sphere map of such a vertex has a loop. Edges outside the facet may
//   end at the vertex.
// - For a vertex at which no edge ends and that lies in no facet, vertex_volume holds the volume
//   that contains the vertex.
//
// Frame: an unbounded set is cut off at the cube |x|, |y|, |z| <= R, where R is greater than all
// numbers. Cells on the boundary of the cube and outside the cube have the mark kBeyond, and are
// never shown to users.
//
// audit() in space_audit.h checks the invariants. Sources: docs/design/boolean.md, sphere.md and
// frame.md.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/base/marks.h"
#include "plumb/space/complex/space_tables.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The cells of a subdivision of space and their incidences, in flat arrays. The head of this file
/// explains the notation.
struct SpaceComplex {
  std::shared_ptr<const SpaceTables> tables;  ///< Planes and points, shared by copies.

  // One entry for each vertex.
  IdVector<VertexId, SpacePoint> vertex_point;  ///< The point of each vertex, an id in `tables`.
  IdVector<VertexId, Mark> vertex_mark;         ///< Whether the vertex belongs to the set.
  IdVector<VertexId, VolumeId>
      vertex_volume;  ///< The volume around an isolated vertex; invalid for other vertices.
  IdVector<VertexId, FacetId>
      vertex_facet;  ///< The facet that contains the vertex; invalid if there is none.
  /// The index in `star` at which the half-edges of each vertex start; vertex_count() + 1 entries.
  IdVector<VertexId, std::uint32_t> star_begin;
  std::vector<HalfedgeId> star;  ///< The half-edges that leave each vertex.

  // These arrays have one entry for each edge. Only `origin` has one entry for each half-edge.
  /// Two planes whose intersection is the line of the edge.
  IdVector<EdgeId, std::array<PlaneId, 2>> edge_planes;
  IdVector<EdgeId, Mark> edge_mark;        ///< Whether the edge belongs to the set.
  IdVector<EdgeId, UseId> edge_use;        ///< One use of the edge; invalid if the edge is free.
  IdVector<EdgeId, VolumeId> edge_volume;  ///< The volume that contains a free edge.
  IdVector<HalfedgeId, VertexId> origin;   ///< The vertex at which each half-edge begins.

  // One entry for each edge use.
  IdVector<UseId, HalfedgeId>
      use_halfedge;  ///< The half-edge of the edge in the direction of the facet's cycle.
  IdVector<UseId, UseId> use_next;     ///< The next use along the cycle.
  IdVector<UseId, UseId> use_prev;     ///< The previous use along the cycle.
  IdVector<UseId, UseId> use_radial;   ///< The next use around the same edge.
  IdVector<UseId, FacetId> use_facet;  ///< The facet that the use bounds.

  // One entry for each facet.
  IdVector<FacetId, PlaneId> facet_plane;  ///< The plane; its normal points to the positive side.
  IdVector<FacetId, Mark> facet_mark;      ///< Whether the facet belongs to the set.
  /// The volumes on the positive [0] and negative [1] side of the facet.
  IdVector<FacetId, std::array<VolumeId, 2>> facet_volume;
  IdVector<FacetId, std::uint32_t>
      facet_origin;  ///< The id that the caller gave to the facet; results of operations keep it.
  /// The index in `cycle` at which the cycles of each facet start; facet_count() + 1 entries.
  IdVector<FacetId, std::uint32_t> cycle_begin;
  std::vector<UseId> cycle;  ///< One use of each cycle of a facet, the outer cycle first.
  /// The index in `inner` at which the vertices inside each facet start; facet_count() + 1 entries.
  IdVector<FacetId, std::uint32_t> inner_begin;
  std::vector<VertexId> inner;  ///< The vertices inside each facet.

  IdVector<VolumeId, Mark> volume_mark;  ///< Whether each volume belongs to the set.

  // The counts of cells include the cells of the frame.

  /// Returns the count of vertices.
  std::size_t vertex_count() const { return vertex_point.size(); }
  std::size_t edge_count() const { return edge_planes.size(); }  ///< Returns the count of edges.
  /// Returns the number of edge uses.
  std::size_t use_count() const { return use_halfedge.size(); }
  std::size_t facet_count() const { return facet_plane.size(); }  ///< Returns the count of facets.
  /// Returns the number of volumes. If there is a frame, this includes the volume beyond the frame.
  std::size_t volume_count() const { return volume_mark.size(); }

  /// Returns the half-edge of the same edge in the other direction.
  static HalfedgeId twin(HalfedgeId h) { return HalfedgeId(h.value() ^ 1U); }
  /// Returns the edge of a half-edge.
  static EdgeId edge_of(HalfedgeId h) { return EdgeId(h.value() >> 1U); }
  /// Whether the half-edge has an odd id. Its direction is then opposite to the cross product of
  /// n_p and n_q.
  static bool is_reverse(HalfedgeId h) { return (h.value() & 1U) != 0; }
  /// Returns the vertex at which a half-edge ends.
  VertexId target(HalfedgeId h) const { return origin[h.value() ^ 1U]; }
  /// Returns the half-edges that leave a vertex.
  std::span<const HalfedgeId> star_of(VertexId v) const {
    return std::span(star).subspan(star_begin[v], star_begin[v.value() + 1] - star_begin[v]);
  }
  /// Returns one use of each cycle of a facet, the outer cycle first.
  std::span<const UseId> cycles_of(FacetId f) const {
    return std::span(cycle).subspan(cycle_begin[f], cycle_begin[f.value() + 1] - cycle_begin[f]);
  }
  /// Returns the vertices inside a facet.
  std::span<const VertexId> inner_of(FacetId f) const {
    return std::span(inner).subspan(inner_begin[f], inner_begin[f.value() + 1] - inner_begin[f]);
  }
  /// Returns the vertex at which a use begins.
  VertexId use_origin(UseId u) const { return origin[use_halfedge[u]]; }
  /// Returns the volume between a use of an edge and the next use in radial order.
  VolumeId volume_after(UseId u) const {
    return facet_volume[use_facet[u]][is_reverse(use_halfedge[u]) ? 1 : 0];
  }
  /// Fills star_begin and star from `origin`. `vertices` is the number of vertices. The half-edges
  /// of each vertex are listed in ascending order. Takes linear time.
  void list_stars(std::size_t vertices) {
    star_begin.assign(vertices + 1, 0);
    for (const VertexId v : origin) ++star_begin[v.value() + 1];
    std::partial_sum(star_begin.begin(), star_begin.end(), star_begin.begin());
    star.resize(origin.size());
    IdVector<VertexId, std::uint32_t> next(star_begin.begin(), star_begin.end() - 1);
    for (std::uint32_t h = 0; h < origin.size(); ++h) star[next[origin[h]]++] = HalfedgeId(h);
  }
  const PlaneTable& planes() const { return tables->planes; }   ///< Returns the planes.
  const Point3Table& points() const { return tables->points; }  ///< Returns the points.
};

/// The id of a cell of any kind: a vertex, an edge, a facet or a volume. It takes 32 bits. A
/// default-constructed item is invalid.
class SpaceItem {
 public:
  /// Kinds of items, by dimension.
  enum class Kind : std::uint32_t { Vertex, Edge, Facet, Volume };

  /// Makes an invalid item.
  constexpr SpaceItem() = default;
  /// Makes the item of a vertex.
  constexpr SpaceItem(VertexId v) : SpaceItem(Kind::Vertex, v.value()) {}
  /// Makes the item of an edge.
  constexpr SpaceItem(EdgeId e) : SpaceItem(Kind::Edge, e.value()) {}
  /// Makes the item of a facet.
  constexpr SpaceItem(FacetId f) : SpaceItem(Kind::Facet, f.value()) {}
  /// Makes the item of a volume.
  constexpr SpaceItem(VolumeId v) : SpaceItem(Kind::Volume, v.value()) {}

  /// Returns the item for which code() returns `code`.
  static constexpr SpaceItem from_code(std::uint32_t code) {
    SpaceItem item;
    item.code_ = code;
    return item;
  }

  /// Whether the item is valid. All other members except code() require a valid item.
  constexpr bool is_valid() const { return code_ != ~std::uint32_t{0}; }
  /// Returns the kind of the item.
  constexpr Kind kind() const { return static_cast<Kind>(code_ >> 30U); }
  /// Returns the index of the item among the items of the same kind.
  constexpr std::uint32_t index() const { return code_ & 0x3fffffffU; }
  /// Returns the kind and the index in 32 bits.
  constexpr std::uint32_t code() const { return code_; }
  constexpr VertexId vertex() const { return VertexId(index()); }  ///< Requires Kind::Vertex.
  constexpr EdgeId edge() const { return EdgeId(index()); }        ///< Requires Kind::Edge.
  constexpr FacetId facet() const { return FacetId(index()); }     ///< Requires Kind::Facet.
  constexpr VolumeId volume() const { return VolumeId(index()); }  ///< Requires Kind::Volume.
  friend constexpr auto operator<=>(SpaceItem, SpaceItem) = default;

 private:
  constexpr SpaceItem(Kind kind, std::uint32_t index)
      : code_((static_cast<std::uint32_t>(kind) << 30U) | index) {}
  std::uint32_t code_ = ~std::uint32_t{0};
};

}  // namespace plumb
#pragma GCC visibility pop
