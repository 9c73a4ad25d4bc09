// Writes the report of check_map() in one of three formats:
//   - text: the DCEL listing of a valid map, or one line for each defect of any other map
//   - JSON: one object with the whole report (docs/formats.md, docs/schema/map-check.schema.json)
//   - GeoJSON: only the defects
// Ids are 1-based in all three formats. Every writer passes on exceptions of `out`.
#pragma once

#include <iosfwd>
#include <string_view>

#include "plumb/plane/map_check.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns a verdict in words: "valid", "not a planar subdivision", "open" or "superposed".
std::string_view headline(MapVerdict verdict);

/// Returns the name of a kind of defect: "duplicate", "open", "crossing", "twin", "mixed" or
/// "nested".
std::string_view name_of(DefectKind kind);

/// Returns the name of a kind of warning: "pinch", "isolated-vertex", "inferred-outer" or
/// "merged-vertex".
std::string_view name_of(WarningKind kind);

/// Writes the report as text. For a valid map, the text is the DCEL listing (docs/formats.md, "DCEL
/// listing"). Half-edge k of this listing belongs to the k-th corner of the listed cycles. For any
/// other map, the text consists of the headline (see headline()) and one line for each described
/// defect. Cost: O(n) for n corners of the map.
void write_map_report_text(std::ostream& out, const MapReport& report);

/// Writes the report as one line of JSON, followed by a line break. Exact coordinates are written
/// as strings "p/q". The JSON text is written piece by piece, so the function needs the same memory
/// for every size of the report. Cost: O(n) for n corners of the map.
void write_map_report_json(std::ostream& out, const MapReport& report);

/// Writes the defects as a GeoJSON FeatureCollection. The collection has one feature for each
/// described defect. The properties of a feature are the members that the JSON report has for this
/// defect. The geometry of a feature depends on the defect:
///   - the point of the defect, if the defect has a point
///   - otherwise the edges of the defect as lines, if the defect has edges
///   - otherwise null
/// Coordinates are rounded to the nearest doubles, in the coordinate system of the map.
void write_map_report_geojson(std::ostream& out, const MapReport& report);

}  // namespace plumb
#pragma GCC visibility pop
