// Convexity of a set of the plane, of any kind: open or closed item by item, unbounded, a line, a segment, points.
//
// Main flow of convexity_of_set(), S the set of a minimal complex:
//  1. face    Two marked faces: the segment between them crosses an item whose surroundings are not all alike, so S is not
//             convex. One, f: it must have one boundary loop and no reflex corner, then it is convex (Tietze 1928), and
//             what else is marked must lie on that boundary: S is between f and its closure
//  2. sides   what is left are segments within one side of f: what is marked of it must be consecutive
//  3. none    without a marked face two marked edges span an unmarked triangle, or lie on a line, where S convex would make
//             them one. So S is one edge with any of its ends, or one point, or empty
//
// The same as space_convexity.h says of a plane in space. Evidence: reflex corners, and of how many parts the set is. Cost: O(n).
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/base/ids.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// A marked face that is not convex.
struct FailingRegion {
  FaceId face;            ///< of the set's complex
  RationalPoint2 corner;  ///< more than half a turn of the face is around it
};

/// What speaks for and against; lists ascend.
struct PlaneConvexity {
  bool is_convex = false;            ///< the answer
  std::uint64_t reflex_corners = 0;  ///< as PlanePieces::reflex_corners
  std::uint64_t parts = 0;           ///< connected components of the set
  std::vector<FailingRegion> faces;  ///< marked faces with reflex corners
};

/// Does the set hold the segment between any two of its points? As a point set, with its marks. Empty, the whole plane, a
/// point, a line, an open or half-open convex polygon are convex; a closed square without an inner point of a side is
/// not, though no corner is reflex and it is one part. Throws what the context throws.
PlaneConvexity convexity_of_set(const Nef2& set, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
