// Simplifies a layer: borders get fewer corners, and the result is a coverage (layer.h).
//
// Main flow of simplify_layer():
//  1. CoveredCells, rounded_labels   make the subdivision of the features, with doubles as vertices
//  2. BorderGraph                    removes corners of borders in the order of Visvalingam and
//                                    Whyatt (Line generalisation by repeated elimination of
//                                    points, The Cartographic Journal 30, 1993)
//  3. labelled_arrangement           arranges the remaining borders exactly
//  4. layer_of_labels                traces the polygons of each feature
//
// A border that two features share is stored only once, so both features get the same simplified
// border. Let u, v and w be consecutive corners of a border. The corner v may be removed if two
// conditions hold: the closed triangle u v w contains no other corner, and no edge joins u and w
// already. The segment u w then replaces the segments u v and v w. Both conditions are decided
// exactly. The removal then makes no borders cross or touch. By the first condition, no other edge
// ends in the triangle. An edge that crosses u w and has no end in the triangle would also cross u
// v or v w. This is impossible, because edges of borders do not cross. So no polygon or hole
// vanishes, features have the same neighbours as before, and every ring keeps at least three
// corners. A corner where three or more borders meet is never removed.
//
// Areas of triangles are computed in doubles. These areas only decide in which order corners are
// removed, and when the removal stops.
//
// Cost: O(n log n) for n corners if the triangle of each corner contains few other corners, and
// O(n) memory.
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
  /// The largest area of a triangle u v w (see above) whose corner v may be removed, in square
  /// units of the layer. Infinity means that there is no bound.
  double tolerance = 0;
  /// The removal stops when only this fraction of the removable corners is left. The value lies
  /// between 0 and 1. A corner is removable if exactly two edges of borders meet at the corner.
  double kept = 0;
  /// The largest distance by which borders may move. Every point of the simplified borders lies
  /// within this distance of the original borders, and every point of the original borders lies
  /// within this distance of the simplified borders. Infinity means that there is no bound.
  double within = std::numeric_limits<double>::infinity();
};

/// A simplified layer.
struct SimplifiedLayer {
  /// The features with their ids and properties, in the order of the input. The result is a
  /// coverage: polygons are valid, vertices are doubles, and features meet only in common edges and
  /// vertices. Corners of the result are corners of the input or crossings of its edges.
  Layer layer;
  /// The number of corners of the original borders. A corner of several borders is counted once.
  std::size_t corners_before = 0;
  std::size_t corners_after = 0;  ///< The number of corners of the simplified borders.
  /// The number of corners that are not removable because three or more borders meet there.
  std::size_t fixed = 0;
  /// The number of corners whose removal the options allow. They are kept for another reason: their
  /// triangle contains another corner, or a ring would collapse.
  std::size_t blocked = 0;
  /// An upper bound for the distance between the original borders and the simplified borders
  /// (Hausdorff distance). Movements by rounding are not included.
  double borders_moved = 0;
  /// The number of regions that several features cover. Such a region is assigned to the first of
  /// these features.
  std::size_t overlaps = 0;
  PlaneRoundingReport rounding;  ///< The changes by rounding before corners are removed.
};

/// Returns the layer with simplified borders. Throws Error{BadArgument} if an option is out of its
/// range. Throws Error{NumberOutOfRange} if coordinates are too large to be rounded. Also throws
/// the errors of the Context.
SimplifiedLayer simplify_layer(const Layer& layer, const LayerSimplifyOptions& options,
                               Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
