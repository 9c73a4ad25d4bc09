// A complex under construction: edges with their links, before its faces are known; and the minimal
// form of a complex, which is made in the same way.
//
// Main flow:
//  1. the caller (PlaneBuilder, simplify) fills the arrays: vertices in lexicographic order, edges
//     by left end and then bottom to top, next around each vertex (link_ring)
//  2. close_frame    joins the unbounded ends by frame edges
//  3. trace_loops    finds the boundary loops and numbers them by their least half-edge
//  4. the caller     gives each loop a class: loops of one class lie in one face
//  5. finish         numbers the faces, compacts the points, builds the half-edge structure
// Every step takes O(n).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/plane_complex.h"

namespace plumb {

/// The arrays of a complex under construction.
struct PlaneDraft {
  IdVector<VertexId, std::uint32_t> vertex_point;  ///< The point of each vertex (dense index).
  IdVector<VertexId, std::uint8_t> vertex_mark;    ///< The mark of each vertex.
  std::vector<VertexId> isolated;                  ///< The vertices without edges, ascending.

  IdVector<EdgeId, PlaneLine> line;          ///< The line of each edge.
  IdVector<EdgeId, std::uint8_t> edge_mark;  ///< The mark of each edge.

  IdVector<HalfedgeId, VertexId> origin;  ///< The origin of each half-edge; not valid at infinity.
  IdVector<HalfedgeId, HalfedgeId> next;  ///< The half-edge that follows each one.
  IdVector<HalfedgeId, std::uint8_t>
      left_mark;                 ///< The mark of the face to the left of each half-edge.
  std::uint8_t bottom_mark = 0;  ///< The mark of face 0.

  /// The half-edges that lead to infinity, counter-clockwise from face 0: down, right, up, left.
  std::vector<HalfedgeId> ends;

  std::size_t vertex_count() const { return vertex_point.size(); }
  std::size_t edge_count() const { return line.size(); }

  /// Adds a vertex and returns its id.
  VertexId add_vertex(std::uint32_t point, bool mark);
  /// Adds an edge and returns its id. It comes from infinity if `left` is not valid, and leads to
  /// infinity until end_edge().
  EdgeId add_edge(VertexId left, PlaneLine edge_line, bool mark, bool mark_above, bool mark_below);
  /// Sets the right end of an edge.
  void end_edge(EdgeId e, VertexId right) { origin[first_half(e).value() + 1] = right; }
  /// Links the half-edges that leave one vertex, given counter-clockwise.
  void link_ring(std::span<const HalfedgeId> leaving);
};

/// The boundary loops, numbered by their least half-edges.
struct PlaneLoops {
  IdVector<HalfedgeId, std::uint32_t> loop_of;  ///< The loop of each half-edge.
  std::vector<HalfedgeId> first;                ///< The least half-edge of each loop.

  std::size_t count() const { return first.size(); }
};

/// The classes of loops: loops of one class lie in one face. Classes are any numbers below
/// `class_count`.
struct PlaneFaceClasses {
  std::vector<std::uint32_t> of_loop;      ///< The class of each loop.
  std::vector<std::uint32_t> of_isolated;  ///< The class of each entry of PlaneDraft::isolated.
  std::uint32_t bottom = 0;                ///< The class of face 0.
  std::size_t class_count = 0;             ///< An upper bound of the classes.
};

/// Adds a frame vertex for each end and a frame edge from each end to the next. Returns the
/// half-edge of the frame that has face 0 to its left, or an invalid id if there are no ends.
HalfedgeId close_frame(PlaneDraft& draft);

/// Returns the boundary loops of a draft with complete links.
PlaneLoops trace_loops(const PlaneDraft& draft);

/// Returns the least vertex of each loop, or an invalid id for a loop along the frame.
std::vector<VertexId> least_vertices(const PlaneDraft& draft, const PlaneLoops& loops);

/// A finished complex.
struct FinishedDraft {
  PlaneComplex complex;  ///< The complex.
  /// The least half-edge of each ordinary face; not valid if the face has none.
  std::vector<HalfedgeId> first_of_face;
};

/// Builds the complex. vertex_point and line refer to `points`. Only points that are used are kept.
FinishedDraft finish(const PlaneDraft& draft, const PlaneLoops& loops,
                     const PlaneFaceClasses& classes, PlanePoints points);

// The unique minimal form of a marked complex, in linear time and without a sweep.
//
// Main flow of simplify():
//  1. drops each edge that has the same mark as both faces beside it, and joins these faces
//     (union-find)
//  2. drops each vertex that keeps no edge and has the mark of its face, and each vertex that keeps
//     two edges on one line and has their mark
//  3. makes one edge of each chain through dropped vertices, at the place of its first edge
//  4. runs trace_loops() and finish(), with the joined faces as classes
// Cost: O(n a(n)) with the inverse Ackermann function a, and one cross_sign for each vertex that
// keeps two edges. Source: docs/design/sweep.md, The minimal form in the same pass.

/// Returns the minimal complex of the same set. Requires a complex in which
/// audit(complex, AuditForm::Any) finds no flaw. Idempotent.
PlaneComplex simplify(PlaneComplex complex);

/// A complex of which edges were left out.
struct ReducedComplex {
  PlaneComplex complex;        ///< The part that remains.
  std::vector<FaceId> merged;  ///< For each face of it, one of the faces that it consists of.
};

/// Returns the complex of the edges that are kept. The steps are the same as in simplify(); they
/// take linear time and need no sweep. A vertex with kept edges stays if it is a corner, or if its
/// kept edges are not two on one line; the others vanish. Cells that stay keep their marks. Faces
/// that are joined must have the same mark. Requires a complex in which audit(complex,
/// AuditForm::Any) finds no flaw, and an entry for each edge and for each vertex. The result has
/// the numbering of an arrangement of the same edges.
ReducedComplex without_edges(const PlaneComplex& complex, std::span<const std::uint8_t> is_kept,
                             std::span<const std::uint8_t> is_corner);

/// Returns the marks of the interior: an edge or vertex stays marked only if everything around it
/// is.
PlaneMarks interior_marks(const PlaneComplex& complex);
/// Returns the marks of the closure: an edge or vertex is marked if it or anything around it is.
PlaneMarks closure_marks(const PlaneComplex& complex);

}  // namespace plumb
