// Tests whether two triangles of different facets of a mesh have a common point that is in no
// common vertex or edge of the facets. mesh_crossings.h asks this question for each pair. The
// second part groups triangles that need not be looked at in pairs.
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

/// A corner of a triangle.
struct TriangleCorner {
  VertexId vertex;   ///< The vertex of the mesh.
  SpacePoint point;  ///< Its place.
};

/// A triangle of a facet, counter-clockwise seen from the positive side of its plane.
struct FacetTriangle {
  std::array<TriangleCorner, 3> corner;  ///< Its corners.
  PlaneId plane;                         ///< The plane of the facet.
  FacetId facet;                         ///< The facet to which it belongs.
  std::uint8_t fans;                     ///< Bit i is 1 if corner i has a fan (mesh_topology.h).
  std::uint8_t diagonals;  ///< Bit i is 1 if the side from corner i to the next is no edge.

  /// Whether the side from corner i to the next one is no edge of the facet.
  bool is_diagonal(std::size_t i) const { return (diagonals >> i & 1U) != 0; }
};

/// The exact test of pairs of triangles.
class TriangleCrossing {
 public:
  /// Tests triangles of points of this table. Keeps a reference to it.
  explicit TriangleCrossing(const Point3Table& points) : points_(points) {}

  /// Whether the triangles have a common point outside common vertices and edges of their facets.
  /// Around a common vertex with a fan, they have no other common point. For most pairs, this fact
  /// is enough.
  bool operator()(const FacetTriangle& s, const FacetTriangle& t) const {
    const unsigned shared = shared_corners(s, t);
    return (shared & s.fans) == 0 && meet_elsewhere(s, t, shared != 0);
  }

 private:
  /// Returns a number whose bit i is 1 if corner i of s is a corner of t.
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

// Groups of triangles that need not be looked at in pairs: very many of one facet, and very many
// around one vertex.
//
// All triangles around a vertex meet there, so trees of boxes find every pair of them: k^2 / 2 for
// k triangles. But two of them have another point in common only if their directions from the
// vertex do, and boxes of directions separate most of them.
//
// Notation: a group is a facet of many triangles, or a hub: a vertex of many. A triangle is in the
// group of its facet, if the facet has a group. Otherwise, if the corner with the most triangles is
// a hub, the triangle is in the group of this corner.

/// The groups of the triangles of a mesh.
struct TriangleGroups {
  static constexpr std::uint32_t kMany = 64;  ///< More triangles than this make a group.

  std::vector<std::uint32_t> of;  ///< The group of each triangle, or kNone.
  std::vector<VertexId> hub;      ///< The vertex of each group; invalid for a facet.
  std::uint64_t pairs = 0;        ///< The number of pairs of triangles of one group.
};

/// Returns the groups of triangles. Requires that the triangles of a facet follow each other, and
/// that vertices are below `vertex_count`. O(n).
TriangleGroups group_triangles(std::span<const FacetTriangle> triangles, std::size_t vertex_count);

/// Returns a box around the unit vectors from `centre` towards all points of the side from a to b;
/// a box around all unit vectors if the boxes of the points say too little.
Box3 box_of_directions(const PointBox& centre, const PointBox& a, const PointBox& b);

}  // namespace plumb
