// A marked subdivision of the plane, bounded or not: what Nef2 and Arrangement are made of.
//
// Notation: ordinary vertices, edges and faces come first in every numbering, then what belongs to
// the frame. The frame is the symbolic circle around everything: each end of a ray or line at
// infinity is a frame vertex, two neighbouring ends bound a frame edge, and the face beyond is the
// last one. Without unbounded edges there is no frame. Nothing on the frame has coordinates.
//
//   vertex v   lies at points[vertex_point[v]]; numbered in lexicographic order of its point
//   edge e     half-edge 2e runs from the lexicographically lesser end (left) to the greater one;
//              lies on the line through the input points line[e].a -> line[e].b, which runs that
//              way too; numbered as a sweep meets left ends (from the left infinity; then by point,
//              vertical ones from below before all points of their x), then bottom to top
//   face 0     reaches down to (-infinity, -infinity); the others by their least half-edge
//
// Coordinates stay implicit: a vertex is an input point or the crossing of two lines through input
// points, whatever number of operations led to it, so chains never grow numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/dcel/dcel.h"
#include "plumb/predicates/plane_points.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A directed line through two different input points.
struct PlaneLine {
  std::uint32_t a;  ///< index of a point it runs through
  std::uint32_t b;  ///< index of a later one
  friend bool operator==(const PlaneLine&, const PlaneLine&) = default;
};

/// One mark for each ordinary vertex, edge and face: 0 or 1.
struct PlaneMarks {
  std::vector<std::uint8_t> vertex;  ///< per ordinary vertex
  std::vector<std::uint8_t> edge;    ///< per ordinary edge
  std::vector<std::uint8_t> face;    ///< per ordinary face
  friend bool operator==(const PlaneMarks&, const PlaneMarks&) = default;
};

/// A subdivision of the plane with marks; invariants above.
struct PlaneComplex {
  PlanePoints points;                       ///< input points and crossings
  Dcel dcel;                                ///< what is next to what
  std::vector<std::uint32_t> vertex_point;  ///< per ordinary vertex: dense index into points
  std::vector<PlaneLine> line;              ///< per ordinary edge: indices of points.inputs
  PlaneMarks marks;                         ///< of everything but the frame

  std::size_t vertex_count() const { return vertex_point.size(); }  ///< Ordinary vertices.
  std::size_t edge_count() const { return line.size(); }            ///< Ordinary edges.
  /// Ordinary faces.
  std::size_t face_count() const { return dcel.face_count() - (has_frame() ? 1 : 0); }

  /// Is there an unbounded edge?
  bool has_frame() const { return dcel.edge_count() != line.size(); }
  /// Is it an end of a ray or line?
  bool is_at_infinity(VertexId v) const { return v.value() >= vertex_count(); }
  /// Is it between two ends at infinity?
  bool is_frame(EdgeId e) const { return e.value() >= edge_count(); }
  /// Is it between two ends at infinity?
  bool is_frame(HalfedgeId h) const { return is_frame(edge_of(h)); }
  /// Is it the face beyond the frame?
  bool is_beyond(FaceId f) const { return f.value() >= face_count(); }

  /// The ordinary half-edge after h around its face: over the frame when h leads to infinity.
  HalfedgeId next(HalfedgeId h) const {
    const HalfedgeId n = dcel.next(h);
    return is_frame(n) ? dcel.next(n) : n;
  }
  /// Does an ordinary item belong to the set?
  bool mark(VertexId v) const { return marks.vertex[v.value()] != 0; }
  /// Does an ordinary item belong to the set?
  bool mark(EdgeId e) const { return marks.edge[e.value()] != 0; }
  /// Does an ordinary item belong to the set?
  bool mark(FaceId f) const { return marks.face[f.value()] != 0; }
};

/// Does some boundary of f lead to infinity (face 0 always does)? O(length of its boundary).
bool is_unbounded(const PlaneComplex& complex, FaceId f);

/// A broken invariant of a complex and where; nothing when all hold. Checks the half-edge structure
/// (Dcel::audit, audit_planar), sizes, numbering, that every vertex lies on the lines of its edges,
/// the circular order of edges around each vertex, and, by a sweep of its own, that no two edges
/// meet but at vertices and that loops lie in the faces they are listed with.
/// `minimal`: also that no element could go without changing the set (the form of a Nef2).
std::optional<DcelFlaw> audit(const PlaneComplex& complex, bool minimal);

}  // namespace plumb
#pragma GCC visibility pop
