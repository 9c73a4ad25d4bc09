// Offsets of sets of the plane: the points within a distance of a set, and the points of a set that
// are far from its border.
//
// Main flow of offset():
//  1. raw_chains  walks around the border of the set, and lists for each loop the border of the
//                 strip that the loop sweeps: each edge is moved outward by the distance, a convex
//                 corner gets a join, and a reflex corner is visited between its two moved edges
//  2. polygons    (Nef2::polygons) takes the points whose winding number with respect to all chains
//                 together is positive
//
// Why this is right: a chain is the sum, as a cycle, of the loop itself, of one rectangle for each
// edge, and of one join for each convex corner. Each of these parts is counter-clockwise, so it has
// the winding number 1 inside and 0 outside. The winding number of a point is therefore the number
// of parts that contain it, and it is positive exactly in the union of the parts. For a negative
// distance the same is done for the complement, and the set keeps the points that no part contains.
//
// Numbers: each moved edge is exactly parallel to its edge. Its distance from its edge is the
// distance asked for, up to a relative error of 2^-50, because the length of an edge is in general
// not a rational number. All further steps are exact.
//
// Cost: O((n + k) log(n + k)) for n corners of the chains and k crossings of their edges.
// Source: the union of strips by winding numbers is used by A. Johnson's Clipper library; joins as
// in B. R. Vatti, A generic solution to polygon clipping, Communications of the ACM 35 (1992).
#pragma once

#include <cstdint>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The shape of an offset at a convex corner of the set.
enum class OffsetJoin : std::uint8_t {
  Round,   ///< A polygon inscribed in the arc around the corner.
  Mitre,   ///< The two moved edges, prolonged until they meet; Square beyond the mitre limit.
  Square,  ///< The moved edges are cut off at the distance from the corner, across its bisector.
  Bevel,   ///< A segment between the ends of the two moved edges.
};

/// Options of offset().
struct OffsetOptions {
  OffsetJoin join = OffsetJoin::Round;  ///< The shape at convex corners.
  /// The greatest distance of the tip of a mitre from its corner, in units of the distance of the
  /// offset. At least 1.
  double mitre_limit = 2;
  /// The greatest distance between an arc and the chords that replace it, in the units of the
  /// coordinates. 0 stands for a thousandth of the distance of the offset.
  double chord_error = 0;
  /// If this is not 0, a full circle has this many chords, and chord_error is ignored. At least 3.
  std::uint32_t circle_segments = 0;
  /// If this is not 0, chord_error and circle_segments are ignored, and the chords of an arc have
  /// this angle in radians, as in OpenSCAD: an arc of angle a has a / arc_step chords, rounded to a
  /// whole number, but at least one. They begin at the edge that comes first when the set is on the
  /// left; the last chord takes what is left of the angle. At least 2 pi / kMostCircleSegments, and
  /// at most pi. Isolated points are treated as if circle_segments was 2 pi / arc_step, rounded up.
  double arc_step = 0;
};

/// The greatest number of chords of a full circle.
inline constexpr std::uint32_t kMostCircleSegments = 1U << 20U;

/// Returns the closure of `set` grown by `distance`, or shrunk if the distance is negative. The
/// result is closed and has no dangling edges and no isolated points.
///   distance > 0   The union of the set and of all points within `distance` of it; the join tells
///                  which further points around convex corners belong to the result. A free edge
///                  becomes a strip whose ends are joins, too; an isolated point becomes a regular
///                  polygon (Round), a square (Mitre, Square) or a square on its tip (Bevel).
///   distance < 0   The points of the set that are at least |distance| away from its complement,
///                  where the join is for the reflex corners of the set.
///   distance = 0   The regularization of the closure.
/// Throws Error{BadArgument} if the set is unbounded, or if an option is out of its range.
/// Error{NotFinite} if `distance` is not finite. Also throws what the context throws.
[[nodiscard]] Nef2 offset(const Nef2& set, double distance, const OffsetOptions& options = {},
                          Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
