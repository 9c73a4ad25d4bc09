// Reads and writes well-known text (docs/formats.md, "WKT"): POINT, LINESTRING, POLYGON,
// MULTIPOINT, MULTILINESTRING, MULTIPOLYGON, GEOMETRYCOLLECTION, in any case, with EMPTY anywhere;
// any number of geometries one after the other. With a tag Z, M or ZM each position has more
// numbers, which are read and dropped.
//
// Errors are thrown with the place (file, line, column): NotText, Syntax, NumberOutOfRange,
// BadShape (rings that are not closed), CountMismatch (no geometry at all), ResourceLimit;
// Cancelled. Cost: O(bytes).
#pragma once

#include <ostream>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/read_options.h"

namespace plumb {

/// Returns the shapes of a text. Their memory stays charged to `context`.
PlaneShapes read_wkt(std::string_view text, const ReadOptions& options, Context& context);

// Writes shapes as well-known text.

/// Writes one geometry on one line: POINT .. MULTIPOLYGON, a GEOMETRYCOLLECTION of those if
/// dimensions mix, GEOMETRYCOLLECTION EMPTY if there is nothing. Numbers are the nearest doubles,
/// as in format_double(). Throws what `out` throws, and Error{Cancelled} or Error{ResourceLimit} as
/// the context says.
void write_wkt(std::ostream& out, const PlaneShapes& shapes, Context& context);

}  // namespace plumb
