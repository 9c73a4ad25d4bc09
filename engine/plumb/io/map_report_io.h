// Writes the report of check_map() in three formats:
//   - text: the DCEL listing of a valid map, or one line for each defect
//   - JSON: one object (docs/formats.md, docs/schema/map-check.schema.json)
//   - GeoJSON: the defects
// Ids are 1-based in all three formats. Every writer passes on exceptions of `out`.
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

/// Writes the report as text. For a valid map, the text is the DCEL listing (docs/formats.md, "DCEL
/// listing"). Half-edge k of this listing belongs to the k-th corner of the listed cycles. For any
/// other map, the text consists of the headline and one line for each described defect. Cost: O(n).
void write_map_report_text(std::ostream& out, const MapReport& report);

/// Writes the report as one line of JSON, followed by a line break. Exact coordinates are strings
/// "p/q". The text is not collected in memory, so the memory used does not grow with the report.
/// Cost: O(n).
void write_map_report_json(std::ostream& out, const MapReport& report);

/// Writes the defects as a GeoJSON FeatureCollection. It has one feature for each described defect,
/// with the same properties as in the JSON report. The geometry of a feature is the point of the
/// defect. A defect without a point has its edges as lines. A defect with neither has the geometry
/// null. Coordinates are rounded to the nearest doubles, in the coordinate system of the map.
void write_map_report_geojson(std::ostream& out, const MapReport& report);

}  // namespace plumb
#pragma GCC visibility pop
