// Convex pieces as sets of the plane (internal to plane_partition).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/region/plane_region.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/sweep/sweep.h"

namespace plumb {

/// Makes sets of parts of one structure, each in time of its own size.
class PieceMaker {
 public:
  explicit PieceMaker(const PlanePoints& points);

  /// A side of the piece: the part of a line between two points, dense or SweepCurve::kUnbounded.
  /// `inside`: Positive, the piece lies left of the line; Zero, it has nothing beside it.
  void add_side(const SweepCurve& side, Sign inside, bool mark);
  /// An end of a side that belongs to the piece.
  void add_point(std::uint32_t point) { marked_.push_back(point); }
  /// The piece; without sides the plane. Forgets it. O(k log k) for k sides.
  Nef2 build(Context& context);

 private:
  std::uint32_t input(std::uint32_t point);
  std::uint32_t dense(std::uint32_t point, std::vector<std::uint32_t>& crossings);

  const PlanePoints& points_;
  std::vector<std::uint32_t> local_;  // per point
  std::vector<std::uint32_t> inputs_;
  std::vector<SweepCurve> sides_;
  std::vector<std::int8_t> jumps_;
  std::vector<std::uint8_t> marks_;
  std::vector<std::uint32_t> marked_;
};

/// Appends the part to the left of each loop of a region, with what it owns of its boundary: marked
/// sides of the face, cuts along their lines, and marked vertices that no loop before it has. O(n
/// log n).
void add_pieces(const PlaneRegion& region, std::vector<Nef2>& pieces, Context& context);

// A region of the plane cut by the lines of its own sides (internal to plane_partition).
//
// Main flow of cut_by_sides():
//  1. join     each hole, in the order of their least vertices: the lesser end of a side there goes
//              on to lesser points, so it meets what has been joined before, or infinity
//  2. resolve  each corner that is still reflex: one of its sides goes on into it, up to the first
//              thing it meets on the boundary of its piece. Both parts of the corner are at most
//              half a turn then
//  3. tidy     cuts that later ones made superfluous go (drop_superfluous())
//
// Each cut of 1 joins two loops and each cut of 2 parts one, so r reflex corners and h holes make
// at most r + 1 - h pieces. A cut lies on a line of the set, and what it meets on another: a point
// is the crossing of two lines of the set. Cost: O(n) for each cut, less where pieces get small.

void cut_by_sides(PlaneRegion& region, Context& context);

/// Takes away, in their order, cuts without which no corner becomes reflex. O(n).
void drop_superfluous(PlaneRegion& region);

}  // namespace plumb
