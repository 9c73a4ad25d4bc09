// Canonical form of a complex. The arrays of a complex in canonical form depend only on the set
// that the complex describes. So equal sets have equal arrays, whatever operations made the sets.
//
// The minimal complex of a set is unique up to names and orders. In general, the ids of the cells,
// the planes that define edges and points, and the order of the tables depend on the history of the
// set. In canonical form, the following rules derive all of these from the geometry:
//
//   vertices   are in lexicographic order of their coordinates. Vertices of the frame are included
//              in this order; the half side R of the frame counts as greater than all numbers
//   edges      are ordered by their lesser vertex, then by their greater vertex. Half-edge 2 e
//              starts at the lesser vertex of edge e
//   facets     are ordered by their least vertex, then by the vertex that follows it on the
//              boundary, then by the vertex that precedes it
//   uses       are listed facet by facet. Each cycle begins with its least half-edge, and the
//              cycles of holes are ordered by their least half-edges
//   volumes    are in the order of their first occurrence in the lists of facets (positive side
//              before negative side), edges and vertices. Volume 0 stays volume 0
//   lists      (stars, vertices inside facets) are ascending
//   planes     x = 0, y = 0 and z = 0 come first, then the planes of the frame. The other planes
//              are in the order of their first occurrence in the lists of facets, edges and points.
//              Each plane has primitive integer coefficients
//   an edge    is defined by the first two planes of its facets. If there are fewer than two such
//              planes, planes that contain the edge and are parallel to an axis are used as well,
//              the x axis first
//   a point    is an input point if its coordinates are doubles. Otherwise it is defined by the
//              first three planes of facets and edges at the point that meet only there. If there
//              are no such planes, it is defined by planes perpendicular to the x, y and z axis
//   ids        of facets (facet_origin) are dropped: == does not compare them
//
// Main flow of canonical():
//  1. order cells     canonical_order() sorts vertices by comparing coordinates, and sorts all
//                     other cells by ids
//  2. name planes     enters the planes of facets, then the planes of edges, in a new table
//  3. name points     enters the points, vertex by vertex
//  4. write arrays    writes each array in its new order
//
// Cost: O(n log n). In addition, each plane needs one row of the table and one gcd. For each vertex
// that is not an input point, the exact coordinates are computed.
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the same set in canonical form. The arrays and tables of canonical(a) and canonical(b)
/// are equal if and only if a == b. If the arrays and tables are equal, write_nef3() writes the
/// same bytes for both sets. The ids of facets (facet_origin) are dropped. Throws what the context
/// throws.
Nef3 canonical(const Nef3& set, Context& context = unlimited_context());
/// Returns the canonical form of a complex. Requires that audit(minimal, AuditForm::Minimal) finds
/// no flaw.
SpaceComplex canonical(const SpaceComplex& minimal, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
