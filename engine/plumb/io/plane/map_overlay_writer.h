// The cells of two overlaid maps as GeoJSON and as a JSON summary (docs/formats.md).
#pragma once

#include <ostream>

#include "plumb/plane/map_overlay.h"
#include "plumb/plane/plane_rounding.h"

namespace plumb {

/// The data that the writers need: two maps, their overlay and its areas.
struct OverlayReport {
  const MapReport& first;
  const MapReport& second;
  const MapOverlay& overlay;
  const OverlayAreas& areas;
  /// The overlay rounded to doubles. If this is null, GeoJSON has the nearest doubles of the
  /// vertices, and cells may be invalid.
  const RoundedSubdivision* rounded = nullptr;
};

/// Writes one feature for every bounded face that rounding leaves something of, in the order of the
/// complex: a Polygon of doubles in the coordinates of the maps, or a MultiPolygon if rounding has
/// pinched the face off. Neighbours share their borders. The properties are
///   "a", "b"   the region of each map that it is part of: the listed cycle around it (1-based, as
///              `map check` numbers faces), null outside of all of them
///   "area"     {"exact": "p/q", "double": x}, the area of the exact face
void write_overlay_geojson(std::ostream& out, const OverlayReport& report);

/// Writes one JSON object: counts of vertices, edges and faces; cells by where they lie; the exact
/// areas of both maps and of their parts; whether all areas add up.
void write_overlay_json(std::ostream& out, const OverlayReport& report);

/// Writes the same as text for people.
void write_overlay_text(std::ostream& out, const OverlayReport& report);

}  // namespace plumb
