// A complex whose numbers tell nothing but the set: equal sets have the same arrays, however they were made.
//
// The minimal complex of a set is unique, but the numbers of its items, the planes that its edges and points are given
// by and the order of its tables come from its history. Here they follow from where things are:
//
//   vertices   in lexicographic order, those of the frame too (R is beyond all bounds)
//   edges      by their lesser vertex, then by the other one; half-edge 2e runs from the lesser
//   facets     by their least vertex, then by where their boundary goes from there, then by where it comes from
//   uses       facet by facet, each cycle from its least half-edge on; holes by that half-edge
//   volumes    as facets (positive side first), edges and vertices name them first; volume 0 stays
//   lists      stars, vertices inside facets: ascending
//   planes     of the axes, of the frame, then as facets, edges and points name them first, in primitive form
//   an edge    is given by the first two planes of its facets; where there are less, by planes through it along
//              axes, x first
//   a point    is an input point if doubles hold it; else given by the first planes of facets and edges at it that meet
//              in one point; where there are none, by planes across axes, x first
//   ids        of facets (facet_origin) are dropped: == does not compare them
//
// Main flow of canonical():
//  1. order items     canonical_order(): signs of coordinates order the vertices, all else is a matter of numbers
//  2. name planes     of facets, then of edges, in a table of their own
//  3. name points     vertex by vertex
//  4. write arrays    each in its new order
//
// Cost: O(n log n), a row and a gcd for each plane, exact coordinates of each vertex that is no input point.
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The same set; canonical(a) and canonical(b) have equal arrays and tables exactly if a == b, and write_nef3() then
/// writes the same bytes. Facets have no ids any more.
Nef3 canonical(const Nef3& set, Context& context);
/// The same for a complex, which must be minimal: one that audit(complex, true) finds clean.
SpaceComplex canonical(const SpaceComplex& minimal, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
