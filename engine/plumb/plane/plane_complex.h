// A marked subdivision of the plane, bounded or not: the representation of Nef2 and Arrangement.
//
// Notation: ordinary vertices, edges and faces come first in every numbering, followed by those of
// the frame. The frame is a symbolic circle around everything: each end of a ray or line at
// infinity is a frame vertex, two neighbouring ends bound a frame edge, and the face beyond the
// frame is the last one. Without unbounded edges there is no frame. No cell of the frame has
// coordinates (docs/design/frame.md).
//
//   vertex v   lies at points[vertex_point[v]]; vertices are numbered in lexicographic order
//   edge e     lies on the line through the input points line[e].a and line[e].b; half-edge 2e runs
//              from the lexicographically lesser end (left) to the greater one, and the line runs
//              from a to b in the same direction. Edges are numbered in the order in which a sweep
//              meets their left ends (those at the left infinity first, then by point; vertical
//              edges that come from infinity below precede all points of their x), edges with the
//              same left end from bottom to top
//   face 0     reaches down to (-infinity, -infinity); other faces are numbered by their least
//              half-edge
//
// Coordinates stay implicit: a vertex is an input point or the crossing of two lines through input
// points, however many operations led to it, so chains of operations never make numbers longer.
// plane_audit.h checks these invariants.
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
  std::uint32_t b;  ///< Index of another input point on the line, lexicographically greater.
  friend bool operator==(const PlaneLine&, const PlaneLine&) = default;
};

/// One mark for each ordinary vertex, edge and face: 1 if the cell belongs to the set, 0 if not.
struct PlaneMarks {
  std::vector<std::uint8_t> vertex;  ///< One mark for each ordinary vertex.
  std::vector<std::uint8_t> edge;    ///< One mark for each ordinary edge.
  std::vector<std::uint8_t> face;    ///< One mark for each ordinary face.
  friend bool operator==(const PlaneMarks&, const PlaneMarks&) = default;
};

/// Where a point lies. Exactly one of the ids is valid.
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
  Dcel dcel;           ///< Incidences of vertices, edges and faces, those of the frame included.
  /// For each ordinary vertex, the dense index of its point in `points`.
  std::vector<std::uint32_t> vertex_point;
  std::vector<PlaneLine> line;  ///< For each ordinary edge, its line; a, b index points.inputs.
  PlaneMarks marks;             ///< The marks of all ordinary cells.

  /// Returns the number of ordinary vertices.
  std::size_t vertex_count() const { return vertex_point.size(); }
  /// Returns the number of ordinary edges.
  std::size_t edge_count() const { return line.size(); }
  /// Returns the number of ordinary faces.
  std::size_t face_count() const { return dcel.face_count() - (has_frame() ? 1 : 0); }

  /// Whether there is a frame, that is, an unbounded edge.
  bool has_frame() const { return dcel.edge_count() != line.size(); }
  /// Whether v is a frame vertex: an end of a ray or line at infinity.
  bool is_at_infinity(VertexId v) const { return v.value() >= vertex_count(); }
  /// Whether e is a frame edge, between two ends at infinity.
  bool is_frame(EdgeId e) const { return e.value() >= edge_count(); }
  /// Whether h is a half-edge of a frame edge.
  bool is_frame(HalfedgeId h) const { return is_frame(edge_of(h)); }
  /// Whether f is the face beyond the frame.
  bool is_beyond(FaceId f) const { return f.value() >= face_count(); }

  /// Returns the ordinary half-edge after h around its face. If h leads to infinity, the frame edge
  /// that follows it is skipped. O(1).
  HalfedgeId next(HalfedgeId h) const {
    const HalfedgeId n = dcel.next(h);
    return is_frame(n) ? dcel.next(n) : n;
  }
  /// Whether an ordinary vertex belongs to the set.
  bool mark(VertexId v) const { return marks.vertex[v.value()] != 0; }
  /// Whether an ordinary edge belongs to the set.
  bool mark(EdgeId e) const { return marks.edge[e.value()] != 0; }
  /// Whether an ordinary face belongs to the set.
  bool mark(FaceId f) const { return marks.face[f.value()] != 0; }
};

/// Whether face f is unbounded: it is face 0, or a boundary of it runs along the frame. O(length of
/// its boundary).
bool is_unbounded(const PlaneComplex& complex, FaceId f);

}  // namespace plumb
#pragma GCC visibility pop
