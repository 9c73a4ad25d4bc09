// Are these the convex pieces of that set of the plane, and could there be fewer? By Booleans and
// by trying all.
#pragma once

#include <string>
#include <vector>

#include "plumb/convex/plane_partition.h"

namespace plumb::testing {

/// Empty, or the first thing that is wrong: a piece that an audit rejects, of several dimensions,
/// or whose interior is not the intersection of the half-planes at its sides; a union that is not
/// the set (of closed pieces: its closure); points in two pieces (their interiors); areas that do
/// not add up.
std::string flaw_of_partition(const Nef2& set, const PlanePieces& pieces, bool closed);

/// The fewest convex pieces that diagonals between vertices of a polygon can make: all sets of
/// diagonals that do not cross are tried. Rings as in PolygonWithHoles2, disjoint. Exponential.
std::size_t fewest_pieces_by_diagonals(const PolygonWithHoles2& polygon);

}  // namespace plumb::testing
