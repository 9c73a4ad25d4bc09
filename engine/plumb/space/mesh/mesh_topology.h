// Where a mesh is open.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/predicates/sign.h"
#include "plumb/space/complex/space_tables.h"
#include "plumb/space/mesh/link_facets.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Where directed edges and their reverses do not balance: closed chains of vertices, in the
/// direction that would balance them. It is places that count: an edge with vertices of the mesh on
/// it balances the edges between them. `points`: per vertex. O(n), besides O((m + c) log m) for m
/// edges that no edge of the same ends balances and c pairs of their boxes and ends that meet.
std::vector<std::vector<std::uint32_t>> trace_borders(const MeshFacets& facets,
                                                      const MeshLinks& links,
                                                      std::span<const SpacePoint> points,
                                                      const Point3Table& table);

// Connected closed parts of a mesh and the signs of their volumes.

struct MeshComponents {
  std::vector<std::uint32_t> of_facet;  ///< numbered by least facet
  std::vector<Sign> volume;             ///< per component
};

/// Facets that share an edge with no others are joined; where more meet, those whose component
/// would not be closed there. What is open even so (closed by vertices on edges, faces without
/// area) is one component. Requires facets with one cycle. Volumes of components that are not
/// closed (surfaces) are meaningless. O(n alpha(n)).
MeshComponents find_components(const SpaceComplex& complex, std::span<const std::int32_t> jump);

// Vertices around which the facets of a complex cannot cross, by a few comparisons.
//
// Seen along a coordinate axis, the corners around a vertex may lie side by side and go around it
// once: a fan. The view of a fan is one to one: edges leave the vertex in different directions, no
// corner holds another, and triangles, which lie within their corners, have nothing in common but
// the vertex and the edges between them. In most meshes most vertices have one, which spares the
// exact test of some nine pairs of triangles for each.
//
// Main flow of find_fans(), for the three axes at once:
//  1. sides     of each facet that is seen along the axis, from its plane's row
//  2. edges     the two facets at an edge lie on different sides of it, or both its ends have no
//               fan
//  3. turns     given 2, all corners around a vertex turn one way. A corner passes the direction 0
//               exactly if it begins in the lower half-plane and ends in the upper one, or is no
//               less than half a turn and begins in the half-plane where it ends; they go around
//               once exactly if one of them does.
//
// Of triangles of input points coordinates are compared, nothing is computed: O(n), about 10 ns a
// triangle. Of other facets the boxes of their corners are compared, which may leave it open, and a
// sign tells which corners are reflex.

/// Per vertex: 1 if the corners around it surely are a fan, and it is not inside a facet besides:
/// then edges leave it in different directions, corners lie side by side, and triangles of two
/// facets around it meet in common edges and vertices alone. So do triangles of which larger facets
/// are made. Requires edges, planes of facets and cycles.
std::vector<std::uint8_t> find_fans(const SpaceComplex& complex);

}  // namespace plumb
