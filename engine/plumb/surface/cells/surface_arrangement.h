// Polygons on a surface against each other: the subdivision into which they cut it, face by face.
//
// A face is touched if a node lies in it or on its boundary. Touched faces are planar subdivisions
// with half-edges: first those along the face's own boundary (split at nodes; the outside belongs
// to another face), then those of arcs inside it, in pairs. Other faces are whole.
//
// Main flow of slice():
//  1. nodes      makes equal points one node, by sorting along each edge and in each face
//                (make_nodes())
//  2. runs       adds up segments along mesh edges on the pieces of those edges
//  3. segments   adds up the other segments by face and ends; those that cancel go
//  4. faces      arranges each touched face on its own (face_arrangement.h)
//  5. sew        finds the twins of half-edges along mesh edges
//
// Multiplicities are those of chains: a polygon that runs back the way it came is zero. Theory:
// docs/design/surface.md, section Slicing.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/point.h"
#include "plumb/surface/surface_mesh.h"
#include "plumb/surface/surface_path.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Where two segments between input nodes meet inside a face; its exact place is implicit.
struct SurfaceCrossing {
  FaceId face;
  std::array<NodeId, 4> ends;  ///< Ends of the first segment, then those of the second.
  Point2 approx;               ///< (u, v), rounded.
  double radius;               ///< Bound on the error of both; may be infinite.
};

/// Sparse vectors over polygons, end to end. Equal ones may occur more than once.
class SurfaceBundles {
 public:
  std::size_t size() const { return begin_.size() - 1; }
  std::span<const SignedEntry> operator[](std::size_t b) const {
    return std::span(entries_).subspan(begin_[b], begin_[b + 1] - begin_[b]);
  }
  /// Appends the sum of `terms`, given in any order, and returns true. If the sum is zero it
  /// appends nothing and returns false.
  bool add_sum(std::span<SignedEntry> terms);

 private:
  std::vector<std::uint32_t> begin_ = {0};
  std::vector<SignedEntry> entries_;
};

/// The subdivision in flat arrays. Half-edges of a touched face are consecutive, and so are its
/// pieces.
struct SurfaceArrangement {
  std::size_t segments = 0;  ///< Segments of the input, without those of length zero.

  // Nodes: input points, then corners of touched faces that no polygon runs through, then
  // crossings.
  std::vector<SurfacePointId> node_point;  ///< Input points; the first nodes.
  std::vector<VertexId> corner_vertex;     ///< Corners; the nodes after them.
  std::vector<SurfaceCrossing> crossings;  ///< Crossings; the last nodes.
  std::vector<NodeId> node_of_entry;       ///< Node of each entry of SurfacePolygons::point.

  // Touched faces, in slots by ascending id.
  std::vector<FaceId> slot_face;
  std::vector<std::uint32_t> slot_of_face;  ///< Slot of each face, or kNone.
  /// Four entries per slot: where the half-edges of sides 0, 1, 2 and those of arcs begin.
  std::vector<std::uint32_t> side_begin;
  std::vector<PieceId> piece_begin;  ///< First piece of each slot, and one past the last.

  std::vector<NodeId> origin;  ///< Origin of each half-edge.
  /// Twin; invalid at the mesh border and beside faces that are not touched.
  std::vector<HalfedgeId> twin;
  std::vector<HalfedgeId> next;  ///< Next half-edge around the piece.
  std::vector<PieceId> piece;    ///< Piece to the left.
  std::vector<ArcId> arc;        ///< Arc, invalid if no polygon runs here.

  std::vector<std::uint32_t> piece_slot;
  std::vector<double> piece_share;        ///< Part of the area of its face.
  std::vector<std::uint32_t> loop_begin;  ///< First loop of each piece, and one past the last.
  std::vector<HalfedgeId> loop;  ///< A half-edge of each boundary cycle, the outer one first.

  std::vector<HalfedgeId> arc_halfedge;  ///< The half-edge that runs with the arc.
  std::vector<std::uint32_t> arc_bundle;
  SurfaceBundles bundles;  ///< Polygons with their multiplicities along arcs.

