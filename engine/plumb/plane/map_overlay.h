// The overlay of two checked subdivisions. The overlay is the subdivision of the plane by the edges
// of both maps. Every face of the overlay lies in exactly one region of each map. measure() checks
// with exact arithmetic that the area of each region is the sum of the areas of the faces in this
// region.
//
// Main flow of overlay_maps(): one sweep visits the edges of both maps. Every face gets a label.
// The label is a pair: the region of the first map and the region of the second map that contain
// the face. At every event, the sweep visits the edges from bottom to top. It computes the label of
// the face above an edge from the label of the face below this edge (plane_builder.h,
// docs/design/sweep.md). Cost: O((n + k) log n) time for n edges of both maps together and k
// crossings.
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
  /// A pair of regions, one of each map. Region 0 is the unbounded region.
  struct Origin {
    std::uint32_t first;   ///< Region of the first map, an index into its report.regions.
    std::uint32_t second;  ///< Region of the second map, an index into its report.regions.
    friend bool operator==(const Origin&, const Origin&) = default;
  };

  PlaneComplex complex;        ///< The subdivision by the edges of both maps. No cell is marked.
  std::vector<Origin> origin;  ///< For each face of the complex, the regions that contain it.
};

/// Returns the overlay of two subdivisions. Throws Error{BadArgument} if the verdict of a report is
/// not Valid. Also throws Error{BadArgument} if a cycle uses a directed edge, but no cycle uses the
/// twin of this edge. Throws ResourceLimit if a limit of the Context is exceeded, and Cancelled if
/// a stop is requested.
MapOverlay overlay_maps(const MapReport& first, const MapReport& second,
                        Context& context = unlimited_context());

/// Returns a single subdivision in the form of a MapOverlay. The index Origin::second is 0 for
/// every face. Throws as overlay_maps() does.
MapOverlay overlay_map(const MapReport& report, Context& context = unlimited_context());

// --- areas of an overlay ----------------------------------------------------------------------

/// Exact areas of the faces of an overlay, and of the regions of both maps.
struct OverlayAreas {
  std::vector<Rational> cell;  ///< Area of each face of the complex; 0 for unbounded faces.
  /// Area of each region of the first map, and of each region of the second map. Each area is
  /// computed from the listed cycles of the region; the areas of its holes are subtracted. The
  /// entry of region 0, which is unbounded, is 0.
  std::vector<Rational> first, second;
  /// The bounded regions of the first map and of the second map that have a wrong area, in
  /// ascending order. The area of a region is wrong if it differs from the sum of the areas of the
  /// faces in the region. A correct library never lists a region here.
  std::vector<std::uint32_t> wrong_first, wrong_second;

  /// Whether the area of every bounded region equals the sum of the areas of the faces in this
  /// region.
  bool add_up() const { return wrong_first.empty() && wrong_second.empty(); }
};

/// Returns the exact areas of the faces and of the regions. Requires that `overlay` is
/// overlay_maps(first, second). Throws ResourceLimit if a limit of the Context is exceeded, and
/// Cancelled if a stop is requested. Cost: O(n) operations on rational numbers, for n edges of the
/// overlay and of both maps together.
OverlayAreas measure(const MapOverlay& overlay, const MapReport& first, const MapReport& second,
                     Context& context = unlimited_context());

/// Returns the sum of areas. For example, the sum of OverlayAreas::first is the total area of the
/// bounded regions of the first map.
Rational sum_of(const std::vector<Rational>& areas);

}  // namespace plumb
#pragma GCC visibility pop
