// Two complexes that lie apart, as one: nothing has to meet.
#pragma once

#include <span>

#include "plumb/base/box_tree.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// A complex and boxes that hold its boundary: one around all, or one for each set that was appended.
struct BoxedComplex {
  const SpaceComplex& complex;
  std::span<const Box3> parts;
};

/// Is it plain that neither boundary meets the other or lies in a bounded volume of it? So it is if the boxes have no
/// point in common, or that of one, moved to infinity along an axis, meets no part or no item of the other.
/// Requires complexes without a frame. O(parts), O(n) if those do not tell; in doubles.
bool are_apart(const BoxedComplex& a, const BoxedComplex& b);

/// Both, with one volume 0, whose mark is that of a's. Requires are_apart(a, b). Adds to a's arrays and, where
/// nobody else needs them, tables: O(b) then.
SpaceComplex appended(SpaceComplex a, SpaceComplex b);

}  // namespace plumb
