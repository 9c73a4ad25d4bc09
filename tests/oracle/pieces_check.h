// Are these the convex pieces of that set? By rational support tests, Booleans and exact volumes.
#pragma once

#include <string>

#include "plumb/convex/decompose.h"

namespace plumb::testing {

/// Empty, or the first thing that is wrong: a piece that an audit rejects, of several dimensions,
/// or with a vertex on the wrong side of a facet (where it is bounded; else by its interior's
/// is_convex()); a union that is not the set (of closed pieces: its closure); points in two pieces
/// (their interiors); volumes that do not add up.
std::string flaw_of_pieces(const Nef3& set, const ConvexPieces& pieces, bool closed);

/// Components + (r^2 + r) / 2.
std::size_t bound_of_cuts(std::size_t components, std::size_t reflex_edges);

}  // namespace plumb::testing
