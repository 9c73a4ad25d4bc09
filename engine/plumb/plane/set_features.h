// Divides a set of the plane into features. The set was made from the features of layers, and each
// part of the set is assigned to the feature from which it was made. For example, suppose that a
// set is the intersection of some countries with a circle. Then set_features() divides this set
// into countries again, with their ids and properties.
//
// Operations on sets do not keep track of features. Instead, set_features() computes the exact
// overlay of the set and the features. This finds the right feature for each part, for the
// following reason. A union, intersection or difference contains only points of its operands. So a
// part of the result that lies in a feature was made from this feature.
//
// Main flow of set_features():
//  1. CoveredCells      arranges the rings of all features and the borders of the set exactly. Each
//                       face of the arrangement gets the list of the features that cover it.
//  2. labels            assigns each face of the set to the first feature that covers it, or to no
//                       feature
//  3. rounded_labels    leaves out the edges between faces of the same feature, and rounds the
//                       other edges. All of them are rounded together, so that the parts form a
//                       coverage
//  4. layer_of_labels   traces the polygons of each feature
//
// Cost: O((n + k) log n) for n corners and k crossings.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_rounding.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A set, divided into the features from which its parts come.
struct SetFeatures {
  /// The parts of the set as features. There is one feature for each source feature that covers a
  /// part of the set. It has the id and the properties of the source feature. Features are in the
  /// order of the source features. If there are parts that no source feature covers, they form one
  /// more feature at the end, without id and properties. The layer is a coverage of the closure of
  /// the set: polygons are valid, vertices are doubles, and features meet only in common edges and
  /// vertices.
  Layer layer;
  /// For each feature of `layer`, the index of its source feature. The entry is
  /// LayerRegion::kNobody for the feature of the parts that no source feature covers.
  std::vector<std::uint32_t> source;
  /// Source features whose parts of the set vanished completely by rounding.
  std::vector<std::uint32_t> vanished;
  bool is_unbounded = false;     ///< Whether unbounded faces were left out.
  bool has_thin_parts = false;   ///< Whether lines and points were left out.
  PlaneRoundingReport rounding;  ///< The changes that rounding has caused.
};

/// Divides a set into the parts that the features of `sources` cover. A part that several features
/// cover is assigned to the first of them. So if the set was made by a Boolean operation, `sources`
/// should contain the features of the first operand before the features of the second operand
/// (append_layer()). A feature covers the points that the rings of its polygons enclose by the
/// even-odd rule. Throws Error{NumberOutOfRange} if coordinates are too large to be rounded, and
/// the errors of the Context.
[[nodiscard]] SetFeatures set_features(const Nef2& set, const Layer& sources,
                                       Context& context = unlimited_context());

/// Appends the features of `more`, with their ids and properties. Throws Error{ResourceLimit} if
/// the layer would have more corners than indices can number. Cost: O(size of `more`).
void append_layer(Layer& layer, const Layer& more);

}  // namespace plumb
#pragma GCC visibility pop
