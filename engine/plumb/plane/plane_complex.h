// A subdivision of the plane with a mark for each cell. The classes Nef2 and Arrangement store such
// a subdivision. The edges of the subdivision may be unbounded.
//
// The frame: a subdivision with unbounded edges has a frame. The frame is a symbolic circle that
// surrounds all bounded cells. The vertices of the frame are called frame vertices. The frame
// vertices are the ends at infinity of rays and lines. The edges of the frame are called frame
// edges. The frame edges join neighbouring frame vertices. One more face lies beyond the frame.
// Cells of the frame have no coordinates (docs/design/frame.md). All other cells are called
// ordinary. Vertices, edges and faces are numbered separately; in each numbering, the ordinary
// cells come first. A subdivision without unbounded edges has no frame.
//
// Vertices: vertex v lies at points[vertex_point[v]]. Vertices are numbered in lexicographic order
// of their points.
//
// Edges: edge e lies on the line through the input points line[e].a and line[e].b. The left end of
// an edge is its lexicographically lesser end. Half-edge 2 e of edge e runs from the left end to
// the other end, in the direction from a to b. Edges are numbered in the order in which a sweep
// from left to right meets their left ends:
//   - Edges that are unbounded to the left come first.
//   - All other edges follow in lexicographic order of their left ends. If a vertical edge is
//     unbounded below, its left end precedes all points with the same x.
//   - Edges with the same left end are ordered from bottom to top.
//
// Faces: face 0 is the lowest face at the far left. More exactly: if x is less than some bound,
// face 0 contains all points (x, y) for which y is less than a bound that depends on x. The other
// faces are numbered in ascending order of the least half-edge on their boundaries.
//
// Coordinates are implicit. Each vertex is an input point, or the crossing of two lines through
// input points. This remains true after any number of operations, so the numbers in a complex do
// not become longer from operation to operation. audit() (plane_audit.h) checks all invariants
// above.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/dcel/dcel.h"
#include "plumb/predicates/plane/plane_points.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A directed line through two different input points.
struct PlaneLine {
  std::uint32_t a;  ///< Index of an input point on the line.
  /// Index of an input point on the line that is lexicographically greater than point a.
  std::uint32_t b;
  friend bool operator==(const PlaneLine&, const PlaneLine&) = default;
};

/// The marks of all cells that do not belong to the frame. A mark is 1 if the cell belongs to the
/// set, and 0 if not.
struct PlaneMarks {
  IdVector<VertexId, std::uint8_t> vertex;  ///< The mark of each vertex, except frame vertices.
  IdVector<EdgeId, std::uint8_t> edge;      ///< The mark of each edge, except frame edges.
  IdVector<FaceId, std::uint8_t> face;      ///< The mark of each face, except is_beyond() faces.
  friend bool operator==(const PlaneMarks&, const PlaneMarks&) = default;
};

/// The cell that contains a point. Exactly one of the three ids is valid.
struct PlaneLocation {
  VertexId vertex;      ///< Valid if the point is this vertex.
  EdgeId edge;          ///< Valid if the point lies on this edge.
  FaceId face;          ///< Valid if the point lies in this face.
  bool marked = false;  ///< Whether the point belongs to the set.
  friend bool operator==(const PlaneLocation&, const PlaneLocation&) = default;
};

/// A subdivision of the plane with marks. The head of this file states the invariants.
struct PlaneComplex {
  PlanePoints points;  ///< Input points and crossings.
  Dcel dcel;           ///< Incidences of all vertices, edges and faces, including the frame.
  /// For each vertex that is not a frame vertex, the index of its point. An index i less than
  /// points.inputs.size() stands for input point i. The index points.inputs.size() + k stands for
  /// crossing k.
  IdVector<VertexId, std::uint32_t> vertex_point;
  /// For each edge that is not a frame edge, its line. The indices a and b of a line refer to
  /// points.inputs.
  IdVector<EdgeId, PlaneLine> line;
  PlaneMarks marks;  ///< The marks of all cells, except cells of the frame.

  /// Returns the number of vertices, without frame vertices.
  std::size_t vertex_count() const { return vertex_point.size(); }
  /// Returns the number of edges, without frame edges.
  std::size_t edge_count() const { return line.size(); }
  /// Returns the number of faces, without the face beyond the frame.
  std::size_t face_count() const { return dcel.face_count() - (has_frame() ? 1 : 0); }

  /// Whether the subdivision has a frame. A subdivision has a frame if and only if an edge is
  /// unbounded.
  bool has_frame() const { return dcel.edge_count() != line.size(); }
  /// Whether v is a frame vertex, that is, an end of a ray or line at infinity.
  bool is_at_infinity(VertexId v) const { return v.value() >= vertex_count(); }
  /// Whether e is a frame edge, that is, an edge between two frame vertices.
  bool is_frame(EdgeId e) const { return e.value() >= edge_count(); }
  /// Whether h is a half-edge of a frame edge.
  bool is_frame(HalfedgeId h) const { return is_frame(edge_of(h)); }
  /// Whether f is the face beyond the frame.
  bool is_beyond(FaceId f) const { return f.value() >= face_count(); }

  /// Returns the next half-edge after h along the boundary of its face. If h ends at infinity, the
  /// half-edge after h belongs to the frame, and the function skips it. O(1).
  HalfedgeId next(HalfedgeId h) const {
    const HalfedgeId n = dcel.next(h);
    return is_frame(n) ? dcel.next(n) : n;
  }
  /// Whether a vertex belongs to the set. Requires that the vertex is not a frame vertex.
  bool mark(VertexId v) const { return marks.vertex[v] != 0; }
  /// Whether an edge belongs to the set. Requires that the edge is not a frame edge.
  bool mark(EdgeId e) const { return marks.edge[e] != 0; }
  /// Whether a face belongs to the set. Requires a face other than the face beyond the frame.
  bool mark(FaceId f) const { return marks.face[f] != 0; }
};

/// Whether face f is unbounded. A face is unbounded if it is face 0 or if its boundary contains a
/// frame edge. Cost: O(length of the boundary).
bool is_unbounded(const PlaneComplex& complex, FaceId f);

}  // namespace plumb
#pragma GCC visibility pop
