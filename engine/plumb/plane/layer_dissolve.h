// Dissolves a layer: all features of a group become one feature, and the borders between them
// vanish. An example is a layer of counties that becomes a layer of states.
//
// Main flow of dissolve_layer():
//  1. CoveredCells     arranges the rings of all features exactly. Each face of the arrangement
//                      gets the list of the features that cover it.
//  2. labels           assigns each face to the group of the first feature that covers it
//  3. rounded_labels   leaves out the edges between faces of the same group, and rounds the
//                      remaining crossings of edges to doubles. If the layer is a coverage whose
//                      corners are doubles, it has no crossings, and nothing is rounded
//  4. layer_of_labels  traces the polygons of each group
//
// Cost: O((n + k) log n) for n corners and k crossings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "plumb/base/context.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/plane_rounding.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A dissolved layer.
struct DissolvedLayer {
  /// Feature k is group k. The result is a coverage: polygons are valid, vertices are doubles, and
  /// features meet only in common edges and vertices. The features have no ids and no properties.
  Layer layer;
  /// The number of regions that several features of different groups cover. Such a region is
  /// assigned to the group of the first of these features.
  std::size_t overlaps = 0;
  PlaneRoundingReport rounding;  ///< The changes that rounding has caused.
};

/// Returns a layer with one feature for each group. group[f] is the group of feature f, which is
/// less than `group_count`. If group[f] is LayerRegion::kNobody, feature f is left out. An overlap
/// of features of the same group vanishes, and a gap between them remains. Throws
/// Error{BadArgument} if `group` does not have one entry for each feature, or if an entry is out of
/// range. Throws Error{NumberOutOfRange} if coordinates are too large to be rounded. Also throws
/// the errors of the Context.
DissolvedLayer dissolve_layer(const Layer& layer, std::span<const std::uint32_t> group,
                              std::size_t group_count, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
