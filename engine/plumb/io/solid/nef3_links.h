// Whether the links of a complex can be followed: what a reader must know before anybody else sees
// it.
#pragma once

#include <string>

#include "plumb/space/space_complex.h"

namespace plumb {

/// Requires sizes that agree and ids in range (the reader's records have them). What is wrong, or
/// "":
///
///   edges     join two vertices; lie on two planes; free in a volume, or on a facet
///   vertices  alone: in a volume, or in a facet, not both; else no volume
///   uses      next goes on from where a use ends, in the same facet; radial stays at the edge;
///             both are permutations, and one radial cycle holds all uses of an edge
///   facets    each cycle of uses is listed once, with the facet that its uses name
///
/// O(n).
std::string flaw_of_links(const SpaceComplex& complex);

}  // namespace plumb
