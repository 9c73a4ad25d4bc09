// Do two minimal complexes describe the same set?
#pragma once

#include "plumb/space/space_complex.h"

namespace plumb {

/// Vertices are matched by the fingerprints of their points; at each the sphere maps must agree. As
/// every item has a vertex in its closure, nothing else can differ. Requires minimal complexes. Expected
/// O(n) besides merging tables.
bool is_same(const SpaceComplex& a, const SpaceComplex& b);

/// Are the arrays equal, and what the tables say of planes and points? So they are of sets made in the same way.
/// False says nothing of the sets. O(n) comparisons of numbers, few if it is false.
bool is_identical(const SpaceComplex& a, const SpaceComplex& b);

}  // namespace plumb
