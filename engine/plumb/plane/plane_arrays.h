// Conversions between plain arrays and points or maps of the plane. The arrays hold coordinates
// x y x y ... and indices of points.
//
//   in     points_of(xy) makes points for Nef2::polygons(points, corners, chain_begin, ...) and
//          arrange(points, ...);
//          map_of_cycles(xy, cycle_begin, corners) makes a map for check_map()
//   out    coordinates_of(points) gives the array that the indices of a Map, or of the shapes of a
//          set (plumb/io/plane_shapes.h), refer to
//
// Every function that takes indices takes them as spans, Dcel::from_cycles() included. The results
// own copies of the data, made without intermediate copies, so the arrays may be released
// afterwards.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/map.h"
#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the points (xy[2 i], xy[2 i + 1]), in order. Throws Error{BadArgument} if the number of
/// coordinates is odd or there are more than 2^32 - 2 points; Error{NotFinite}, with the number of
/// the point, if a coordinate is not finite. O(n).
PointTable2 points_of(std::span<const double> xy);

/// Returns the map of these points and cycles. Cycle c consists of corners[cycle_begin[c]], ...,
/// corners[cycle_begin[c + 1] - 1]; cycle_begin has one entry more than there are cycles. Throws
/// Error{BadArgument} unless cycle_begin ascends from 0 to the number of corners, and as
/// points_of() does. The corners themselves are checked by check_map() only. O(n).
Map map_of_cycles(std::span<const double> xy, std::span<const std::uint32_t> cycle_begin,
                  std::span<const std::uint32_t> corners);

/// Returns the coordinates x y x y ... of all points. Coordinates that are not doubles are rounded
/// to the nearest ones. O(n).
std::vector<double> coordinates_of(const PointTable2& points);

}  // namespace plumb
#pragma GCC visibility pop
