// Reads and writes well-known text (docs/formats.md, "WKT"): POINT, LINESTRING, POLYGON,
// MULTIPOINT, MULTILINESTRING, MULTIPOLYGON, GEOMETRYCOLLECTION, and LINEARRING, TRIANGLE, TIN,
// POLYHEDRALSURFACE, MULTICURVE, MULTISURFACE and CURVEPOLYGON of straight edges, in any case, with
// EMPTY anywhere; any number of geometries one after the other, with semicolons between them or
// without.
//
// Dialects: SRID=NUMBER; or <URI> before a geometry, Z, M and ZM as words of their own or at the
// end of another, and one or two numbers after x and y without such a word are read and dropped; a
// note names them. The numbers that are dropped may be nan, inf or NULL.
//
// Errors are thrown with the place (file, line, column): NotText, Syntax (curves, too),
// NumberOutOfRange, BadShape (rings of too few positions, surfaces with different heights),
// CountMismatch (no geometry at all), ResourceLimit; Cancelled. Cost: O(bytes).
#pragma once

#include <ostream>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/read_options.h"

namespace plumb {

/// Returns the shapes of a text, with notes. The memory of the shapes stays charged to `context`.
PlaneFile read_wkt(std::string_view text, const ReadOptions& options, Context& context);

/// Whether a text begins with the name of a geometry (curves, too) or with a coordinate reference
/// system before one.
bool begins_like_wkt(std::string_view text);

// Writes shapes as well-known text.

/// Writes one geometry on one line: POINT .. MULTIPOLYGON, a GEOMETRYCOLLECTION of those if
/// dimensions mix, GEOMETRYCOLLECTION EMPTY if there is nothing. Numbers are the nearest doubles,
/// as in format_double(). Throws the exceptions of `out` and the errors of the Context.
void write_wkt(std::ostream& out, const PlaneShapes& shapes, Context& context);

}  // namespace plumb
