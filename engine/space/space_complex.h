// A marked subdivision of space, the form every set of space is held in: vertices, edges, facets and
// volumes in flat arrays, each with a mark that says whether it belongs to the set.
//
// Notation
//   edge e       lies on the line of edge_planes[e] = {p, q}; half-edge 2e runs along n_p x n_q
//   use u        edge on the boundary of a facet: leaves along use_halfedge[u], with the facet to its
//                left, seen from the positive side of the facet's (canonical) plane. The corner of the use
//                is the corner of its facet at its origin: it sweeps counter-clockwise from use_halfedge[u]
//                to the reverse of use_halfedge[use_prev[u]].
//   radial       the uses of both half-edges of e, counter-clockwise around half-edge 2e with its direction
//                pointing at the viewer. After a use of 2e comes the volume on the positive side of its facet,
//                after one of 2e+1 that on the negative side.
//   facet f      plane, mark, volume on the positive [0] and negative [1] side; boundary cycles, the outer one
//                first, then holes; vertices inside it
//   volume 0     reaches to infinity (bounded sets), or is the beyond of the frame
//
// The sphere map of a vertex (local_maps.h) is a view of these arrays: its points are the half-edges that
// leave, its arcs the corners of uses, its faces the sides of facets.
//
// Free parts: an edge without uses lies in the volume edge_volume. A vertex inside a facet (its sphere
// map has a loop; edges may leave it all the same) has vertex_facet and is listed as inner to that
// facet. A vertex with neither half-edges nor facet lies in vertex_volume.
//
// Frame: an unbounded set is cut by a cube |x|, |y|, |z| <= R with R beyond all bounds. What lies
// on the cube and beyond has the mark kBeyond. No user sees it.
//
// Invariants: audit() in space_audit.h.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/base/marks.h"
#include "plumb/space/space_tables.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Items of space and how they hang together, in flat arrays; invariants above.
struct SpaceComplex {
  std::shared_ptr<const SpaceTables> tables;  ///< planes and points, shared

  // per vertex
  std::vector<SpacePoint> vertex_point;   ///< where it is
  std::vector<Mark> vertex_mark;          ///< is it in the set?
  std::vector<VolumeId> vertex_volume;    ///< of a vertex alone in a volume; else invalid
  std::vector<FacetId> vertex_facet;      ///< of a vertex inside a facet; else invalid
  std::vector<std::uint32_t> star_begin;  ///< vertex_count() + 1 entries into star
  std::vector<HalfedgeId> star;           ///< half-edges that leave the vertex

  // per edge, per half-edge
  std::vector<std::array<PlaneId, 2>> edge_planes;  ///< two planes that meet in its line
  std::vector<Mark> edge_mark;                      ///< is it in the set?
  std::vector<UseId> edge_use;                      ///< one of its uses; invalid: free
  std::vector<VolumeId> edge_volume;                ///< of a free edge
  std::vector<VertexId> origin;                     ///< per half-edge

  // per use
  std::vector<HalfedgeId> use_halfedge;  ///< the edge, in the direction of the facet's cycle
  std::vector<UseId> use_next;           ///< after it along the cycle
  std::vector<UseId> use_prev;           ///< before it along the cycle
  std::vector<UseId> use_radial;         ///< the next use around the same edge
  std::vector<FacetId> use_facet;        ///< the facet it bounds

  // per facet
  std::vector<PlaneId> facet_plane;  ///< the plane it lies in; its normal is the positive side
  std::vector<Mark> facet_mark;      ///< is it in the set?
  std::vector<std::array<VolumeId, 2>> facet_volume;  ///< on the positive and on the negative side
  std::vector<std::uint32_t> facet_origin;  ///< id given by whoever made it; carried along
  std::vector<std::uint32_t> cycle_begin;   ///< facet_count() + 1 entries into cycle
  std::vector<UseId> cycle;                 ///< a use of each cycle; the outer cycle first
  std::vector<std::uint32_t> inner_begin;   ///< facet_count() + 1 entries into inner
  std::vector<VertexId> inner;              ///< vertices inside facets

  std::vector<Mark> volume_mark;  ///< per volume: is it in the set?

