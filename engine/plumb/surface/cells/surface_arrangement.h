// The subdivision of a surface by polygons. Each face is subdivided separately.
//
// A face is divided if a node lies in it or on its boundary. Each divided face is stored as a
// planar subdivision with half-edges. In the numbering of a divided face, the half-edges along the
// boundary of the face come first. Each of them runs from a node to the next node, and its twin
// belongs to the adjacent face. The half-edges of arcs inside the face come after the half-edges
// along the boundary, in pairs of twins. All other faces remain whole, and nothing is stored for
// them.
//
// Main flow of slice():
//  1. nodes      replaces all equal points by one node. To find equal points, it sorts the points
//                on each edge and in each face (make_nodes())
//  2. runs       computes the bundle of each part of a mesh edge between two nodes: the sum of the
//                multiplicities of the segments that run along this part
//  3. segments   does the same for all other segments: those with the same face and the same ends
//                form a group, and the multiplicities in each group are added. Groups whose sum is
//                zero are dropped
//  4. faces      computes the arrangement of the segments in each divided face (face_arrangement.h)
//  5. sew        finds the twins of half-edges along mesh edges
//
// The multiplicity of a polygon along an arc is its coefficient in a chain, as in homology. It is
// the number of times that the polygon runs in the direction of the arc, minus the number of times
// that it runs in the opposite direction. Theory: docs/design/surface.md, section Slicing.
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

/// The point where two segments cross inside a face. The exact coordinates of this point are not
/// stored, because they can be computed from the ends of the segments.
struct SurfaceCrossing {
  FaceId face;
  std::array<NodeId, 4> ends;  ///< The ends of the first segment, then the ends of the second.
  Point2 approx;               ///< The rounded parameters (u, v).
  double radius;               ///< A bound on the errors of the rounded u and v; may be infinite.
};

/// A list of bundles. A bundle is a sparse vector with one entry for each polygon along an arc: the
/// multiplicity of the polygon. The list may contain equal bundles.
class SurfaceBundles {
 public:
  std::size_t size() const { return begin_.size() - 1; }
  std::span<const SignedEntry> operator[](std::size_t b) const {
    return std::span(entries_).subspan(begin_[b], begin_[b + 1] - begin_[b]);
  }
  /// Appends the sum of `terms` as a bundle and returns true. The terms may be in any order. If the
  /// sum is zero, appends nothing and returns false.
  bool add_sum(std::span<SignedEntry> terms);

 private:
  std::vector<std::uint32_t> begin_ = {0};
  std::vector<SignedEntry> entries_;
};

/// The subdivision in flat arrays. The half-edges of each divided face have consecutive ids. The
/// pieces of each divided face also have consecutive ids.
struct SurfaceArrangement {
  std::size_t segments = 0;  ///< Number of input segments of nonzero length.

  // The nodes are, in this order: input points, corners of divided faces that are not input points,
  // crossings.
  IdVector<NodeId, SurfacePointId> node_point;  ///< The input points, which are the first nodes.
  std::vector<VertexId> corner_vertex;          ///< The corners, which are the next nodes.
  std::vector<SurfaceCrossing> crossings;       ///< The crossings, which are the last nodes.
  /// The node of each entry of SurfacePolygons::point.
  std::vector<NodeId> node_of_entry;

  // The divided faces, in ascending order of their ids. The index of a face in this list is called
  // the slot of the face.
  std::vector<FaceId> slot_face;
  IdVector<FaceId, std::uint32_t> slot_of_face;  ///< Slot of each face; kNone if it is not divided.
  /// Four entries for each divided face, in the order of slots. The first three entries are the
  /// first half-edges of side 0, of side 1 and of side 2. The fourth entry is the first half-edge
  /// of the arcs inside the face.
  std::vector<std::uint32_t> side_begin;
  /// The first piece of each divided face, in the order of slots. The last entry is the number of
  /// pieces.
  std::vector<PieceId> piece_begin;

  IdVector<HalfedgeId, NodeId> origin;  ///< Origin of each half-edge.
  /// Twin of each half-edge. It is invalid at the mesh border, and where the adjacent face is not
  /// divided.
  IdVector<HalfedgeId, HalfedgeId> twin;
  IdVector<HalfedgeId, HalfedgeId> next;  ///< Next half-edge around the piece of each half-edge.
  IdVector<HalfedgeId, PieceId> piece;    ///< Piece to the left of each half-edge.
  IdVector<HalfedgeId, ArcId> arc;  ///< Arc of each half-edge; invalid if no polygon runs there.

  IdVector<PieceId, std::uint32_t> piece_slot;
  IdVector<PieceId, double>
      piece_share;  ///< The area of each piece divided by the area of its face.
  IdVector<PieceId, std::uint32_t>
      /// The index in `loop` of the first loop of each piece. The last entry is the number of
      /// loops.
      loop_begin;
  std::vector<HalfedgeId>
      /// One half-edge of each boundary cycle (loop) of a piece. The outer cycle of a piece comes
      /// first.
      loop;

  IdVector<ArcId, HalfedgeId>
      arc_halfedge;  ///< The half-edge that runs in the direction of each arc.
  IdVector<ArcId, std::uint32_t> arc_bundle;
  SurfaceBundles bundles;  ///< The polygons along arcs, with their multiplicities.

