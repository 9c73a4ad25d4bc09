// The overlay of two layers: every pair of a feature of the first layer and a feature of the second
// layer that have common points becomes one feature.
//
// Main flow of overlay_layers():
//  1. CoveredCells     arranges the rings of both layers exactly. Each face gets the list of the
//                      features that cover it.
//  2. pairs            each face belongs to the pair of the first feature of each layer that covers
//                      it; the second partner or the first partner may be missing
//  3. rounded_labels   leaves out the edges between faces of one pair, and rounds all crossings
//                      together, so that the pairs stay a coverage
//  4. layer_of_labels  traces the polygons of each pair
//
// The layers may have lakes, overlaps, gaps, and rings that touch.
//
// Cost: O((n + k) log n) for n corners and k crossings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/layer.h"
#include "plumb/plane/plane_rounding.h"
#include "plumb/predicates/rational.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Which pairs an overlay keeps.
enum class OverlayPairs : std::uint8_t {
  All,        ///< What any of the layers covers.
  First,      ///< What the first layer covers, whether the second one covers it or not.
  Both,       ///< What both layers cover.
  FirstOnly,  ///< What the first layer covers and the second one does not cover.
};

/// Options of overlay_layers().
struct LayerOverlayOptions {
  OverlayPairs pairs = OverlayPairs::All;  ///< Which pairs are kept.
  /// Whether LayerOverlay::area is computed. Exact areas of many crossings take longer than the
  /// overlay.
  bool with_areas = false;
};

/// The overlay of two layers.
struct LayerOverlay {
  /// A pair of features. A partner that is missing is LayerRegion::kNobody.
  struct Pair {
    std::uint32_t first;   ///< Feature of the first layer.
    std::uint32_t second;  ///< Feature of the second layer.
    friend bool operator==(const Pair&, const Pair&) = default;
  };

  /// Feature k is pair k. The result is a coverage: polygons are valid, vertices are doubles, and
  /// features meet only in common edges and vertices. There are no ids and no properties.
  Layer layer;
  /// The pairs in ascending order. A missing partner comes last.
  std::vector<Pair> pairs;
  /// For each pair, the exact area before rounding. Empty if no areas were asked for.
  std::vector<Rational> area;
  std::vector<Pair> vanished;  ///< Pairs of which nothing remains after rounding.
  /// The numbers of regions that several features of the first layer cover, and of the second
  /// layer. Such a region belongs to the first one of these features.
  std::size_t first_overlaps = 0, second_overlaps = 0;
  PlaneRoundingReport rounding;  ///< What rounding has changed.
};

/// Returns the overlay of two layers. Throws Error{NumberOutOfRange} if coordinates are too large
/// to be rounded, ResourceLimit if a limit of the Context is exceeded, and Cancelled if a stop is
/// requested.
LayerOverlay overlay_layers(const Layer& first, const Layer& second,
                            const LayerOverlayOptions& options = {},
                            Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
