// Vertical walls: the second method of decompose(). Sets are cut through their reflex edges by walls that all hold
// one direction, "vertical", until the pieces are convex.
//
// Main flow of wall_subdivision():
//  1. choose_vertical   (wall_direction.h) the direction for which the fewest pieces are expected; it is free
//  2. sight_walls       (wall_sight.h) from each reflex edge that is not vertical straight up and down, as far as
//                       the set goes. Now only vertical edges are reflex
//  3. spread_walls      (wall_spread.h) from each of these ahead, until the first facet or wall
//  4. with_walls        (wall_complex.h) after 2 and after 3: one overlay of all walls with the set
//
// A wall is bounded: it ends where it meets the boundary, or over the end of its edge, where step 3 goes on. Step 2 cuts a
// set with r reflex edges into O(r^2) cells, as every wall meets O(r) others; step 3 makes at most one piece
// more for each vertical edge. Worst-case optimal (Chazelle 1984).
//
// In one round walls are planes of facets or of the pencil of two facets: of 53-bit tetrahedra, united or taken out of a
// block, the longest number of a wall had 262 bits for a vertical along an axis (walls_test.cpp; 800 is the aim); the vertical that is
// chosen has 64 bits at most and makes them as much longer. Only a cell that lies above itself needs a second round, with
// pencils of walls, and a point taken out of a volume a wall through that point, whatever made it.
//
// Of an unbounded set only bounded volumes are cut so: a wall that nothing ends would have the symbolic cube for a
// side. What reaches to infinity is cut by the first method, planes.
//
// Cost: O((n + c) log(n + c)) for c contacts of walls with each other and the set, and for each reflex edge the facets
// near its shadow. Source: Hachenberger, Algorithmica 55 (2009) 329-345; the note convex-decomposition.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/decompose.h"
#include "plumb/predicates/rational.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// decompose() with method Walls. "Vertical" is the direction that gives the fewest pieces.
ConvexPieces decompose_by_walls(const Nef3& set, const DecomposeOptions& options, Context& context);

/// The pieces of one bounded volume, merged with neighbours, where walls make fewer than `most`; else none, as where that is
/// not to be expected by choose_vertical(): this is known after O(r^2) steps for r reflex edges.
std::vector<Nef3> fewer_pieces_by_walls(const Nef3& volume, std::size_t most, Context& context);

/// A direction that is not zero.
using VerticalDirection = std::array<Integer, 3>;

/// The set, subdivided: not minimal. Every marked volume is convex; facets that no facet of the set lies in have facet_origin
/// kWallOrigin, others that of the set's facet. Walls belong to the set. Throws Error{BadArgument} for an
/// unbounded set. Without a direction one is chosen.
SpaceComplex wall_subdivision(const Nef3& set, const std::optional<VerticalDirection>& up,
                              Context& context);

}  // namespace plumb
#pragma GCC visibility pop
