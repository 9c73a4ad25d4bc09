// Valid maps, from three faces to a million. Every one lists its outer cycles; the same arguments
// give the same map. `size` is the number asked for; face_count() tells what came out.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "plumb/testing/test_map.h"

namespace plumb::testing {

/// Counter-clockwise cycles of a map from these families, by count (families list few others).
std::size_t face_count(const TestMap& map);

/// side x side unit squares, spaced 2 apart (so that midpoints are integers).
TestMap grid(std::uint32_t side);
/// 2 side^2 triangles over a grid whose points are moved by up to a fifth of the spacing.
TestMap jittered_triangles(std::uint32_t side, std::uint64_t seed);
/// 2 teeth - 1 thin triangles with edges `height` long, all overlapping in their y range.
TestMap comb(std::uint32_t teeth, std::int64_t height = 1 << 20);
/// Two interlocking comb-shaped faces along one zigzag of `teeth` long edges.
TestMap zigzag(std::uint32_t teeth, std::int64_t height = 1 << 20);
/// `size` triangles around one vertex; their far ends on a parabola. size <= 2^25.
TestMap fan(std::uint32_t size);
/// `depth` square rings, one inside the other; each ring's hole is the next one's outer cycle.
TestMap nest(std::uint32_t depth);
/// side x side convex hexagons, their corners moved a little: vertices of degree 3 as in a
/// Voronoi diagram.
TestMap hexagons(std::uint32_t side, std::uint64_t seed);
/// One face with `corners` corners on a jagged star-shaped outline around the origin.
TestMap star(std::uint32_t corners, std::uint64_t seed);
/// `lines` random lines clipped to a box: about lines^2 / 3 faces, rational vertices.
TestMap line_arrangement(std::uint32_t lines, std::uint64_t seed);
/// Outlines of random rectangles, triangles and segments with coordinates in [0, range]:
/// islands in islands, holes, pinches, collinear edges.
TestMap random_subdivision(std::uint32_t shapes, std::int64_t range, std::uint64_t seed);

/// The families as a table: name, and a map of about `faces` faces.
struct MapFamily {
  std::string_view name;
  TestMap (*make)(std::uint32_t faces);
};
const std::vector<MapFamily>& map_families();
/// Requires a name of the table.
const MapFamily& map_family(std::string_view name);

}  // namespace plumb::testing