  std::size_t vertex_count() const { return vertex_point.size(); }  ///< Those of the frame, too.
  std::size_t edge_count() const { return edge_planes.size(); }     ///< Those of the frame, too.
  /// Pairs of a facet and an edge on its boundary.
  std::size_t use_count() const { return use_halfedge.size(); }
  std::size_t facet_count() const { return facet_plane.size(); }  ///< Those of the frame, too.
  /// With the one beyond the frame, if there is a frame.
  std::size_t volume_count() const { return volume_mark.size(); }

  /// The other direction of the same edge.
  static HalfedgeId twin(HalfedgeId h) { return HalfedgeId(h.value() ^ 1U); }
  /// The edge that it is a direction of.
  static EdgeId edge_of(HalfedgeId h) { return EdgeId(h.value() >> 1U); }
  /// Has it the odd id of the two?
  static bool is_reverse(HalfedgeId h) { return (h.value() & 1U) != 0; }
  /// Where a half-edge ends.
  VertexId target(HalfedgeId h) const { return origin[h.value() ^ 1U]; }
  /// The half-edges that leave a vertex.
  std::span<const HalfedgeId> star_of(VertexId v) const {
    return std::span(star).subspan(star_begin[v.value()],
                                   star_begin[v.value() + 1] - star_begin[v.value()]);
  }
  /// A use of each cycle of a facet.
  std::span<const UseId> cycles_of(FacetId f) const {
    return std::span(cycle).subspan(cycle_begin[f.value()],
                                    cycle_begin[f.value() + 1] - cycle_begin[f.value()]);
  }
  /// The vertices alone inside a facet.
  std::span<const VertexId> inner_of(FacetId f) const {
    return std::span(inner).subspan(inner_begin[f.value()],
                                    inner_begin[f.value() + 1] - inner_begin[f.value()]);
  }
  /// Where the use's half-edge begins.
  VertexId use_origin(UseId u) const { return origin[use_halfedge[u.value()].value()]; }
  /// The volume after the use in radial order.
  VolumeId volume_after(UseId u) const {
    return facet_volume[use_facet[u.value()].value()][is_reverse(use_halfedge[u.value()]) ? 1 : 0];
  }
  const PlaneTable& planes() const { return tables->planes; }   ///< Planes by PlaneId.
  const Point3Table& points() const { return tables->points; }  ///< Points by SpacePoint.
};

/// An item of a complex, in 32 bits. Default-constructed: none.
class SpaceItem {
 public:
  /// Of items.
  enum class Kind : std::uint32_t { Vertex, Edge, Facet, Volume };

  constexpr SpaceItem() = default;
  constexpr SpaceItem(VertexId v) : SpaceItem(Kind::Vertex, v.value()) {}  ///< A vertex.
  constexpr SpaceItem(EdgeId e) : SpaceItem(Kind::Edge, e.value()) {}      ///< An edge.
  constexpr SpaceItem(FacetId f) : SpaceItem(Kind::Facet, f.value()) {}    ///< A facet.
  constexpr SpaceItem(VolumeId v) : SpaceItem(Kind::Volume, v.value()) {}  ///< A volume.

  /// The item whose code() that is.
  static constexpr SpaceItem from_code(std::uint32_t code) {
    SpaceItem item;
    item.code_ = code;
    return item;
  }

  constexpr bool is_valid() const { return code_ != ~std::uint32_t{0}; }   ///< Is it any item?
  constexpr Kind kind() const { return static_cast<Kind>(code_ >> 30U); }  ///< Requires is_valid().
  /// The number of the item among its kind.
  constexpr std::uint32_t index() const { return code_ & 0x3fffffffU; }
  constexpr std::uint32_t code() const { return code_; }           ///< Kind and index in 32 bits.
  constexpr VertexId vertex() const { return VertexId(index()); }  ///< Requires that kind.
  constexpr EdgeId edge() const { return EdgeId(index()); }        ///< Requires that kind.
  constexpr FacetId facet() const { return FacetId(index()); }     ///< Requires that kind.
  constexpr VolumeId volume() const { return VolumeId(index()); }  ///< Requires that kind.
  friend constexpr auto operator<=>(SpaceItem, SpaceItem) = default;

 private:
  constexpr SpaceItem(Kind kind, std::uint32_t index)
      : code_((static_cast<std::uint32_t>(kind) << 30U) | index) {}
  std::uint32_t code_ = ~std::uint32_t{0};
};

}  // namespace plumb
#pragma GCC visibility pop
