// Writes the report of check_map(): as text (the DCEL listing, or one line for each defect), as one
// JSON object (docs/formats.md, docs/schema/map-check.schema.json), and as GeoJSON.
//
// Ids are 1-based in all three. Every writer throws what `out` throws.
#pragma once

#include <iosfwd>
#include <string_view>

#include "plumb/plane/map_check.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the verdict in words: "valid", "not a planar subdivision", "open" or
/// "superposed".
std::string_view headline(MapVerdict verdict);

/// Returns the name of a kind of defect: "duplicate", "open", "crossing", "twin", "mixed" or
/// "nested".
std::string_view name_of(DefectKind kind);

/// Returns the name of a kind of warning: "pinch", "isolated-vertex", "inferred-outer" or
/// "merged-vertex".
std::string_view name_of(WarningKind kind);

/// Writes the report as text. For a valid map this is the DCEL listing (docs/formats.md, "DCEL
/// listing"), in which half-edge k is the k-th corner of the listed cycles. Otherwise it is the
/// headline and one line for each described defect. Cost: O(n).
void write_map_report_text(std::ostream& out, const MapReport& report);

/// Writes the report as one line of JSON and a line break. Exact coordinates are strings "p/q". The
/// text is written as it is made, so that memory does not grow with the report. Cost: O(n).
void write_map_report_json(std::ostream& out, const MapReport& report);

/// Writes the defects as a GeoJSON FeatureCollection: one feature for each described defect, with
/// the properties of the JSON report. Its geometry is the place as a Point, or else the edges as
/// lines, or else null. Coordinates are the nearest doubles in the coordinate system of the map.
void write_map_report_geojson(std::ostream& out, const MapReport& report);

}  // namespace plumb
#pragma GCC visibility pop
