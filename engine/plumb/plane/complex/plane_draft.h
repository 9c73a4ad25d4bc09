// A complex in the making: edges with their links, before its faces are known.
//
// Main flow:
//  1. whoever makes it (PlaneBuilder, simplify) fills the arrays: vertices in lexicographic order,
//     edges by left end and then bottom to top, next around each vertex (link_ring)
//  2. close_frame    joins the unbounded ends by frame edges
//  3. trace_loops    boundary loops, numbered by their least half-edge
//  4. (the maker)    says which loops lie in one face: a class for each loop
//  5. finish         numbers the faces, compacts the points, builds the half-edge structure
// All O(n).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/plane_complex.h"

namespace plumb {

struct PlaneDraft {
  std::vector<std::uint32_t> vertex_point;  ///< dense index
  std::vector<std::uint8_t> vertex_mark;
  std::vector<VertexId> isolated;  ///< vertices without edges, ascending

  std::vector<PlaneLine> line;  ///< per edge
  std::vector<std::uint8_t> edge_mark;

  std::vector<VertexId> origin;         ///< per half-edge; invalid: at infinity
  std::vector<HalfedgeId> next;         ///< per half-edge
  std::vector<std::uint8_t> left_mark;  ///< per half-edge: mark of the face to its left
  std::uint8_t bottom_mark = 0;         ///< of face 0

  /// Half-edges that lead to infinity, counter-clockwise from face 0: down, right, up, left.
  std::vector<HalfedgeId> ends;

  std::size_t vertex_count() const { return vertex_point.size(); }
  std::size_t edge_count() const { return line.size(); }

  VertexId add_vertex(std::uint32_t point, bool mark);
  /// `left` invalid: from infinity. The right end is at infinity until end_edge().
  EdgeId add_edge(VertexId left, PlaneLine edge_line, bool mark, bool mark_above, bool mark_below);
  void end_edge(EdgeId e, VertexId right) { origin[first_half(e).value() + 1] = right; }
  /// Links the half-edges that leave one vertex, listed counter-clockwise.
  void link_ring(std::span<const HalfedgeId> leaving);
};

/// Boundary loops: per half-edge the number of its loop; loops are numbered by least half-edge.
struct PlaneLoops {
  std::vector<std::uint32_t> loop_of;
  std::vector<HalfedgeId> first;

  std::size_t count() const { return first.size(); }
};

/// Which loops lie in one face. Classes are any numbers below `class_count`.
struct PlaneFaceClasses {
  std::vector<std::uint32_t> of_loop;
  std::vector<std::uint32_t> of_isolated;  ///< per entry of PlaneDraft::isolated
  std::uint32_t bottom = 0;                ///< class of face 0
  std::size_t class_count = 0;
};

/// Adds a frame vertex for each end and a frame edge from each end to the next. Returns the
/// half-edge of the frame with face 0 to its left; invalid when there are no ends.
HalfedgeId close_frame(PlaneDraft& draft);

PlaneLoops trace_loops(const PlaneDraft& draft);

/// Per loop its least vertex; invalid for loops along the frame.
std::vector<VertexId> least_vertices(const PlaneDraft& draft, const PlaneLoops& loops);

struct FinishedDraft {
  PlaneComplex complex;
  /// Least half-edge of each ordinary face; invalid: it has none.
  std::vector<HalfedgeId> first_of_face;
};

/// `points` is what vertex_point and line refer to; only what is used is kept.
FinishedDraft finish(const PlaneDraft& draft, const PlaneLoops& loops,
                     const PlaneFaceClasses& classes, PlanePoints points);

// The unique minimal form of a marked complex, in linear time and without a sweep.
//
// Main flow of simplify():
//  1. an edge goes if its mark is that of both faces beside it; these become one (union-find)
//  2. a vertex that keeps no edge goes if its mark is that of its face; one that keeps two on one
//     line goes if its mark is theirs; else it stays
//  3. chains of edges through gone vertices become one edge each, at the place of the first
//  4. trace_loops and finish (plane_draft.h), with the merged faces as classes
// Cost: O(n a(n)), one cross_sign for each vertex that keeps two edges.

/// Requires a complex that is right but for being minimal. Idempotent.
PlaneComplex simplify(PlaneComplex complex);

/// Marks of the interior: an edge or vertex stays marked only if everything around it is.
PlaneMarks interior_marks(const PlaneComplex& complex);
/// Marks of the closure: an edge or vertex is marked if anything around it is.
PlaneMarks closure_marks(const PlaneComplex& complex);

}  // namespace plumb
