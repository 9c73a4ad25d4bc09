// Triangles of a mesh that need not be looked at in pairs: very many of one facet, and very many around one vertex.
//
// All triangles around a vertex meet there, so trees of boxes find every pair of them, k^2 / 2 of k. But two of them
// have another point in common only if their directions from the vertex do: boxes of directions tell them apart.
//
// Notation: a group is a facet of many triangles, or a hub, a vertex of many. A triangle is in its facet's group if there is one,
// else in that of its busiest corner,
// if that is a hub.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/box_tree.h"
#include "plumb/predicates/point3_table.h"
#include "plumb/space/triangle_crossing.h"

namespace plumb {

struct TriangleGroups {
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};
  static constexpr std::uint32_t kMany = 64;  ///< as many are no group yet

  std::vector<std::uint32_t> of;  ///< per triangle: its group, or kNone
  std::vector<VertexId> hub;      ///< per group: the vertex; of a facet invalid
  std::uint64_t pairs = 0;        ///< of triangles of one group
};

/// Requires the triangles of a facet in a row, and vertices below `vertex_count`. O(n).
TriangleGroups group_triangles(std::span<const FacetTriangle> triangles, std::size_t vertex_count);

/// Around the unit vectors from `centre` towards all points of the side from a to b. Around all of them, where nothing is
/// known.
Box3 box_of_directions(const PointBox& centre, const PointBox& a, const PointBox& b);

}  // namespace plumb
