// Convexity of sets of the plane. The set is arbitrary: each cell may be open or closed, and the
// set may be unbounded. The set may also be a line, a segment, or a set of points.
//
// Main flow of convexity_of_set(), where S is the tested set, which is stored as a minimal complex:
//  1. face    examines the marked faces. If there are two or more marked faces, S is not convex,
//             for the following reason. If S were convex, a segment between two of the faces would
//             lie in S. It would cross an edge or a vertex between the faces, and a minimal complex
//             would not contain this edge or vertex. If there is exactly one marked face f, it must
//             have one boundary loop and no reflex corner. Then f is convex (Tietze 1928). All
//             other marked cells must lie on the boundary of f, so that S contains f and is
//             contained in the closure of f
//  2. sides   checks the sides of f. A side of f can consist of several edges and vertices on one
//             line. If two of these cells are marked, all cells between them must be marked, too,
//             because S must contain the segment between any two of its points on this side
//  3. none    examines a set without a marked face. Two marked edges on different lines span a
//             triangle that is not in S. Two marked edges on the same line would be a single edge
//             if S were convex. So S is convex in three cases only: S is empty, S is one point, or
//             S is one edge. Each end of this edge may or may not belong to S
//
// The convexity test in space uses the same argument in each plane. The evidence consists of the
// reflex corners and the number of connected components. Cost: O(n) for n cells. Proof:
// docs/design/walls.md. Source: H. Tietze, Über Konvexheit im kleinen und im großen,
// Mathematische Zeitschrift 28 (1928).
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
  FaceId face;            ///< The face of the set's complex.
  RationalPoint2 corner;  ///< A corner around which the face spans more than half a turn.
};

/// The result of a convexity test in the plane. All lists are in ascending order.
struct PlaneConvexity {
  bool is_convex = false;            ///< Whether the set is convex.
  std::uint64_t reflex_corners = 0;  ///< The number of reflex corners (see PlanePieces).
  std::uint64_t parts = 0;           ///< The number of connected components of the set.
  std::vector<FailingRegion> faces;  ///< The marked faces with reflex corners.
};

/// Returns whether the set contains the segment between any two of its points, with evidence. The
/// test takes the marks of edges and vertices into account. The empty set, the whole plane, a
/// point, a line, and an open or half-open convex polygon are convex. A closed square from which
/// one inner point of a side was removed is not convex, although no corner is reflex and the set is
/// connected. Throws the errors of the Context.
PlaneConvexity convexity_of_set(const Nef2& set, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
