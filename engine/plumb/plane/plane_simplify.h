// Simplifies a set of the plane: borders and lines get fewer corners, and the set keeps its
// topology.
//
// Main flow of simplify_borders():
//  1. round_to_doubles      makes the closure of the set, and rounds its vertices to doubles
//                           (plane_rounding.h)
//  2. BorderGraph           removes corners in the order of Visvalingam and Whyatt, exactly as
//                           simplify_layer() does (layer_simplify.h)
//  3. labelled_arrangement  arranges the remaining edges exactly
//  4. Nef2::from_complex    makes the simplified set from the labelled faces
//
// The triangle of a corner has the corner and its two neighbours along the border as vertices. A
// corner is removed only if its closed triangle contains no other vertex. So the removal makes no
// edges cross or touch. No face, hole, line or isolated point vanishes, and every ring keeps at
// least three corners. Only vertices at which exactly two edges meet are removed.
//
// Cost: O(n log n) for n corners if the triangle of each corner contains few other corners, and
// O(n) memory.
#pragma once

#include <cstddef>

#include "plumb/base/context.h"
#include "plumb/plane/layer_simplify.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_rounding.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A simplified set.
struct SimplifiedSet {
  /// The closed set. Its vertices are vertices of the rounded closure of the input.
  Nef2 set;
  std::size_t corners_before = 0;  ///< The number of vertices of the rounded closure.
  std::size_t corners_after = 0;   ///< The number of vertices of the simplified set.
  /// The number of vertices whose removal the options allow. They are kept for another reason:
  /// their triangle contains another vertex, or a ring would collapse.
  std::size_t blocked = 0;
  /// An upper bound for the distance between the original borders and the simplified borders
  /// (Hausdorff distance). Movements by rounding are not included.
  double borders_moved = 0;
  PlaneRoundingReport rounding;  ///< The changes by rounding before corners are removed.
};

/// Returns the closure of a set with fewer corners. Throws Error{BadArgument} if the set is
/// unbounded or an option is out of its range. Throws Error{NumberOutOfRange} if a coordinate lies
/// beyond the largest double. Also throws the errors of the Context.
SimplifiedSet simplify_borders(const Nef2& set, const LayerSimplifyOptions& options,
                               Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
