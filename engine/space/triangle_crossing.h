// Have two triangles of different facets of a mesh a common point that is in no common vertex or edge of the facets? What
// mesh_crossings.h asks of each pair.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

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
  std::uint8_t fans;       ///< bit i: corner i has a fan (mesh_fans.h)
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

}  // namespace plumb
