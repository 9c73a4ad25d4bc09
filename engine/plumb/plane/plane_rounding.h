// Rounds the vertices of a subdivision of the plane to doubles, and keeps the subdivision valid.
// The vertices of a set or an overlay are exact points, but most formats store doubles. If each
// coordinate were just replaced by the nearest double, edges could cross, coincide or pass through
// vertices. The functions below round vertices to doubles, and repair these defects. The result has
// the following properties:
//   - Valid: edges meet only at common ends. No edge is degenerate or listed twice.
//   - Near: every point of the new boundary is within PlaneRoundingReport::largest_move of the
//     exact boundary. Conversely, every point of the exact boundary is within this distance of the
//     new boundary. Points of faces and of pieces of edges that were left out are an exception
//     (PlaneRoundingReport::collapsed and edges_folded).
//   - Stable: a vertex whose coordinates are doubles does not move, unless the report counts it as
//     moved. If all coordinates are doubles, the result is the input. So rounding is idempotent.
//   - Reported: a report counts all changes of the shape.
//   - Consistent: faces that share a border still share a border.
//
// Main flow of round_to_doubles() for a subdivision:
//  1. nearest_places    rounds every vertex to the nearest doubles. If all coordinates are doubles,
//                       nothing else happens.
//  2. arrange_edges     arranges the edges between the rounded vertices exactly, in one sweep
//  3. repair_locally    is taken if edges cross. It rounds the crossings, which become vertices,
//                       and looks for further crossings near them. Then step 2 is repeated
//  4. HotPixels         is taken if edges still cross after many repetitions. It rounds all
//                       vertices to a common grid, and bends each edge that passes near a vertex to
//                       this vertex. If edges cross even then, the step is repeated with a grid
//                       that is twice as coarse
//  5. face_labels       finds the exact face to which each new face corresponds, by winding numbers
// The page docs/design/rounding.md proves that this procedure terminates. It also proves bounds for
// the distances by which points move, and proves that step 5 finds exactly one face for each new
// face.
//
// Cost: one sweep if rounding makes no edges cross. Otherwise the cost is the cost of two sweeps,
// plus the cost of the repair near the crossings.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A report about the changes made by rounding. Distances are measured in the maximum norm: the
/// distance between two points is the maximum of the differences of their coordinates.
struct PlaneRoundingReport {
  /// The number of vertices whose rounded coordinates are not the doubles nearest to the exact
  /// coordinates.
  std::size_t vertices_moved = 0;
  /// The number of vertices that vanished because they were rounded to the same point as another
  /// vertex. If k vertices were rounded to one point, k - 1 of them are counted.
  std::size_t vertices_merged = 0;
  /// The number of exact edges that have new corners. An edge gets a new corner where, after
  /// rounding, it passes through another vertex or crosses another edge.
  std::size_t edges_bent = 0;
  /// The number of pieces of edges that were left out because, after rounding, the same face lies
  /// on both sides of the piece. For example, the two sides of a thin spike may coincide.
  std::size_t edges_folded = 0;
  /// The number of bounded faces that were left out because nothing remains of them.
  std::size_t collapsed = 0;
  /// An upper bound for the distance by which any point of an edge has moved.
  double largest_move = 0;
  /// The difference between the largest magnitude of all coordinates and the next greater double
  /// (one unit in the last place). It is 0 if there are no vertices.
  double largest_ulp = 0;

  /// Whether anything was changed besides the rounding of each vertex to the nearest doubles.
  bool is_changed() const {
    return vertices_moved + vertices_merged + edges_bent + edges_folded + collapsed != 0;
  }
  /// Whether no point moved by more than largest_ulp / 2, and is_changed() is false.
  bool is_faithful() const {
    const double half = std::max(largest_ulp / 2, std::numeric_limits<double>::denorm_min());
    return !is_changed() && largest_move <= half;
  }
  friend bool operator==(const PlaneRoundingReport&, const PlaneRoundingReport&) = default;
};

/// A subdivision whose vertices have doubles as coordinates.
struct RoundedSubdivision {
  /// The subdivision. Every vertex is an input point whose coordinates are doubles. Each face has
  /// the mark of the exact face to which it corresponds. An edge is marked if a face beside it is
  /// marked. It is also marked if it was made from a marked edge between unmarked faces. A vertex
  /// is marked if an edge or face at the vertex is marked, or if it was made from a marked isolated
  /// vertex.
  PlaneComplex complex;
  /// For each face of the complex, the corresponding face of the exact subdivision. Several faces
  /// may correspond to the same exact face. Two neighbouring faces correspond to different exact
  /// faces, unless a marked edge separates them.
  IdVector<FaceId, FaceId> exact_face;
  PlaneRoundingReport report;  ///< The changes made by rounding.
};

/// Returns the subdivision with its vertices rounded to doubles. If an edge has the same face on
/// both sides, it is left out. A marked edge in an unmarked face is an exception. If the
/// subdivision has a frame, unbounded edges are left out, and all unbounded faces become a single
/// unmarked face. This face corresponds to face 0 of the exact subdivision. If all coordinates are
/// doubles and there is no frame, the function returns the exact subdivision. Throws
/// Error{NumberOutOfRange} if a coordinate lies beyond the largest double. Also throws the errors
/// of the Context.
RoundedSubdivision round_to_doubles(const PlaneComplex& exact,
                                    Context& context = unlimited_context());

/// Returns the subdivision with its vertices rounded to a grid. Coordinates on the grid are
/// multiples of `step`, such as 1/1000 or a power of two. If such a multiple is not a double, the
/// nearest double replaces it. A point moves by at most half a step, plus half a unit in the last
/// place if doubles replace multiples of the step. If an edge passes a vertex at a distance of at
/// most half a step, the edge is bent to this vertex (snap rounding). If all vertices lie on the
/// grid already and there is no frame, the function returns the exact subdivision. Throws
/// Error{BadArgument} if step <= 0. Also throws as round_to_doubles() does.
RoundedSubdivision round_to_grid(const PlaneComplex& exact, const Rational& step,
                                 Context& context = unlimited_context());

/// A closed set whose vertices have doubles as coordinates.
struct RoundedSet {
  Nef2 set;                    ///< The set.
  PlaneRoundingReport report;  ///< The changes made by rounding.
};

/// Returns the closure of a set, rounded to doubles in the same way as a subdivision. If the
/// closure has a frame, its unbounded parts are left out. If all coordinates are doubles and there
/// is no frame, the function returns the closure. Throws as round_to_doubles() for a subdivision
/// does.
RoundedSet round_to_doubles(const Nef2& set, Context& context = unlimited_context());

/// Returns the closure of a set, rounded to a grid in the same way as a subdivision. Throws as
/// round_to_grid() for a subdivision does.
RoundedSet round_to_grid(const Nef2& set, const Rational& step,
                         Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
