// Computes offsets of sets of space. A set is grown by a distance d to the set of all points whose
// distance from the set is at most d. A set is shrunk by d to the set of its points whose distance
// from the complement is at least d. Such sets are bounded by spheres and cylinders, so they are
// approximated: a ball is replaced by a polyhedron.
//
// Let P be polyhedral_ball(|distance|, rounds) (minkowski.h). The corners of P lie on the sphere
// around the origin with radius |distance|, except that their coordinates are rounded to doubles.
// The distance of each facet of P from the origin is at least inner_radius(rounds) * |distance|.
// With this polyhedron, the result is computed exactly:
//   distance > 0   The result is the Minkowski sum of P and the closure of the set. The result lies
//                  in the offset of the set with an exact ball of radius `distance`. The result
//                  contains the offset with an exact ball of radius inner_radius(rounds) * distance
//   distance < 0   The result is the erosion of the closure by P, that is, the set of all points p
//                  for which P, translated by p, lies in the closure. The result contains the
//                  erosion by an exact ball of radius |distance|. The result lies in the erosion by
//                  an exact ball of radius inner_radius(rounds) * |distance|
//   distance = 0   The result is the closure of the set
// So the result lies between two exact offsets. Their distances differ by
// (1 - inner_radius(rounds)) * |distance|.
//
// Cost: the cost of minkowski_sum() of P and the set. P is convex, so only the set is decomposed
// into convex parts. If the distance is negative, the complement of the set is decomposed instead.
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of offset() for sets of space.
struct SolidOffsetOptions {
  /// The polyhedron that replaces the ball is made from an octahedron by subdividing its faces.
  /// This member says how often they are subdivided: 0 to 7 times. The polyhedron has 8 * 4^rounds
  /// triangles.
  unsigned rounds = 2;
};

/// Returns a lower bound for the distance from the origin to the facets of polyhedral_ball(1,
/// rounds). The bounds for 0, 1, 2 and 3 rounds are about 0.577, 0.816, 0.942 and 0.984. Throws
/// Error{BadArgument} if rounds > 7.
[[nodiscard]] double inner_radius(unsigned rounds);

/// Returns the closure of a set, grown by `distance` if `distance` is positive, and shrunk by
/// |distance| if it is negative. The head of this file defines the result. If the set is grown,
/// free facets, free edges and isolated points become solids. If it is shrunk, they vanish. Throws
/// Error{BadArgument} in three cases: `rounds` is more than 7; the set is unbounded and distance >
/// 0; the set and its complement are both unbounded. Throws Error{NotFinite} if `distance` is not
/// finite. Also throws the errors of the Context.
[[nodiscard]] Nef3 offset(const Nef3& set, double distance, const SolidOffsetOptions& options = {},
                          Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
