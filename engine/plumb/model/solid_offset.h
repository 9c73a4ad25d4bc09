// Offsets of sets of space: the points within a distance of a set, and the points of a set that are
// far from its complement. Balls are replaced by polyhedra.
//
// Let P be polyhedral_ball(|distance|, rounds) (minkowski.h). Its corners lie on the sphere with
// this radius, up to the rounding of their coordinates to doubles, and its facets are at least
// inner_radius(rounds) * |distance| away from the origin.
// The result is an exact set:
//   distance > 0   the Minkowski sum of the closure of the set and P. It lies in the offset with an
//                  exact ball, and contains the offset by inner_radius(rounds) * distance
//   distance < 0   the erosion of the closure by P: the points p for which P, moved by p, lies in
//                  the closure. It contains the erosion by an exact ball, and lies in the erosion
//                  by inner_radius(rounds) * |distance|
//   distance = 0   the closure
// So the boundary of the result is off by at most (1 - inner_radius(rounds)) * |distance|.
//
// Cost: P is convex, so it is added to each convex part of the set, and the sums are united. The
// erosion does the same for the complement.
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of offset() for sets of space.
struct SolidOffsetOptions {
  /// How often the faces of an octahedron are divided to make the ball: 0 to 7. The ball has 8 *
  /// 4^rounds triangles.
  unsigned rounds = 2;
};

/// Returns a lower bound for the distance of the facets of polyhedral_ball(1, rounds) from the
/// origin: 0.577, 0.816, 0.942, 0.984, ... for 0, 1, 2, 3, ... rounds. Throws Error{BadArgument} if
/// rounds > 7.
[[nodiscard]] double inner_radius(unsigned rounds);

/// Returns the closure of a set grown by a distance, or shrunk by a negative one; the head of this
/// file says how. Free facets and edges and isolated points grow to solids, and vanish when they
/// shrink. Throws Error{BadArgument} if `rounds` is more than 7, and if the set is unbounded and
/// distance > 0, or if the set and its complement are unbounded. Error{NotFinite} if `distance` is
/// not finite. What the context throws.
[[nodiscard]] Nef3 offset(const Nef3& set, double distance, const SolidOffsetOptions& options = {},
                          Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
