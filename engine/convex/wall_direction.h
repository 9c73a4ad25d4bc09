// Which direction makes the fewest pieces when walls hold it? (internal to walls)
#pragma once

#include "plumb/convex/walls.h"

namespace plumb {

/// Candidates: the axes, and directions that several reflex edges or normals of facets share. Each is judged by what it would
/// cut: an edge that is not vertical makes a wall, and two more pieces for each other such edge whose
/// shadow its own crosses; a vertical edge makes one. Shadows are compared in doubles: nothing but the number
/// of pieces depends on it. O(r^2) for r reflex edges (of more than 1500 a sample).
struct VerticalChoice {
  VerticalDirection up;
  double pieces = 0;  ///< expected
};
VerticalChoice choose_vertical(const SpaceComplex& complex, Context& context);

}  // namespace plumb
