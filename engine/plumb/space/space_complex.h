// A marked subdivision of space, the form in which every set of space is held: vertices, edges,
// facets and volumes in flat arrays, each with a mark that says whether it belongs to the set.
//
// Notation
//   edge e       lies on the line of edge_planes[e] = {p, q}; half-edge 2e runs along n_p x n_q,
//                half-edge 2e + 1 the other way
//   use u        is an edge on the boundary of a facet, an "edge use" (K. Weiler, The radial edge
//                structure, in: Geometric Modeling for CAD Applications, 1988). It runs along
//                use_halfedge[u], with the facet to its left, seen from the positive side of the
//                facet's (canonical) plane. The corner of a use is the corner of its facet at its
//                origin, which sweeps counter-clockwise from use_halfedge[u] to the reverse of
//                use_halfedge[use_prev[u]].
//   radial       is the order of the uses of both half-edges of e, counter-clockwise around 2e,
//                seen so that its direction points at the viewer. After a use of 2e follows the
//                volume on the positive side of its facet; after a use of 2e + 1, the volume on the
//                negative side.
//   facet f      has a plane, a mark, a volume on its positive [0] and negative [1] side, boundary
//                cycles (the outer one first, then holes), and vertices inside it
//   volume 0     reaches to infinity in a bounded set; otherwise it is the volume beyond the frame
//
// The sphere map of a vertex (local_maps.h) is a view of these arrays: its points are the
// half-edges that leave the vertex, its arcs the corners of uses, its faces the sides of facets.
//
// Free cells: an edge without uses lies in the volume edge_volume. A vertex inside a facet (its
// sphere map has a loop; edges may leave it all the same) has vertex_facet and is listed in `inner`
// of that facet. A vertex with neither half-edges nor a facet lies in vertex_volume.
//
// Frame: an unbounded set is cut by a cube |x|, |y|, |z| <= R with R beyond all bounds. What lies
// on the cube and beyond it has the mark kBeyond and is never shown to users.
//
// audit() in space_audit.h checks the invariants. Sources: docs/design/boolean.md, sphere.md and
// frame.md.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/base/marks.h"
#include "plumb/space/complex/space_tables.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The cells of a subdivision of space and their incidences, in flat arrays. See the head of this
/// file for the notation.
struct SpaceComplex {
  std::shared_ptr<const SpaceTables> tables;  ///< Planes and points, shared by copies.

  // One entry for each vertex.
  std::vector<SpacePoint> vertex_point;   ///< Its place, an id in `tables`.
  std::vector<Mark> vertex_mark;          ///< Whether it belongs to the set.
  std::vector<VolumeId> vertex_volume;    ///< Its volume if it is isolated; else invalid.
  std::vector<FacetId> vertex_facet;      ///< Its facet if it is inside one; else invalid.
  std::vector<std::uint32_t> star_begin;  ///< Starts in `star`, vertex_count() + 1 of them.
  std::vector<HalfedgeId> star;           ///< Half-edges that leave each vertex.

  // One entry for each edge; `origin` has one for each half-edge.
  std::vector<std::array<PlaneId, 2>> edge_planes;  ///< Two planes that meet in its line.
  std::vector<Mark> edge_mark;                      ///< Whether it belongs to the set.
  std::vector<UseId> edge_use;                      ///< One of its uses; invalid if free.
  std::vector<VolumeId> edge_volume;                ///< Its volume if it is free.
  std::vector<VertexId> origin;                     ///< Where each half-edge begins.

  // One entry for each edge use.
  std::vector<HalfedgeId> use_halfedge;  ///< Its edge, in the direction of the facet's cycle.
  std::vector<UseId> use_next;           ///< The next use along the cycle.
  std::vector<UseId> use_prev;           ///< The previous use along the cycle.
  std::vector<UseId> use_radial;         ///< The next use around the same edge.
  std::vector<FacetId> use_facet;        ///< The facet that it bounds.

  // One entry for each facet.
  std::vector<PlaneId> facet_plane;  ///< Its plane; the normal points to its positive side.
  std::vector<Mark> facet_mark;      ///< Whether it belongs to the set.
  /// The volumes on its positive [0] and negative [1] side.
  std::vector<std::array<VolumeId, 2>> facet_volume;
  std::vector<std::uint32_t> facet_origin;  ///< Id given by its maker and carried along.
  std::vector<std::uint32_t> cycle_begin;   ///< Starts in `cycle`, facet_count() + 1 of them.
  std::vector<UseId> cycle;                 ///< One use of each cycle, the outer cycle first.
  std::vector<std::uint32_t> inner_begin;   ///< Starts in `inner`, facet_count() + 1 of them.
  std::vector<VertexId> inner;              ///< Vertices inside each facet.

