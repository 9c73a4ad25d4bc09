// Scenes of the plane by size, for benchmarks and large tests. The same numbers everywhere: no
// floating-point function whose last digit could differ.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/predicates/point.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {

using PlaneSegment = std::pair<Point2, Point2>;
using PlanePolygon = std::vector<Point2>;

/// Segments of random place and direction in the unit square, as long as it takes for 1.3 crossings
/// a segment, whatever n.
std::vector<PlaneSegment> short_segments(std::size_t n, std::uint64_t seed = 1);
/// Segments between random points of the unit square: 0.23 n^2 / 2 crossings.
std::vector<PlaneSegment> long_segments(std::size_t n, std::uint64_t seed = 1);

/// A simple polygon of n vertices round the origin at random distances between 1/2 and 1. Two of
/// different seeds cross about n times.
PlanePolygon star_polygon(std::size_t n, std::uint64_t seed);

/// A simple polygon of at most `corners` corners on the lattice of 0, ..., size in both
/// coordinates; many corners are flat or share a line with others.
PlanePolygon lattice_polygon(Dice& dice, std::size_t corners, std::uint32_t size);

/// Convex 8-gons of integer coordinates below 2^30, counter-clockwise, so many that they cover
/// about one and a half times the area of their square whatever n.
std::vector<PlanePolygon> octagons(std::size_t n, std::uint64_t seed = 1);

}  // namespace plumb::testing
