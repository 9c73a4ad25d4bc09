// The features of a set of the plane: which parts of a set come from which features of the layers
// that it was made from. For example, the intersection of a layer of countries with a circle is a
// set; set_features() divides it into the countries again, with their ids and properties.
//
// Nothing is threaded through operations. A set is laid over the features afterwards, exactly:
// operations make no points that their operands do not have, so a part of a result that lies in a
// feature comes from this feature.
//
// Main flow of set_features():
//  1. CoveredCells      arranges the rings of all features and the borders of the set exactly. Each
//                       face gets the list of the features that cover it.
//  2. labels            each face of the set belongs to the first feature that covers it, or to
//                       none
//  3. rounded_labels    leaves out the edges between faces of one feature, and rounds the others
//                       together, so that the parts stay a coverage
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
  /// A feature for each source feature that has a part of the set, in the order of the sources,
  /// with its id and its properties. If there are parts that no source feature covers, they are the
  /// last feature, which has no id and no properties. The result is a coverage of the closure of
  /// the set: polygons are valid, vertices are doubles, and features meet only in common edges and
  /// vertices.
  Layer layer;
  /// For each feature of `layer`, the source feature; LayerRegion::kNobody for the last one if no
  /// source feature covers it.
  std::vector<std::uint32_t> source;
  std::vector<std::uint32_t> vanished;  ///< Source features of whose parts rounding leaves nothing.
  bool is_unbounded = false;            ///< Whether unbounded faces were left out.
  bool has_thin_parts = false;          ///< Whether lines and points were left out.
  PlaneRoundingReport rounding;         ///< What rounding has changed.
};

/// Returns the parts of a set that the features of a layer cover. Where several features cover a
/// part, it belongs to the first of them, so the features of the first operand of an operation
/// should come first (append_layer()). A feature covers the points that the rings of its polygons
/// enclose by the even-odd rule. Throws Error{NumberOutOfRange} if coordinates are too large to be
/// rounded, and what the context throws.
[[nodiscard]] SetFeatures set_features(const Nef2& set, const Layer& sources,
                                       Context& context = unlimited_context());

/// Appends the features of `more`, with their ids and properties. Throws Error{ResourceLimit} if
/// the layer would have more corners than indices can number. O(size of `more`).
void append_layer(Layer& layer, const Layer& more);

}  // namespace plumb
#pragma GCC visibility pop