  std::size_t crossings_begin() const { return node_point.size() + corner_vertex.size(); }
  std::size_t node_count() const { return crossings_begin() + crossings.size(); }
  std::size_t halfedge_count() const { return origin.size(); }
  std::size_t piece_count() const { return piece_slot.size(); }
  std::size_t arc_count() const { return arc_halfedge.size(); }
  bool is_input(NodeId n) const { return n.value() < node_point.size(); }
  bool is_crossing(NodeId n) const { return n.value() >= crossings_begin(); }
  SurfacePointId input(NodeId n) const { return node_point[n.value()]; }
  /// Returns the vertex of a node that is neither input nor crossing.
  VertexId corner(NodeId n) const { return corner_vertex[n.value() - node_point.size()]; }
  const SurfaceCrossing& crossing(NodeId n) const {
    return crossings[n.value() - crossings_begin()];
  }
  std::span<const SignedEntry> multiplicities(ArcId a) const {
    return bundles[arc_bundle[a.value()]];
  }
  /// Whether the half-edge runs with its arc. Requires an arc.
  bool is_with_arc(HalfedgeId h) const { return arc_halfedge[arc[h.value()].value()] == h; }
  NodeId target(HalfedgeId h) const { return origin[next[h.value()].value()]; }
  FaceId face_of(PieceId p) const { return slot_face[piece_slot[p.value()]]; }
  std::uint32_t sides_begin(std::uint32_t slot) const { return side_begin[4 * slot]; }
  std::uint32_t arcs_begin(std::uint32_t slot) const { return side_begin[4 * slot + 3]; }
};

/// Arranges polygons. Requires that require_valid(polygons) passes. Throws what the context throws.
SurfaceArrangement slice(const SurfacePolygons& polygons, Context& context);

inline constexpr std::uint8_t kCrossingEnds = 3;
/// Returns how many arcs end in each node, both ends of a closed arc counted, up to kCrossingEnds;
/// a node with that many is a crossing. Only arcs for which `counts(arc)` holds are counted.
template <class Counts>
std::vector<std::uint8_t> arc_ends(const SurfaceArrangement& a, const Counts& counts) {
  std::vector<std::uint8_t> ends(a.node_count());
  for (std::size_t i = 0; i < a.arc_count(); ++i) {
    if (!counts(ArcId(i))) continue;
    const HalfedgeId h = a.arc_halfedge[i];
    for (const NodeId n : {a.origin[h.value()], a.target(h)}) {
      if (ends[n.value()] < kCrossingEnds) ++ends[n.value()];
    }
  }
  return ends;
}
inline std::vector<std::uint8_t> arc_ends(const SurfaceArrangement& a) {
  return arc_ends(a, [](ArcId) { return true; });
}

/// Returns (u, v) of a crossing.
RationalPoint2 exact_crossing(const SurfaceArrangement& arrangement,
                              const SurfacePointTable& points, const SurfaceCrossing& crossing);

/// Returns (u, v) of any node in a face it lies in.
RationalPoint2 exact_node(const SurfaceArrangement& arrangement, const SurfacePointTable& points,
                          NodeId node, FaceId f);

/// Returns the point of a node, appended to a table over the same mesh.
SurfacePointId add_node_point(const SurfaceArrangement& arrangement,
                              const SurfacePointTable& points, NodeId node, SurfacePointTable& to);

// The different points of polygons, and where they lie along edges.

/// Nodes of input points: those on edges first, by edge and t; then vertices, then points in faces.
struct SurfaceNodes {
  std::vector<SurfacePointId> point;  ///< Point of each node.
  std::vector<NodeId> of_entry;       ///< Node of each entry of the polygons.
  std::vector<EdgeId> edges;          ///< Edges with nodes inside, ascending.
  /// First node of each such edge, and one past the last; its nodes ascend by t.
  std::vector<std::uint32_t> edge_begin;
  std::vector<std::uint32_t> slot_of_edge;  ///< Index into `edges` of each mesh edge, or kNone.
  std::uint32_t vertices_begin = 0;
  std::uint32_t faces_begin = 0;
  std::vector<NodeId> of_vertex;  ///< Node of each mesh vertex.

  std::uint32_t count_on(EdgeId e) const {
    const std::uint32_t slot = slot_of_edge[e.value()];
    return slot == kNone ? 0 : edge_begin[slot + 1] - edge_begin[slot];
  }
  /// Returns the first node inside an edge with count_on() > 0; the others follow it.
  std::uint32_t first_on(EdgeId e) const { return edge_begin[slot_of_edge[e.value()]]; }
};

/// Finds the different points. Expected cost: O(n log n) for n entries, and O(mesh) to set up.
SurfaceNodes make_nodes(const SurfacePolygons& polygons, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
