// Reads and writes GeoJSON (RFC 7946; docs/formats.md, "GeoJSON"): a geometry, a Feature or a
// FeatureCollection. Properties, ids, bounding boxes and other members are skipped; coordinates
// beyond x and y are read and dropped; members may come in any order.
//
// Main flow of read_geojson():
//  1. parse    nlohmann-json splits the text into events (no recursion, no tree)
//  2. follow   GeoJsonHandler follows them through objects, lists and coordinates; numbers are read
//              again from the text by the rules of record_reader.h, with their place
//  3. finish   an object is judged when it ends, because only then is its type known
//
// Errors are thrown with the place (file, line, column): NotText, Syntax, NumberOutOfRange,
// BadShape, ResourceLimit; Cancelled. Cost: O(bytes); memory is the shapes and the longest string.
#pragma once

#include <ostream>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/read_options.h"

namespace plumb {

/// Returns the shapes of a GeoJSON text. Their memory stays charged to `context`.
PlaneShapes read_geojson(std::string_view text, const ReadOptions& options, Context& context);

// Writes shapes as GeoJSON (RFC 7946).

/// Writes one geometry object on one line: a Point .. MultiPolygon, or a GeometryCollection of
/// those if dimensions mix or there is nothing. Numbers are the nearest doubles, as in
/// format_double(). Throws what `out` throws, and Error{Cancelled} or Error{ResourceLimit} as the
/// context says.
void write_geojson(std::ostream& out, const PlaneShapes& shapes, Context& context);

}  // namespace plumb
