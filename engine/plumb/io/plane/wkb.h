// Reads and writes well-known binary (docs/formats.md, "WKB"): the geometries of WKT as bytes, with
// the codes of ISO and of EWKB (PostGIS) for Z, M and SRID, in either byte order. A file has any
// number of geometries one after the other, as bytes, or as text of two hexadecimal digits per byte
// with blanks or line breaks between geometries.
//
// Numbers after x and y and SRIDs are dropped; a note names them. Counts are compared with the
// bytes that follow before anything is read for them.
//
// Errors name the byte ("FILE: at byte N", or "FILE:LINE:COLUMN: at byte N" of the text that is
// there): NotText, Syntax (curves, too), NumberOutOfRange (coordinates that are not finite),
// BadShape, CountMismatch, ResourceLimit; Cancelled. Cost: O(bytes).
#pragma once

#include <iosfwd>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/read_options.h"

namespace plumb {

/// Returns the shapes of a file, with notes. The memory of the shapes stays charged to `context`.
/// Doubles are read unchanged. The option for decimals has no effect on them.
PlaneFile read_wkb(std::string_view bytes, const ReadOptions& options, Context& context);

/// Whether bytes begin like WKB: with a byte order and the code of a geometry, as bytes or as
/// hexadecimal digits.
bool begins_like_wkb(std::string_view bytes);

/// Writes one geometry, with little-endian numbers: Point .. MultiPolygon, a GeometryCollection of
/// those if dimensions mix, an empty GeometryCollection if there is nothing. Throws the exceptions
/// of `out` and the errors of the Context.
void write_wkb(std::ostream& out, const PlaneShapes& shapes, Context& context);

}  // namespace plumb
