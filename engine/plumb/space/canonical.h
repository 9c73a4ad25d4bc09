// Canonical form of a complex: its arrays depend on the set alone, so that equal sets have equal
// arrays, however they were made.
//
// The minimal complex of a set is unique, but the ids of its cells, the planes that define its
// edges and points, and the order of its tables depend on its history. In canonical form they
// follow from the geometry:
//
//   vertices   are in lexicographic order, those of the frame too (R is beyond all bounds)
//   edges      are ordered by their lesser vertex, then by the other one; half-edge 2e starts at
//              the lesser vertex
//   facets     are ordered by their least vertex, then by where their boundary goes from there,
//              then by where it comes from
//   uses       are listed facet by facet, each cycle from its least half-edge on; holes are ordered
//              by that half-edge
//   volumes    are in the order in which facets (positive side first), edges and vertices name
//              them first; volume 0 stays
//   lists      (stars, vertices inside facets) ascend
//   planes     are those of the axes, of the frame, then in the order in which facets, edges and
//              points name them first, each with primitive integer coefficients
//   an edge    is given by the first two planes of its facets; if there are fewer, by planes
//              through it parallel to axes, x first
//   a point    is an input point if doubles hold it. Otherwise it is given by the first planes of
//              facets and edges at it that meet in one point; if there are none, by planes
//              perpendicular to axes, x first
//   ids        of facets (facet_origin) are dropped: == does not compare them
//
// Main flow of canonical():
//  1. order cells     canonical_order(): signs of coordinates order the vertices; all other orders
//                     follow from ids
//  2. name planes     of facets, then of edges, in a new table
//  3. name points     vertex by vertex
//  4. write arrays    each in its new order
//
// Cost: O(n log n), a row and a gcd for each plane, and exact coordinates of each vertex that is
// not an input point.
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the same set in canonical form. canonical(a) and canonical(b) have equal arrays and
/// tables if and only if a == b, and write_nef3() then writes the same bytes. The ids of facets
/// (facet_origin) are dropped. Throws what the context throws.
Nef3 canonical(const Nef3& set, Context& context = unlimited_context());
/// Returns the canonical form of a complex. Requires that audit(minimal, AuditForm::Minimal) finds no flaw.
SpaceComplex canonical(const SpaceComplex& minimal, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
