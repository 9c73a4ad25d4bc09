// Rounding that keeps a subdivision valid. The vertices of a set or an overlay are exact points,
// and most formats store doubles. If every vertex is replaced by the nearest doubles, edges may
// cross, fall together or pass through vertices. The functions below round vertices to doubles, and
// repair what the rounding damages:
//   - Valid: edges meet only in common ends. No edge is degenerate or listed twice.
//   - Near: every point of the new boundary is within PlaneRoundingReport::largest_move of the
//     exact boundary. Every point of the exact boundary is as near to the new boundary, unless it
//     belongs to a part that is reported as collapsed or folded.
//   - Still: a vertex whose coordinates are doubles does not move, unless the report counts it. If
//     all coordinates are doubles, the result is the input. So rounding is idempotent.
//   - Told: the report counts what has changed.
//   - A subdivision stays a subdivision: faces that share a border still share a border.
//
// Main flow of round_to_doubles() for a subdivision:
//  1. nearest_places    rounds every vertex to the nearest doubles. If all coordinates are doubles,
//                       nothing else happens.
//  2. arrange_edges     arranges the edges between the rounded vertices exactly, in one sweep
//  3. repair_locally    if edges cross: rounds the crossings, and looks again around them only.
//                       Then step 2 is repeated.
//  4. HotPixels         if edges still cross after many rounds: rounds all vertices to a common
//                       grid, and bends edges that pass near a vertex to this vertex. Then the
//                       grid is made twice as coarse until no edges cross.
//  5. face_labels       finds the exact face that each new face stands for, by winding numbers
// docs/design/rounding.md proves that this ends, bounds the moves, and shows that labels are
// consistent.
//
// Cost: one sweep if rounding damages nothing, and two sweeps and the work around the damage
// otherwise.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What rounding has changed. Distances are measured in the maximum norm: the distance between two
/// points is the greater one of the differences of their coordinates.
struct PlaneRoundingReport {
  /// The number of exact vertices that are not at their nearest doubles.
  std::size_t vertices_moved = 0;
  /// The number of exact vertices that fell on another one. If k vertices are now one, k - 1 of
  /// them count.
  std::size_t vertices_merged = 0;
  /// The number of exact edges that have new corners, because they pass through other vertices or
  /// cross other edges now.
  std::size_t edges_bent = 0;
  /// The number of pieces of edges that were left out because the same face is on both sides of
  /// them now. For example, two edges of a spike may fall together.
  std::size_t edges_folded = 0;
  /// The number of bounded faces that were left out because nothing remains of them.
  std::size_t collapsed = 0;
  /// An upper bound for the distance between a point of an edge and the point on the exact edge
  /// from which it comes.
  double largest_move = 0;
  /// The distance from the greatest magnitude of a coordinate to the next greater double; 0 if
  /// there are no vertices.
  double largest_ulp = 0;

  /// Whether anything was changed besides the rounding of each vertex to the nearest doubles.
  bool is_changed() const {
    return vertices_moved + vertices_merged + edges_bent + edges_folded + collapsed != 0;
  }
  /// Whether every point stayed within half a unit in the last place of the largest coordinate, and
  /// nothing was changed besides.
  bool is_faithful() const {
    const double half = std::max(largest_ulp / 2, std::numeric_limits<double>::denorm_min());
    return !is_changed() && largest_move <= half;
  }
  friend bool operator==(const PlaneRoundingReport&, const PlaneRoundingReport&) = default;
};

/// A subdivision whose vertices are doubles.
struct RoundedSubdivision {
  /// The subdivision. Every vertex is an input point whose coordinates are doubles. Each face has
  /// the mark of its exact face. An edge is marked if a face beside it is marked, or if it comes
  /// from a marked edge between faces that are not marked. A vertex is marked if a cell at it is
  /// marked, or if it comes from a marked isolated vertex.
  PlaneComplex complex;
  /// For each face of the complex, the face of the exact subdivision that it stands for. Several
  /// faces may stand for one face. Neighbouring faces stand for different faces, unless a marked
  /// edge separates them.
  IdVector<FaceId, FaceId> exact_face;
  PlaneRoundingReport report;  ///< What has changed.
};

/// Returns a subdivision with vertices at doubles. Edges that have the same face on both sides are
/// left out, unless the edge is marked and the face is not. If the subdivision has a frame,
/// unbounded edges are left out, and all unbounded faces become one face without a mark, which
/// stands for face 0. If all vertices are doubles and there is no frame, the result is the exact
/// subdivision. Throws Error{NumberOutOfRange} if a coordinate lies beyond the largest double,
/// ResourceLimit if a limit of the Context is exceeded, and Cancelled if a stop is requested.
RoundedSubdivision round_to_doubles(const PlaneComplex& exact,
                                    Context& context = unlimited_context());

/// Returns a subdivision whose coordinates are the nearest doubles of multiples of `step`, such as
/// 1/1000 or a power of two. Every point moves by at most half a step; if a multiple of the step is
/// not a double, half a unit in the last place is added. Edges are bent to the vertices of the grid
/// that they pass within half a step (snap rounding). If all coordinates are such doubles and there
/// is no frame, the result is the exact subdivision. Throws Error{BadArgument} if step <= 0, and as
/// round_to_doubles() does.
RoundedSubdivision round_to_grid(const PlaneComplex& exact, const Rational& step,
                                 Context& context = unlimited_context());

/// A closed set whose vertices are doubles.
struct RoundedSet {
  Nef2 set;                    ///< The set.
  PlaneRoundingReport report;  ///< What has changed.
};

/// Returns the closure of a set, rounded to doubles as a subdivision. If the closure has a frame,
/// its unbounded parts are left out. If all coordinates are doubles and there is no frame, the
/// result is the closure. PlaneParts and PlaneShapes of the result have coordinates that are
/// doubles, so coordinates_of() does not round them. Throws as the function above does.
RoundedSet round_to_doubles(const Nef2& set, Context& context = unlimited_context());

/// Returns the closure of a set, rounded to a grid as a subdivision.
RoundedSet round_to_grid(const Nef2& set, const Rational& step,
                         Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
