// Converts plain arrays to points and maps of the plane, and points to arrays. The arrays contain
// coordinates x y x y ... and indices of points.
//
//   input   points_of(xy) makes a table of points. Nef2::polygons(points, corners, chain_begin,
//           ...) and arrange(points, ...) take such a table. map_of_cycles(xy, cycle_begin,
//           corners) makes a map for check_map().
//   output  coordinates_of(points) makes an array of coordinates. The indices in a Map, and in the
//           shapes of a set (PlaneShapes in plumb/io/plane_io.h), refer to the points of this
//           array. Point i has the entries 2 i and 2 i + 1.
//
// All functions of the library that take indices, including Dcel::from_cycles(), take them as
// spans. Each function copies the data once into its result. The result does not refer to the
// arrays, so the caller may release the arrays afterwards.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/map.h"
#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the points (xy[2 i], xy[2 i + 1]), in order. Throws Error{BadArgument} if the number of
/// coordinates is odd or there are more than 2^32 - 2 points. Throws Error{NotFinite}, with the
/// index of the point, if a coordinate is not finite. Cost: O(n) for n points.
PointTable2 points_of(std::span<const double> xy);

/// Returns the map of these points and cycles. Cycle c consists of corners[cycle_begin[c]], ...,
/// corners[cycle_begin[c + 1] - 1]. So cycle_begin has one entry more than there are cycles. Throws
/// Error{BadArgument} if cycle_begin does not ascend from 0 to the number of corners. Also throws
/// the errors of points_of(). This function does not check the corners. check_map() checks them.
/// Cost: O(n) for n points and corners.
Map map_of_cycles(std::span<const double> xy, std::span<const std::uint32_t> cycle_begin,
                  std::span<const std::uint32_t> corners);

/// Returns the coordinates x y x y ... of all points. A coordinate that is not a double is rounded
/// to the nearest double. The function repairs nothing, so segments between rounded points may
/// cross. To avoid this, first round the set with round_to_doubles() (plane_rounding.h). The
/// coordinates of the rounded set are doubles. Cost: O(n) for n points.
std::vector<double> coordinates_of(const PointTable2& points);

}  // namespace plumb
#pragma GCC visibility pop
