// Have two triangles of different facets of a mesh a common point that is in no common vertex or
// edge of the facets? What mesh_crossings.h asks of each pair.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/internal/box_tree.h"
#include "plumb/predicates/space/point3_table.h"
#include "plumb/space/space_complex.h"

namespace plumb {

struct TriangleCorner {
  VertexId vertex;
  SpacePoint point;
};

struct FacetTriangle {
  std::array<TriangleCorner, 3> corner;
  PlaneId plane;
  FacetId facet;
  std::uint8_t fans;       ///< bit i: corner i has a fan (mesh_topology.h)
  std::uint8_t diagonals;  ///< bit i: the side from corner i to the next is no edge of the facet

  bool is_diagonal(std::size_t i) const { return (diagonals >> i & 1U) != 0; }
};

class TriangleCrossing {
 public:
  /// Of points of this table, which must outlive it.
  explicit TriangleCrossing(const Point3Table& points) : points_(points) {}

  /// Around a common vertex with a fan they have not; most pairs need no more.
  bool operator()(const FacetTriangle& s, const FacetTriangle& t) const {
    const unsigned shared = shared_corners(s, t);
    return (shared & s.fans) == 0 && meet_elsewhere(s, t, shared != 0);
  }

 private:
  /// Bit i: corner i of s is one of t's.
  static unsigned shared_corners(const FacetTriangle& s, const FacetTriangle& t) {
    unsigned shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = s.corner[i].vertex;
      const unsigned is_shared = static_cast<unsigned>(v == t.corner[0].vertex) |
                                 static_cast<unsigned>(v == t.corner[1].vertex) |
                                 static_cast<unsigned>(v == t.corner[2].vertex);
      shared |= is_shared << i;
    }
    return shared;
  }
  bool meet_elsewhere(const FacetTriangle& s, const FacetTriangle& t, bool share_corners) const;

  const Point3Table& points_;
};

// Triangles of a mesh that need not be looked at in pairs: very many of one facet, and very many
// around one vertex.
//
// All triangles around a vertex meet there, so trees of boxes find every pair of them, k^2 / 2 of
// k. But two of them have another point in common only if their directions from the vertex do:
// boxes of directions tell them apart.
//
// Notation: a group is a facet of many triangles, or a hub, a vertex of many. A triangle is in its
// facet's group if there is one, else in that of its busiest corner, if that is a hub.

struct TriangleGroups {
  static constexpr std::uint32_t kMany = 64;  ///< as many are no group yet

  std::vector<std::uint32_t> of;  ///< per triangle: its group, or kNone
  std::vector<VertexId> hub;      ///< per group: the vertex; of a facet invalid
  std::uint64_t pairs = 0;        ///< of triangles of one group
};

/// Requires the triangles of a facet in a row, and vertices below `vertex_count`. O(n).
TriangleGroups group_triangles(std::span<const FacetTriangle> triangles, std::size_t vertex_count);

/// Around the unit vectors from `centre` towards all points of the side from a to b. Around all of
/// them, where nothing is known.
Box3 box_of_directions(const PointBox& centre, const PointBox& a, const PointBox& b);

}  // namespace plumb
