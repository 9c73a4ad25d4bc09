// Computes offsets of sets of the plane. A set is grown by a distance d to the set of all points
// whose distance from the set is at most d. A set is shrunk by d to the set of its points whose
// distance from the complement is at least d.
//
// Main flow of offset():
//  1. raw_chains  walks around each loop of the border of the set, and makes a closed chain from
//                 it. Each edge of the loop is moved outwards by the distance. At a convex corner,
//                 a join connects the two moved edges (OffsetJoin). At a reflex corner, the chain
//                 leads from the end of one moved edge to the corner, and from there to the start
//                 of the other moved edge
//  2. polygons    (Nef2::polygons) takes the points whose winding number is positive. This winding
//                 number counts all chains together
//
// Why this is right: the winding number of all chains together at a point is the sum of the winding
// numbers of several polygons. These are the border of the set, one rectangle for each edge, and
// one join for each convex corner. Each of them runs counter-clockwise around its inside, so its
// winding number is 1 inside and 0 outside. The sum is therefore the number of these parts that
// contain the point. So it is positive exactly in the union of the parts, which is the grown set.
// If the distance is negative, the complement is grown in the same way. The result then contains
// the points of the set that do not lie in the grown complement.
//
// Numbers: each moved edge is exactly parallel to the edge of the set from which it was made. Its
// distance from this edge is the given distance, up to a relative error of 2^-50. The error cannot
// be avoided, because the length of an edge is in general not a rational number. All further steps
// are exact.
//
// Cost: O((n + k) log(n + k)) for n corners of the chains and k crossings of their edges. Source:
// A. Johnson's Clipper library also computes offsets by winding numbers. It has the same kinds of
// joins. It is based on B. R. Vatti, A generic solution to polygon clipping, Communications of the
// ACM 35 (1992).
#pragma once

#include <cstdint>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The shape of an offset at a convex corner of the set.
enum class OffsetJoin : std::uint8_t {
  Round,  ///< A polygon inscribed in the arc around the corner.
  /// The two moved edges are prolonged until they meet. If their common point is too far from the
  /// corner (OffsetOptions::mitre_limit), the join is Square.
  Mitre,
  /// The two moved edges are prolonged to a line that is orthogonal to the bisector of the corner.
  /// The distance of this line from the corner is the distance of the offset.
  Square,
  Bevel,  ///< A segment between the ends of the two moved edges.
};

/// Options of offset().
struct OffsetOptions {
  OffsetJoin join = OffsetJoin::Round;  ///< The shape at convex corners.
  /// The greatest distance of the tip of a mitre from its corner, divided by the distance of the
  /// offset. Must be at least 1.
  double mitre_limit = 2;
  /// The greatest distance between an arc and the chords that replace it, in the units of the
  /// coordinates. The value 0 stands for a thousandth of the distance of the offset.
  double chord_error = 0;
  /// The number of chords of a full circle. If it is not 0, it must be at least 3, and chord_error
  /// is ignored.
  std::uint32_t circle_segments = 0;
  /// The angle of each chord of an arc in radians. If it is not 0, chord_error and circle_segments
  /// are ignored, and arcs are divided as in OpenSCAD. An arc with the angle alpha has alpha /
  /// arc_step chords, where this quotient is rounded to the nearest integer, but to at least 1.
  /// Walk around the set with the set to the left. On this walk, the first chords of an arc have
  /// the angle arc_step, and the last chord has the remaining angle. An isolated point becomes a
  /// regular polygon with 2 pi / arc_step corners, rounded up. The value must be 0, or at least 2
  /// pi / kMostCircleSegments and at most pi.
  double arc_step = 0;
};

/// The greatest number of chords of a full circle.
inline constexpr std::uint32_t kMostCircleSegments = 1U << 20U;

/// Returns the closure of `set` grown by `distance`, or shrunk if the distance is negative. The
/// result is closed and has no dangling edges and no isolated points.
///   distance > 0   The result contains the set and the points whose distance from the set is at
///                  most `distance`. At convex corners, the join decides which points belong to the
///                  result. A free edge becomes a strip whose two ends are joins, too. An isolated
///                  point becomes a regular polygon (Round), an axis-parallel square (Mitre,
///                  Square) or a square standing on a corner (Bevel).
///   distance < 0   The result contains the points of the set whose distance from the complement is
///                  at least |distance|. Joins are used at the reflex corners of the set, which are
///                  the convex corners of the complement.
///   distance = 0   The result is the regularization of the closure.
/// Throws Error{BadArgument} if the set is unbounded, or if an option is out of its range. Throws
/// Error{NotFinite} if `distance` is not finite. Also throws the errors of the Context.
[[nodiscard]] Nef2 offset(const Nef2& set, double distance, const OffsetOptions& options = {},
                          Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
