// The overlay of two checked subdivisions: one subdivision each of whose cells lies in one cell of
// either map; and an exact check that the areas of its faces add up to the areas of the regions
// that they were cut from.
//
// Main flow of overlay_maps(): one sweep visits the edges of both maps together. A label, the pair
// of regions (one of each map), is carried upward through every event (plane_builder.h,
// docs/design/sweep.md). Cost: O((n + k) log n) time for n edges and k crossings.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Two maps as one subdivision.
struct MapOverlay {
  /// A pair of regions, one of each map. Region 0 is the unbounded one.
  struct Origin {
    std::uint32_t first;   ///< Region of the first map, an index into its report.regions.
    std::uint32_t second;  ///< Region of the second map, likewise.
    friend bool operator==(const Origin&, const Origin&) = default;
  };

  PlaneComplex complex;        ///< Every edge of either map. No cell is marked.
  std::vector<Origin> origin;  ///< For each face of the complex, the regions that contain it.
};

/// Returns the overlay of two subdivisions. Throws Error{BadArgument} unless both verdicts are
/// Valid and no border is open; ResourceLimit and Cancelled as the Context demands.
MapOverlay overlay_maps(const MapReport& first, const MapReport& second,
                        Context& context = unlimited_context());

/// Returns one subdivision as a complex; the second region of every origin is 0. Errors as
/// overlay_maps().
MapOverlay overlay_map(const MapReport& report, Context& context = unlimited_context());

// --- areas of an overlay ----------------------------------------------------------------------

/// Exact areas of the cells of an overlay and of the regions that they were cut from.
struct OverlayAreas {
  std::vector<Rational> cell;  ///< Area of each face of the complex; 0 for unbounded faces.
  /// Area of each region of the first and of the second map, computed from its listed cycles with
  /// holes subtracted; 0 for region 0.
  std::vector<Rational> first, second;
  /// Bounded regions whose area differs from the sum of the areas of their cells, ascending. Both
  /// lists are empty unless the library has a defect.
  std::vector<std::uint32_t> wrong_first, wrong_second;

  /// Whether the cells of every bounded region add up to its area.
  bool add_up() const { return wrong_first.empty() && wrong_second.empty(); }
};

/// Returns the exact areas of the cells and of the regions. Requires that `overlay` is the overlay
/// of these two reports, in this order. Throws ResourceLimit and Cancelled as the Context demands.
/// O(n) rational terms.
OverlayAreas measure(const MapOverlay& overlay, const MapReport& first, const MapReport& second,
                     Context& context = unlimited_context());

/// Returns the sum of areas. For OverlayAreas::first this is the area that the bounded regions of
/// the first map cover together.
Rational sum_of(const std::vector<Rational>& areas);

}  // namespace plumb
#pragma GCC visibility pop
