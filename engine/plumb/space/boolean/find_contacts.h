// Contacts: every point where a vertex, edge or facet of one complex intersects a cell of another
// while the two have no common direction. With the vertices of both complexes these are all places
// where a Boolean of the two can have a vertex (docs/design/boolean.md, "Where the result can have
// a vertex").
//
// A pair of such cells meets in one point at most, so the pair names the point, and points that
// this Boolean constructs are never tested for equality (docs/design/planes-first.md, "Why a pair
// of cells is a point").
//
//   vertex x vertex, edge, facet        the vertex lies in the other cell's relative interior
//   edge x edge                         not on one line; the relative interiors cross
//   edge x facet                        not in one plane; the relative interiors cross
//
// Main flow:
//  1. leaves  collects the facets, free edges and isolated vertices within the other complex's box;
//             every vertex and edge belongs to one leaf (contact_leaves.h)
//  2. pairs   descends two box trees at once to the pairs of leaves whose boxes meet
//  3. test    tests each vertex and edge of one leaf against the facet of the other: the side of
//             its plane, then the facet, edge or vertex where it is hit (facet_site.h).
//             find_contacts.cpp says why that finds nearly everything; flat edges, free edges and
//             vertices without facets are compared directly
//  4. unique  sorts the pairs, as some are found from several facets, drops repetitions, and
//             constructs the points
//
// Cost: O(n log n + pairs of boxes), and for each place located O(corners of the facet), or O(log^2
// n) in a facet of many corners that is hit often (contact_leaves.h). Memory: about 100 bytes a
// facet in reach, 8 bytes a contact found.
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// A pair of cells that meet in one point and have no common direction.
struct Contact {
  SpaceItem a;       ///< The vertex, edge or facet of the first complex.
  SpaceItem b;       ///< The vertex, edge or facet of the second complex.
  SpacePoint point;  ///< A vertex's point if one takes part, a's before b's; else constructed.
  friend bool operator==(const Contact&, const Contact&) = default;
};

/// Returns all contacts, sorted by (a, b), each once. Requires that both complexes refer to
/// `tables`, to which constructed points are added. Throws the errors of the Context.
std::vector<Contact> find_contacts(const SpaceComplex& a, const SpaceComplex& b,
                                   SpaceTables& tables, Context& context);

}  // namespace plumb
