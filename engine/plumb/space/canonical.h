// Canonical form of a complex. The arrays of a complex in canonical form depend on the set alone.
// So equal sets have equal arrays, however they were made.
//
// The minimal complex of a set is unique up to names and orders. The ids of its cells, the planes
// that define its edges and points, and the order of its tables depend on the history of the set.
// In canonical form they follow from the geometry:
//
//   vertices   are in lexicographic order. Vertices of the frame are ordered in the same way, with
//              R greater than all numbers
//   edges      are ordered by their lesser vertex, then by the other one; half-edge 2 e starts at
//              the lesser vertex
//   facets     are ordered by their least vertex, then by the next vertex of their boundary, then
//              by the vertex before
//   uses       are listed facet by facet. Each cycle begins with its least half-edge, and holes are
//              ordered by that half-edge
//   volumes    are in the order in which facets (positive side first), edges and vertices name them
//              first; volume 0 stays
//   lists      (stars, vertices inside facets) are ascending
//   planes     of the axes come first, then those of the frame. The others follow in the order in
//              which facets, edges and points name them first. Each plane has primitive integer
//              coefficients
//   an edge    is given by the first two planes of its facets. If it has fewer facets, it is given
//              by planes through it parallel to axes, x first
//   a point    is an input point if its coordinates are doubles. Otherwise it is given by the first
//              planes of facets and edges at it that meet in one point. If there are no such
//              planes, it is given by planes perpendicular to axes, x first
//   ids        of facets (facet_origin) are dropped: == does not compare them
//
// Main flow of canonical():
//  1. order cells     canonical_order(): signs of coordinates order the vertices; all other orders
//                     follow from ids
//  2. name planes     of facets, then of edges, in a new table
//  3. name points     vertex by vertex
//  4. write arrays    each in its new order
//
// Cost: O(n log n). In addition, each plane costs one row of the table and one gcd, and the exact
// coordinates of each vertex that is not an input point are computed.
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the same set in canonical form. The arrays and tables of canonical(a) and canonical(b)
/// are equal if and only if a == b. If they are equal, write_nef3() writes the same bytes for both.
/// The ids of facets (facet_origin) are dropped. Throws what the context throws.
Nef3 canonical(const Nef3& set, Context& context = unlimited_context());
/// Returns the canonical form of a complex. Requires that audit(minimal, AuditForm::Minimal) finds
/// no flaw.
SpaceComplex canonical(const SpaceComplex& minimal, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
