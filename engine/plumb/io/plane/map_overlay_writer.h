// The cells of two overlaid maps as GeoJSON and as a JSON summary (docs/formats.md).
#pragma once

#include <ostream>

#include "plumb/plane/map_overlay.h"

namespace plumb {

/// Two maps, their overlay and its areas, as the writers need them together.
struct OverlayReport {
  const MapReport& first;
  const MapReport& second;
  const MapOverlay& overlay;
  const OverlayAreas& areas;
};

/// One feature for every bounded face, in the order of the complex: a Polygon of nearest doubles in
/// the coordinates of the maps, with the properties
///   "a", "b"   the region of each map it is part of: the listed cycle around it (1-based, as
///              `map check` numbers faces), null outside of all of them
///   "area"     {"exact": "p/q", "double": x}
void write_overlay_geojson(std::ostream& out, const OverlayReport& report);

/// One JSON object: counts of vertices, edges, faces; cells by where they lie; the areas of both
/// maps and of their parts, exactly; whether all areas add up.
void write_overlay_json(std::ostream& out, const OverlayReport& report);

/// The same for people.
void write_overlay_text(std::ostream& out, const OverlayReport& report);

}  // namespace plumb
