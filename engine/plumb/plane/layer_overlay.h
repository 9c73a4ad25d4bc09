// Computes the overlay of two layers. If a feature of the first layer and a feature of the second
// layer overlap, their intersection becomes a feature of the overlay. So each feature of the
// overlay belongs to a pair of features, called partners. The overlay can also contain the parts of
// a feature that no feature of the other layer covers. In the pairs of such parts, one partner is
// missing.
//
// Main flow of overlay_layers():
//  1. CoveredCells     arranges the rings of both layers exactly. Each face of the arrangement gets
//                      the list of the features that cover it.
//  2. pairs            assigns each face to a pair. The partners are the first feature of the first
//                      layer that covers the face, and the first feature of the second layer that
//                      covers it. One of the two partners may be missing
//  3. rounded_labels   leaves out the edges between faces of the same pair, and rounds all
//                      crossings to doubles. All crossings are rounded together, so that the
//                      features of the result form a coverage
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

/// Selects the pairs that the overlay contains.
enum class OverlayPairs : std::uint8_t {
  All,        ///< All pairs.
  First,      ///< Pairs with a feature of the first layer.
  Both,       ///< Pairs with features of both layers.
  FirstOnly,  ///< Pairs with a feature of the first layer only.
};

/// Options of overlay_layers().
struct LayerOverlayOptions {
  OverlayPairs pairs = OverlayPairs::All;  ///< Selects the pairs of the overlay.
  /// Whether LayerOverlay::area is computed. If there are many crossings, computing the exact areas
  /// takes longer than computing the overlay.
  bool with_areas = false;
};

/// The overlay of two layers.
struct LayerOverlay {
  /// A pair of features. If a partner is missing, its entry is LayerRegion::kNobody.
  struct Pair {
    std::uint32_t first;   ///< Feature of the first layer.
    std::uint32_t second;  ///< Feature of the second layer.
    friend bool operator==(const Pair&, const Pair&) = default;
  };

  /// Feature k belongs to pairs[k]. The layer is a coverage: polygons are valid, vertices are
  /// doubles, and features meet only in common edges and vertices. The features have no ids and no
  /// properties.
  Layer layer;
  /// The pairs in ascending order. They are compared by their first partners, and then by their
  /// second partners. A missing partner counts as greater than all others.
  std::vector<Pair> pairs;
  /// The exact area of each pair before rounding. It is empty if LayerOverlayOptions::with_areas is
  /// false.
  std::vector<Rational> area;
  std::vector<Pair> vanished;  ///< Pairs whose whole area vanished by rounding.
  /// The number of regions that several features of the first layer cover, and the corresponding
  /// number for the second layer. Such a region is assigned to the first of these features.
  std::size_t first_overlaps = 0, second_overlaps = 0;
  PlaneRoundingReport rounding;  ///< The changes that rounding has caused.
};

/// Returns the overlay of two layers. Throws Error{NumberOutOfRange} if coordinates are too large
/// to be rounded, ResourceLimit if a limit of the Context is exceeded, and Cancelled if a stop is
/// requested.
LayerOverlay overlay_layers(const Layer& first, const Layer& second,
                            const LayerOverlayOptions& options = {},
                            Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
