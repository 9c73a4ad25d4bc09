// The overlay of two checked subdivisions. The overlay is a subdivision in which every face lies in
// exactly one region of each map. measure() checks exactly that the areas of the faces add up to
// the areas of the regions from which they were cut.
//
// Main flow of overlay_maps(): one sweep visits the edges of both maps together. Every face gets a
// label, a pair of regions (one of each map). At every event, the sweep derives the label of the
// face above each edge from the label of the face below it (plane_builder.h, docs/design/sweep.md).
// Cost: O((n + k) log n) time for n edges and k crossings.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/map_check.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The overlay of two maps.
struct MapOverlay {
  /// A pair of regions, one of each map. Region 0 is the unbounded one.
  struct Origin {
    std::uint32_t first;   ///< Region of the first map, an index into its report.regions.
    std::uint32_t second;  ///< Region of the second map, an index into its report.regions.
    friend bool operator==(const Origin&, const Origin&) = default;
  };

  PlaneComplex complex;        ///< The subdivision by the edges of both maps. No cell is marked.
  std::vector<Origin> origin;  ///< For each face of the complex, the regions that contain it.
};

/// Returns the overlay of two subdivisions. Throws Error{BadArgument} if one of the verdicts is not
/// Valid, or if a directed edge of a map has no twin. Throws ResourceLimit and Cancelled as the
/// Context demands.
MapOverlay overlay_maps(const MapReport& first, const MapReport& second,
                        Context& context = unlimited_context());

/// Returns a single subdivision in the form of an overlay: Origin::second is 0 for every face.
/// Throws as overlay_maps() does.
MapOverlay overlay_map(const MapReport& report, Context& context = unlimited_context());

// --- areas of an overlay ----------------------------------------------------------------------

/// Exact areas of the faces of an overlay, and of the regions from which they were cut.
struct OverlayAreas {
  std::vector<Rational> cell;  ///< Area of each face of the complex; 0 for unbounded faces.
  /// Area of each region of the first map and of each region of the second map. Each area is
  /// computed from the listed cycles of the region, and holes are subtracted. Region 0 has area 0.
  std::vector<Rational> first, second;
  /// Bounded regions of the first map and of the second map whose area differs from the sum of the
  /// areas of their faces, in ascending order. An entry in one of these lists reveals a defect of
  /// the library.
  std::vector<std::uint32_t> wrong_first, wrong_second;

  /// Whether the area of every bounded region equals the sum of the areas of its faces.
  bool add_up() const { return wrong_first.empty() && wrong_second.empty(); }
};

/// Returns the exact areas of the faces and of the regions. Requires that `overlay` is the overlay
/// of these two reports, in this order. Throws ResourceLimit and Cancelled as the Context demands.
/// Cost: the sum of O(n) rational terms.
OverlayAreas measure(const MapOverlay& overlay, const MapReport& first, const MapReport& second,
                     Context& context = unlimited_context());

/// Returns the sum of areas. For OverlayAreas::first this is the area that the bounded regions of
/// the first map cover together.
Rational sum_of(const std::vector<Rational>& areas);

}  // namespace plumb
#pragma GCC visibility pop
