// Points and maps of the plane from and to plain arrays: coordinates x y x y ..., and indices of points.
//
//   in     points_of(xy): for Nef2::polygons(points, corners, chain_begin, ...), arrange(points, ...)
//          map_of_cycles(xy, cycle_begin, corners): for check_map()
//   out    coordinates_of(points): with the indices of a Map, or of the shapes of a set (plumb/io/plane_shapes.h)
//
// Arrays of indices are spans everywhere; Dcel::from_cycles() takes nothing else. What a structure keeps is copied into it
// once, with nothing in between, so that the arrays may go when it is there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/map.h"
#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Point i is (xy[2 i], xy[2 i + 1]). Throws Error{BadArgument} for an odd number of coordinates or 2^32 - 1 points and
/// more, Error{NotFinite} with the number of the point. O(n).
PointTable2 points_of(std::span<const double> xy);

/// Cycle c has the corners from cycle_begin[c] up to cycle_begin[c + 1]: one entry more than cycles, the first 0, the last
/// the number of corners. Corners are looked at by check_map(). Throws Error{BadArgument} for other arrays, and as
/// points_of() does. O(n).
Map map_of_cycles(std::span<const double> xy, std::span<const std::uint32_t> cycle_begin,
                  std::span<const std::uint32_t> corners);

/// x y of all points, rounded to the nearest doubles where they are no doubles. O(n).
std::vector<double> coordinates_of(const PointTable2& points);

}  // namespace plumb
#pragma GCC visibility pop
