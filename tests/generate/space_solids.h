// Closed meshes, polygons and chains of space by a few points: what tests build sets from.
#pragma once

#include <array>
#include <vector>

#include "oracle/space_set.h"

namespace plumb::testing {

/// Between two opposite corners; requires that they differ in every coordinate.
MeshLeaf box(const ExactPoint3& p, const ExactPoint3& q);
/// Corners in any order; requires that they do not lie in one plane.
MeshLeaf tetrahedron(const ExactPoint3& a, const ExactPoint3& b, const ExactPoint3& c,
                     const ExactPoint3& d);
/// The convex polygon moved from `low` to `high` along an axis (0, 1, 2), its own coordinate there
/// unread. Requires an area seen along that axis and low < high.
MeshLeaf prism(const Chain3& polygon, std::size_t axis, const BigRational& low,
               const BigRational& high);
/// The other way out.
MeshLeaf inside_out(MeshLeaf mesh);
/// Both in one mesh, the rule of the first.
MeshLeaf together(MeshLeaf first, const MeshLeaf& second);
MeshLeaf moved(MeshLeaf mesh, const ExactPoint3& by);

/// Across an axis at `height`, between two corners whose coordinate there is not read.
PolygonLeaf rectangle(const ExactPoint3& p, const ExactPoint3& q, std::size_t axis,
                      const BigRational& height);

/// a x + b y + c z + d <= 0 (or < 0).
SpaceSetPointer half_space(int a, int b, int c, int d, bool closed = true);

BigRational& coordinate(ExactPoint3& p, std::size_t axis);
const BigRational& coordinate(const ExactPoint3& p, std::size_t axis);

/// Two solids in some special position to each other.
struct SolidPair {
  std::string name;
  SpaceSetPointer a;
  SpaceSetPointer b;
};

/// The box [2, 4]^3 and boxes whose extents lie to [2, 4] in each of the 13 ways two intervals can
/// lie, along every axis: 455 pairs (up to the order of axes).
std::vector<SolidPair> overlapping_boxes();
/// Touching at a facet, edge, vertex; slid along a face; voids; needles; checkerboards.
std::vector<SolidPair> special_pairs();

}  // namespace plumb::testing
