// Vertices around which the facets of a mesh cannot cross, by a few comparisons.
//
// Seen along a coordinate axis, the triangles around a vertex may lie side by side and go around it once: a fan. The view
// of a fan is one to one, so its triangles have nothing in common but the vertex and the edges between them. In most
// meshes most vertices have one, which spares the exact test of some nine pairs of triangles for each.
//
// Main flow of find_fans(), for the three axes at once:
//  1. sides     of each triangle that is seen along the axis, from its plane's row
//  2. edges     the two triangles at an edge lie on different sides of it, or both its ends have no fan
//  3. turns     given 2, all corners around a vertex turn one way, each less than half a turn. A corner passes the
//               direction 0 exactly if it begins in the lower half-plane and ends in the upper one; they
//               go around once exactly if one of them does.
//
// Exact: coordinates of input points are compared, nothing is computed. O(n), about 10 ns a triangle.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/space/space_complex.h"

namespace plumb {

/// Per vertex: 1 if the facets around it surely are a fan of triangles. Then any two of them meet in common edges and
/// vertices alone, and edges leave it in different directions. Requires edges, planes of facets and cycles; facets may
/// have holes and edges no facet, but none of their vertices has a fan.
std::vector<std::uint8_t> find_fans(const SpaceComplex& complex);

}  // namespace plumb
