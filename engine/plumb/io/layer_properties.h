// Computes the properties of features for layers that were dissolved or overlaid (layer_dissolve.h,
// layer_overlay.h), and finds features by their ids.
//
// Properties are JSON objects. The text of a value is kept as it is in the file, byte for byte. Two
// values are equal if their texts are equal. Escapes in strings are resolved before strings are
// compared.
//
// Main flow of dissolving:
//  1. group_features         puts features with the same value of a property into one group
//  2. dissolve_layer         makes the polygons of the groups
//  3. with_group_properties  gives each group its id and its properties
// To overlay layers, call overlay_layers(), and then with_pair_properties().
//
// Errors: Error{Syntax} if properties or ids are not valid JSON, ResourceLimit, and Cancelled.
// Cost: O(bytes + n log n) for n features.
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

/// A division of features into groups. The groups are numbered in the order of their first
/// features.
struct FeatureGroups {
  std::vector<std::uint32_t> group;  ///< The group of each feature.
  std::size_t count = 0;             ///< The number of groups.
};

/// Returns groups such that two features are in the same group exactly if they have the same value
/// of `property`. All features that lack the property form one group. Throws Error{BadArgument} if
/// the layer has features, but none of them has the property.
FeatureGroups group_features(const Layer& layer, const std::string& property,
                             Context& context = unlimited_context());

/// Returns the rank of each feature by its id. Ranks count from 0. Features whose ids are numbers
/// come first, in the order of these numbers. Features whose ids are texts follow, in the order of
/// the bytes of the texts. Features without an id come last. Features with equal ids rank in the
/// order of the layer.
std::vector<std::uint32_t> id_ranks(const Layer& layer);

/// Returns the feature that has `text` as its id, or else as its property "name" or "NAME". Throws
/// Error{BadArgument} if no feature or more than one feature has this text.
std::uint32_t feature_called(const Layer& layer, const std::string& text);

/// Returns a single group that contains all features.
FeatureGroups one_group(const Layer& layer);

/// Returns the dissolved layer `shapes` with ids and properties. A group gets an id or a property
/// if all features of the group have the same value of it. The properties are in the order of the
/// group's first feature. The properties named in `sums` are treated in another way: the value for
/// a group is the sum of the values of its features. If all numbers are integers, the sum is exact.
/// If a number has a decimal point or an exponent, each number is replaced by the nearest double,
/// and their exact sum is rounded once. Missing values and null are left out of a sum. Throws
/// Error{BadArgument} if a value in a sum is not a number, or if no feature has the property.
Layer with_group_properties(Layer shapes, const Layer& layer, const FeatureGroups& groups,
                            std::span<const std::string> sums = {},
                            Context& context = unlimited_context());

/// Returns the layer of an overlay. Each feature of this layer belongs to a feature of the first
/// layer and a feature of the second layer, and gets the properties of both. If both layers have a
/// property called NAME, the two properties are renamed to NAME_1 and NAME_2. The ids of the two
/// features become the properties id_1 and id_2. If the overlay has areas, the double nearest to
/// the exact area becomes the property area. If a new name is already the name of another property,
/// underscores are appended to the new name.
Layer with_pair_properties(LayerOverlay overlay, const Layer& first, const Layer& second,
                           Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
