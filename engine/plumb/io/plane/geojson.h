// Reads and writes GeoJSON (RFC 7946; docs/formats.md, "GeoJSON"): geometries, Features and
// FeatureCollections, one of them or a sequence (one a line, or with the record separators of RFC
// 8142). Members may come in any order. Properties, ids, bounding boxes and other members are
// skipped, whatever their values are; numbers of positions after x and y are dropped. A note names
// both.
//
// Main flow of read_geojson():
//  1. split    JsonScanner finds one token after the other (no recursion, no tree)
//  2. follow   GeoJsonReader follows them through objects, lists and coordinates; numbers are read
//              by the rules of record_reader.h, with their place
//  3. finish   an object is judged when it ends, because only then is its type known
//
// Errors are thrown with the place (file, line, column): NotText, Syntax, NumberOutOfRange,
// BadShape, ResourceLimit; Cancelled. Cost: O(bytes); memory is the shapes.
#pragma once

#include <ostream>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/read_options.h"

namespace plumb {

/// Returns the shapes of a GeoJSON text, with notes. The memory of the shapes stays charged to
/// `context`.
PlaneFile read_geojson(std::string_view text, const ReadOptions& options, Context& context);

// Writes shapes as GeoJSON (RFC 7946).

/// Writes one geometry object on one line: a Point .. MultiPolygon, or a GeometryCollection of
/// those if dimensions mix or there is nothing. Numbers are the nearest doubles, as in
/// format_double(). Throws the exceptions of `out` and the errors of the Context.
void write_geojson(std::ostream& out, const PlaneShapes& shapes, Context& context);

}  // namespace plumb
