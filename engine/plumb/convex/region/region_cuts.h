// Cuts of a plane region along the lines of its own sides, and the convex parts as sets of the
// plane (internal to plane_partition).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/region/plane_region.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/sweep/sweep.h"

namespace plumb {

/// Makes sets of convex parts of one structure, each in time of its own size.
class PieceMaker {
 public:
  explicit PieceMaker(const PlanePoints& points);

  /// Adds a side of the part: the piece of a line between two points, given as dense indices or
  /// SweepCurve::kUnbounded. `inside` is Positive if the part lies left of the line, and Zero if
  /// the side has nothing beside it.
  void add_side(const SweepCurve& side, Sign inside, bool mark);
  /// Marks an end of a side as belonging to the part.
  void add_point(std::uint32_t point) { marked_.push_back(point); }
  /// Returns the part, and starts anew. Without sides it is the plane. Cost: O(k log k) for k
  /// sides.
  Nef2 build(Context& context);

 private:
  std::uint32_t input(std::uint32_t point);
  std::uint32_t dense(std::uint32_t point, std::vector<std::uint32_t>& crossings);

  const PlanePoints& points_;
  std::vector<std::uint32_t> local_;  // Local number of each point, or kNone.
  std::vector<std::uint32_t> inputs_;
  std::vector<SweepCurve> sides_;
  IdVector<SegmentId, std::int8_t> jumps_;
  std::vector<std::uint8_t> marks_;
  std::vector<std::uint32_t> marked_;
};

/// Appends the part to the left of each loop of a region, with the cells of the boundary that it
/// owns: marked sides of the face, cuts along their lines, and marked vertices that no loop before
/// it has. Cost: O(n log n).
void add_pieces(const PlaneRegion& region, std::vector<Nef2>& pieces, Context& context);

// Main flow of cut_by_sides():
//  1. join     joins each hole to the rest, in the order of their least vertices: the lesser end of
//              a side there is prolonged to lesser points, so it meets what has been joined before,
//              or infinity
//  2. resolve  prolongs one side of each corner that is still reflex into it, up to the first thing
//              it meets on the boundary of its part. Both parts of the corner are then at most half
//              a turn
//  3. tidy     removes cuts that later cuts made superfluous (drop_superfluous())
//
// Each cut of step 1 joins two loops and each cut of step 2 divides one, so r reflex corners and h
// holes of positive area give at most r + 1 - h parts; a point or slit inside the region adds to r
// alone. A cut lies on a line of the set, and everything that it meets also lies on such a line. So
// a new point is the crossing of two lines of the set. Cost: O(n) for each cut, less when parts get
// small.

/// Cuts the region into convex parts. Throws the errors of the Context.
void cut_by_sides(PlaneRegion& region, Context& context);

/// Removes, in their order, cuts without which no corner becomes reflex. Cost: O(n).
void drop_superfluous(PlaneRegion& region);

}  // namespace plumb
