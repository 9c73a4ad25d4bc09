// Contacts: every point where a vertex, edge or facet of one complex meets one of another and the
// two have no common direction there. With the vertices of both these are all places where a
// Boolean of the two can have a vertex (docs/design/boolean.md).
//
// A pair of items meets in at most one point so: the pair IS the point, and points constructed by
// this Boolean are never tested for equality.
//
//   vertex x vertex, edge, facet        the vertex lies in the other item's relative interior
//   edge x edge                         not on one line, relative interiors cross
//   edge x facet                        not in one plane, relative interiors cross
//
// Main flow:
//  1. leaves      (contact_leaves.h) facets, free edges, isolated vertices within the other
//                 complex's box; every vertex and edge belongs to one leaf
//  2. pairs       dual descent of two box trees: pairs of leaves whose boxes meet
//  3. test        each vertex and edge of one leaf against the facet of the other: side of its
//                 plane, then (facet_site.h) the facet, edge or vertex where it is hit.
//                 find_contacts.cpp says why that finds nearly everything; flat edges, free edges
//                 and vertices without facets are compared directly
//  4. unique      some pairs are found from several facets: sort, unique; then points are
//                 constructed
//
// Cost: O(n log n + pairs of boxes), and for each place located O(corners of the facet) or, of a
// facet of many corners that is hit often, O(log^2 n) (contact_leaves.h). Memory: ~100 bytes a
// facet in reach, 8 bytes a contact found.
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

struct Contact {
  SpaceItem a;       ///< of the first complex: vertex, edge or facet
  SpaceItem b;       ///< of the second
  SpacePoint point;  ///< the vertex's point if one takes part (a's before b's); else constructed
  friend bool operator==(const Contact&, const Contact&) = default;
};

/// All contacts, sorted by (a, b), each once. Both complexes refer to `tables`; constructed points
/// are added to it. Throws what the context throws.
std::vector<Contact> meet(const SpaceComplex& a, const SpaceComplex& b, SpaceTables& tables,
                          Context& context);

}  // namespace plumb
