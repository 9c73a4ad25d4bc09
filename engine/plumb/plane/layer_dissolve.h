// Dissolving a layer: features of one group become one feature, and the borders between them
// vanish. An example is a layer of counties that becomes a layer of states.
//
// Main flow of dissolve_layer():
//  1. CoveredCells     arranges the rings of all features exactly. Each face gets the list of the
//                      features that cover it.
//  2. labels           each face belongs to the group of the first feature that covers it
//  3. rounded_labels   leaves out the edges between faces of one group, and rounds the crossings
//                      that remain. In a coverage of doubles there are none, so nothing is rounded.
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
  /// features meet only in common edges and vertices. There are no ids and no properties.
  Layer layer;
  /// The number of regions that features of different groups cover. Such a region belongs to the
  /// group of the first one of these features.
  std::size_t overlaps = 0;
  PlaneRoundingReport rounding;  ///< What rounding has changed.
};

/// Returns the groups of a layer as features. `group` has an entry for each feature, less than
/// `group_count`. An entry may also be LayerRegion::kNobody, and the feature is left out. Overlaps
/// and gaps within a group are not repaired: an overlap vanishes, and a gap stays. Throws
/// Error{BadArgument} if the entries are wrong, Error{NumberOutOfRange} if coordinates are too
/// large to be rounded, ResourceLimit if a limit of the Context is exceeded, and Cancelled if a
/// stop is requested.
DissolvedLayer dissolve_layer(const Layer& layer, std::span<const std::uint32_t> group,
                              std::size_t group_count, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
