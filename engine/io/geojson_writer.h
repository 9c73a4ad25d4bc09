// Writes shapes as GeoJSON (RFC 7946).
#pragma once

#include <ostream>

#include "plumb/io/plane_shapes.h"

namespace plumb {

/// One geometry object on one line: a Point .. MultiPolygon, or a GeometryCollection of those when
/// dimensions mix or there is nothing. Numbers are the nearest doubles, as format_double(). Throws
/// what `out` throws, and Error{Cancelled} or Error{ResourceLimit} as the context says.
void write_geojson(std::ostream& out, const PlaneShapes& shapes, Context& context);

}  // namespace plumb
