// Simplifying a layer: borders get fewer corners, and the layer stays a coverage.
//
// Main flow of simplify_layer():
//  1. CoveredCells, rounded_labels   make the subdivision of the features, with doubles as vertices
//  2. BorderGraph                    removes corners of borders in the order of Visvalingam and
//                                    Whyatt (Line generalisation by repeated elimination of
//                                    points, The Cartographic Journal 30, 1993)
//  3. labelled_arrangement           arranges the remaining borders exactly
//  4. layer_of_labels                traces the polygons of each feature
//
// A border that two features share is simplified once, for both. A corner v between the corners u
// and w of a border may be removed if the closed triangle u v w contains no other corner, and if u
// and w are not joined already. Both are decided exactly. Then no borders cross or touch afterwards
// that did not before: an edge that meets the triangle, but has no end in it, would cross u v or v
// w. So all polygons, holes and neighbours stay, and every ring keeps at least three corners.
// Corners where three or more borders meet stay where they are.
//
// Areas of triangles are computed in doubles. They only order the corners.
//
// Cost: O(n log n) for n corners if triangles contain few corners, and O(n) memory.
#pragma once

#include <cstddef>
#include <limits>

#include "plumb/base/context.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/plane_rounding.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of simplify_layer() and simplify_borders(). A corner is removed only if all options
/// allow this.
struct LayerSimplifyOptions {
  /// Corners are removed while their triangle has at most this area, in square units of the layer.
  /// Infinity sets no bound.
  double tolerance = 0;
  /// The part of the removable corners that stays, between 0 and 1. A corner is removable if
  /// exactly two edges of borders meet there.
  double kept = 0;
  /// Every point of the borders stays within this distance of the borders before, and every point
  /// of the borders before is as near to a border that is left. Infinity sets no bound.
  double within = std::numeric_limits<double>::infinity();
};

/// A simplified layer.
struct SimplifiedLayer {
  /// The features with their ids and properties, in the order of the input. The result is a
  /// coverage: polygons are valid, vertices are doubles, and features meet only in common edges and
  /// vertices. Corners of the result are corners of the input or crossings of its edges.
  Layer layer;
  std::size_t corners_before = 0;  ///< Corners of borders; a common corner counts once.
  std::size_t corners_after = 0;   ///< Corners of borders that are left.
  std::size_t fixed = 0;  ///< Corners that are not removable, as three or more borders meet.
  /// Removable corners that the options would let go, but that stay because their triangle contains
  /// a corner, or because a ring would collapse.
  std::size_t blocked = 0;
  /// An upper bound for the distance between the borders before and after (Hausdorff distance).
  /// What rounding has moved is not included.
  double borders_moved = 0;
  /// The number of regions that several features cover. Such a region belongs to the first one.
  std::size_t overlaps = 0;
  PlaneRoundingReport rounding;  ///< What rounding has changed before corners were removed.
};

/// Returns the layer with simplified borders. Throws Error{BadArgument} if an option is out of its
/// range, Error{NumberOutOfRange} if coordinates are too large to be rounded, ResourceLimit if a
/// limit of the Context is exceeded, and Cancelled if a stop is requested.
SimplifiedLayer simplify_layer(const Layer& layer, const LayerSimplifyOptions& options,
                               Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
