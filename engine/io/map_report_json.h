// The report of check_map() as one JSON object (docs/formats.md, docs/schema/map-check.schema.json).
#pragma once

#include <ostream>

#include "plumb/plane/map_check.h"

#pragma GCC visibility push(default)
namespace plumb {

/// One line of JSON and a line break. Written as it goes: memory does not grow with the report.
/// Ids are 1-based, exact coordinates are strings "p/q". Throws what `out` throws.
void write_map_report_json(std::ostream& out, const MapReport& report);

/// The defects as a GeoJSON FeatureCollection, one feature per described defect, properties as in
/// the JSON report. Geometry: the place as a Point, else the edges as lines, else null.
/// Coordinates are the nearest doubles, in the coordinates of the map, whatever those are.
void write_map_report_geojson(std::ostream& out, const MapReport& report);

}  // namespace plumb
#pragma GCC visibility pop
