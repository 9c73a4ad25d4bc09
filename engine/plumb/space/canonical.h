// Canonical form of a complex. The arrays of a complex in canonical form depend only on the set
// that the complex describes. So equal sets have equal arrays, whatever operations made the sets.
//
// Two minimal complexes of the same set have the same cells. But three things depend on the
// operations that made the set: the ids of the cells, the planes that define edges and points, and
// the order of the tables of planes and points. In canonical form, the following rules derive them
// from the geometry:
//
//   vertices   are in lexicographic order of their coordinates. This order includes the vertices of
//              the frame. Half the side length of the frame, the symbol R, counts as greater than
//              all numbers
//   edges      are ordered by their lesser vertex, then by their greater vertex. Half-edge 2 e
//              starts at the lesser vertex of edge e
//   facets     are ordered by their least vertex, then by the vertex that follows it on the
//              boundary, then by the vertex that precedes it
//   uses       (edge uses) are listed facet by facet. Each cycle begins with its least half-edge,
//              and the cycles of holes are ordered by their least half-edges
//   volumes    are in the order of their first occurrence in the lists of facets, edges and
//              vertices. For a facet, the volume on the positive side comes before the volume on
//              the negative side. Volume 0 stays volume 0
//   lists      of ids (stars of vertices, vertices inside facets) are in ascending order
//   planes     x = 0, y = 0 and z = 0 come first, then the planes of the frame. The other planes
//              are in the order of their first occurrence in the lists of facets, edges and points.
//              Each plane has primitive integer coefficients
//   an edge    is defined by the first two planes of its facets. If its facets lie in fewer than
//              two planes, further planes are added until there are two. The candidates contain the
//              edge and are parallel to the x, y and z axis, in this order. An axis is skipped if
//              the edge is parallel to it, or if the edge already has the plane of this axis
//   a point    is an input point if its coordinates are doubles. Otherwise it is defined by three
//              planes. The planes of facets and edges at the point are tried in the order of their
//              ids. A plane is chosen if its normal is linearly independent of the normals of the
//              planes chosen before. If fewer than three planes are chosen, planes perpendicular to
//              the x, y and z axis are tried next, in the same way
//   ids of facets (facet_origin) are dropped, because the comparison of sets with == ignores them
//
// Main flow of canonical():
//  1. order cells     canonical_order() sorts vertices by comparing coordinates. It sorts all other
//                     cells by comparing the new ids of vertices
//  2. number planes   makes a new table, and adds the planes of facets and then the planes of edges
//  3. number points   adds the points to the new table, vertex by vertex
//  4. write arrays    writes each array in its new order
//
// Cost: O(n log n) for n cells. In addition, one greatest common divisor is computed for each
// plane, and the exact coordinates are computed for each vertex that is not an input point.
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the same set in canonical form. The arrays and tables of canonical(a) and canonical(b)
/// are equal if and only if a == b. If the arrays and tables are equal, write_nef3() writes the
/// same bytes for both sets. The ids of facets (facet_origin) are dropped. Throws the errors of the
/// Context.
Nef3 canonical(const Nef3& set, Context& context = unlimited_context());
/// Returns the canonical form of a complex. Requires that audit(minimal, AuditForm::Minimal) finds
/// no flaw.
SpaceComplex canonical(const SpaceComplex& minimal, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
