// Writes shapes as well-known text.
#pragma once

#include <ostream>

#include "plumb/io/plane_shapes.h"

namespace plumb {

/// One geometry on one line: POINT .. MULTIPOLYGON, a GEOMETRYCOLLECTION of those when dimensions
/// mix, GEOMETRYCOLLECTION EMPTY when there is nothing. Numbers are the nearest doubles, as
/// format_double(). Throws what `out` throws,
/// and Error{Cancelled} or Error{ResourceLimit} as the context says.
void write_wkt(std::ostream& out, const PlaneShapes& shapes, Context& context);

}  // namespace plumb