  std::size_t crossings_begin() const { return node_point.size() + corner_vertex.size(); }
  std::size_t node_count() const { return crossings_begin() + crossings.size(); }
  std::size_t halfedge_count() const { return origin.size(); }
  std::size_t piece_count() const { return piece_slot.size(); }
  std::size_t arc_count() const { return arc_halfedge.size(); }
  bool is_input(NodeId n) const { return n.value() < node_point.size(); }
  bool is_crossing(NodeId n) const { return n.value() >= crossings_begin(); }
  SurfacePointId input(NodeId n) const { return node_point[n]; }
  /// Returns the vertex of a node that is neither an input point nor a crossing.
  VertexId corner(NodeId n) const { return corner_vertex[n.value() - node_point.size()]; }
  const SurfaceCrossing& crossing(NodeId n) const {
    return crossings[n.value() - crossings_begin()];
  }
  std::span<const SignedEntry> multiplicities(ArcId a) const { return bundles[arc_bundle[a]]; }
  /// Whether the half-edge runs in the direction of its arc. Requires that it has an arc.
  bool is_with_arc(HalfedgeId h) const { return arc_halfedge[arc[h]] == h; }
  NodeId target(HalfedgeId h) const { return origin[next[h]]; }
  FaceId face_of(PieceId p) const { return slot_face[piece_slot[p]]; }
  std::uint32_t sides_begin(std::uint32_t slot) const { return side_begin[4 * slot]; }
  std::uint32_t arcs_begin(std::uint32_t slot) const { return side_begin[4 * slot + 3]; }
};

/// Returns the subdivision of the surface by the polygons. Requires that require_valid(polygons)
/// does not throw. Throws the errors of the Context.
SurfaceArrangement slice(const SurfacePolygons& polygons, Context& context);

inline constexpr std::uint8_t kCrossingEnds = 3;
/// Returns, for each node, the number of ends of arcs at the node, but at most kCrossingEnds. A
/// closed arc has two ends at its node. If the number is kCrossingEnds, polygons meet at the node,
/// and the node counts as a crossing in statistics. Only arcs for which `counts(arc)` returns true
/// are taken into account.
template <class Counts>
IdVector<NodeId, std::uint8_t> arc_ends(const SurfaceArrangement& a, const Counts& counts) {
  IdVector<NodeId, std::uint8_t> ends(a.node_count());
  for (std::size_t i = 0; i < a.arc_count(); ++i) {
    if (!counts(ArcId(i))) continue;
    const HalfedgeId h = a.arc_halfedge[i];
    for (const NodeId n : {a.origin[h], a.target(h)}) {
      if (ends[n] < kCrossingEnds) ++ends[n];
    }
  }
  return ends;
}
inline IdVector<NodeId, std::uint8_t> arc_ends(const SurfaceArrangement& a) {
  return arc_ends(a, [](ArcId) { return true; });
}

/// Returns the exact parameters (u, v) of a crossing in its face.
RationalPoint2 exact_crossing(const SurfaceArrangement& arrangement,
                              const SurfacePointTable& points, const SurfaceCrossing& crossing);

/// Returns the exact parameters (u, v) of any node in the face f. Requires that the node lies in
/// this face.
RationalPoint2 exact_node(const SurfaceArrangement& arrangement, const SurfacePointTable& points,
                          NodeId node, FaceId f);

/// Appends the point of a node to a table over the same mesh, and returns the row of the point.
SurfacePointId add_node_point(const SurfaceArrangement& arrangement,
                              const SurfacePointTable& points, NodeId node, SurfacePointTable& to);

// The distinct points of polygons, and their order along edges.

/// Nodes of input points. First come the nodes on edges, sorted by edge and then by t. They are
/// followed by the nodes at vertices, and finally by the nodes in faces.
struct SurfaceNodes {
  IdVector<NodeId, SurfacePointId> point;  ///< Point of each node.
  std::vector<NodeId> of_entry;            ///< Node of each entry of the polygons.
  std::vector<EdgeId> edges;               ///< Edges with nodes inside, ascending.
  /// For each edge in `edges`, the id of its first node. The last entry is the number of nodes on
  /// edges. The nodes of an edge are in ascending order of t.
  std::vector<std::uint32_t> edge_begin;
  IdVector<EdgeId, std::uint32_t> slot_of_edge;  ///< Index of each mesh edge in `edges`, or kNone.
  std::uint32_t vertices_begin = 0;
  std::uint32_t faces_begin = 0;
  IdVector<VertexId, NodeId> of_vertex;  ///< Node of each mesh vertex.

  std::uint32_t count_on(EdgeId e) const {
    const std::uint32_t slot = slot_of_edge[e];
    return slot == kNone ? 0 : edge_begin[slot + 1] - edge_begin[slot];
  }
  /// Returns the id of the first node inside an edge; the other nodes inside the edge have the next
  /// ids. Requires that count_on(e) > 0.
  std::uint32_t first_on(EdgeId e) const { return edge_begin[slot_of_edge[e]]; }
};

/// Finds the distinct points of the polygons. Expected cost: O(n log n) for n entries, plus time
/// linear in the size of the mesh.
SurfaceNodes make_nodes(const SurfacePolygons& polygons, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