  std::vector<Mark> volume_mark;  ///< Whether each volume belongs to the set.

  // The numbers of cells include the cells of the frame.

  std::size_t vertex_count() const { return vertex_point.size(); }  ///< Returns how many vertices.
  std::size_t edge_count() const { return edge_planes.size(); }     ///< Returns how many edges.
  /// Returns the number of edge uses.
  std::size_t use_count() const { return use_halfedge.size(); }
  std::size_t facet_count() const { return facet_plane.size(); }  ///< Returns how many facets.
  /// Returns the number of volumes, with the one beyond the frame if there is a frame.
  std::size_t volume_count() const { return volume_mark.size(); }

  /// Returns the half-edge of the same edge in the other direction.
  static HalfedgeId twin(HalfedgeId h) { return HalfedgeId(h.value() ^ 1U); }
  /// Returns the edge of a half-edge.
  static EdgeId edge_of(HalfedgeId h) { return EdgeId(h.value() >> 1U); }
  /// Whether the half-edge is the one of its edge with an odd id.
  static bool is_reverse(HalfedgeId h) { return (h.value() & 1U) != 0; }
  /// Returns the vertex at which a half-edge ends.
  VertexId target(HalfedgeId h) const { return origin[h.value() ^ 1U]; }
  /// Returns the half-edges that leave a vertex.
  std::span<const HalfedgeId> star_of(VertexId v) const {
    return std::span(star).subspan(star_begin[v.value()],
                                   star_begin[v.value() + 1] - star_begin[v.value()]);
  }
  /// Returns one use of each cycle of a facet, the outer cycle first.
  std::span<const UseId> cycles_of(FacetId f) const {
    return std::span(cycle).subspan(cycle_begin[f.value()],
                                    cycle_begin[f.value() + 1] - cycle_begin[f.value()]);
  }
  /// Returns the vertices inside a facet.
  std::span<const VertexId> inner_of(FacetId f) const {
    return std::span(inner).subspan(inner_begin[f.value()],
                                    inner_begin[f.value() + 1] - inner_begin[f.value()]);
  }
  /// Returns the vertex at which a use begins.
  VertexId use_origin(UseId u) const { return origin[use_halfedge[u.value()].value()]; }
  /// Returns the volume that follows the use in radial order.
  VolumeId volume_after(UseId u) const {
    return facet_volume[use_facet[u.value()].value()][is_reverse(use_halfedge[u.value()]) ? 1 : 0];
  }
  const PlaneTable& planes() const { return tables->planes; }   ///< Returns the planes.
  const Point3Table& points() const { return tables->points; }  ///< Returns the points.
};

/// The name of a vertex, edge, facet or volume, in 32 bits. A default-constructed item is invalid.
class SpaceItem {
 public:
  /// Kinds of items, by dimension.
  enum class Kind : std::uint32_t { Vertex, Edge, Facet, Volume };

  constexpr SpaceItem() = default;                                         ///< Names nothing.
  constexpr SpaceItem(VertexId v) : SpaceItem(Kind::Vertex, v.value()) {}  ///< Names a vertex.
  constexpr SpaceItem(EdgeId e) : SpaceItem(Kind::Edge, e.value()) {}      ///< Names an edge.
  constexpr SpaceItem(FacetId f) : SpaceItem(Kind::Facet, f.value()) {}    ///< Names a facet.
  constexpr SpaceItem(VolumeId v) : SpaceItem(Kind::Volume, v.value()) {}  ///< Names a volume.

  /// Returns the item with this code().
  static constexpr SpaceItem from_code(std::uint32_t code) {
    SpaceItem item;
    item.code_ = code;
    return item;
  }

  /// Whether this names an item. The other members but code() require it.
  constexpr bool is_valid() const { return code_ != ~std::uint32_t{0}; }
  /// Returns the kind of the item.
  constexpr Kind kind() const { return static_cast<Kind>(code_ >> 30U); }
  /// Returns the index of the item among those of its kind.
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
