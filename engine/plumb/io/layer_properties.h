// Properties of layers that were dissolved or overlaid (layer_dissolve.h, layer_overlay.h), and
// features by their ids.
//
// Properties are JSON objects. Their values are kept as they stand in the file, byte for byte. Two
// values are equal if they are the same text; texts in quotes are compared after their escapes are
// resolved.
//
// Main flow of dissolving:
//  1. group_features         puts features with the same value of a property into one group
//  2. dissolve_layer         makes the polygons of the groups
//  3. with_group_properties  gives each group its id and its properties
// The flow of overlaying is overlay_layers(), then with_pair_properties().
//
// Errors: Error{Syntax} if properties or ids are no JSON; ResourceLimit and Cancelled. Cost:
// O(bytes), and O(n log n) for n features.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/layer_overlay.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Groups of features, numbered in the order of their first features.
struct FeatureGroups {
  std::vector<std::uint32_t> group;  ///< For each feature, its group.
  std::size_t count = 0;             ///< The number of groups.
};

/// Returns the groups of features with the same value of a property. The features that lack the
/// property are a group, too. Throws Error{BadArgument} if there are features and none of them has
/// the property.
FeatureGroups group_features(const Layer& layer, const std::string& property,
                             Context& context = unlimited_context());

/// Returns for each feature its rank by ids, from 0: numbers by value, then texts by their bytes,
/// then features without an id. Features with equal ids rank in the order of the layer.
std::vector<std::uint32_t> id_ranks(const Layer& layer);

/// Returns the feature that has `text` as its id, or else as its property "name" or "NAME". Throws
/// Error{BadArgument} if there is none, or more than one.
std::uint32_t feature_called(const Layer& layer, const std::string& text);

/// Returns one group of all features.
FeatureGroups one_group(const Layer& layer);

/// Returns the dissolved layer `shapes` with ids and properties. A group has an id or a property if
/// all its features have it with the same value. Properties come in the order of the first feature.
/// A property named in `sums` is the sum of the numbers of all features of the group instead:
/// integers are added exactly; if a number has a point or an exponent, the nearest doubles are
/// added exactly, and the sum is rounded once. Missing values and null are left out of a sum.
/// Throws Error{BadArgument} if a value to be added is no number, or if no feature has the
/// property.
Layer with_group_properties(Layer shapes, const Layer& layer, const FeatureGroups& groups,
                            std::span<const std::string> sums = {},
                            Context& context = unlimited_context());

/// Returns the layer of an overlay with the properties of both partners of each pair. If both
/// layers have a property of the same name, it is called NAME_1 and NAME_2. The ids of the partners
/// are the properties id_1 and id_2, and the area, if it was computed, is the property area: the
/// double nearest to the exact area. If such a name is taken already, underscores are appended.
Layer with_pair_properties(LayerOverlay overlay, const Layer& first, const Layer& second,
                           Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
