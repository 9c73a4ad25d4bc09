// Two complexes that lie apart, as one: nothing has to meet.
#pragma once

#include "plumb/space/space_complex.h"

namespace plumb {

/// Is it plain that neither boundary meets the other or lies in a bounded volume of it? So it is if the boxes have no
/// point in common, or that of the smaller one, moved to infinity along an axis, meets nothing of the
/// other. Requires complexes without a frame. O(n) at most, in doubles.
bool are_apart(const SpaceComplex& a, const SpaceComplex& b);

/// Both, with one volume 0, whose mark is that of a's. Requires are_apart(a, b). Adds to a's arrays and, where
/// nobody else needs them, tables: O(b) then.
SpaceComplex appended(SpaceComplex a, SpaceComplex b);

}  // namespace plumb
