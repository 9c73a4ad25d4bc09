// The first method: planes through reflex edges.
//
// Main flow of cut_solid():
//  1. choose   (choose_plane.h) a plane through a reflex edge of the piece
//  2. cut      (plane_cut.h) along the part of the section that the edge bounds
//  3. repeat   with one piece, or two, until nothing is reflex
//
// A surface that is connected and has no reflex edges bounds a convex solid (space_convexity.h).
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/cut_surface.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/set_parts.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// Divides the surface; the faces of each convex piece. Empty: a piece could not be cut this way.
std::vector<std::vector<FaceId>> cut_solid(CutSurface& surface, Context& context);

/// The convex pieces of one part of any kind, by Booleans with half-spaces. A cut divides all that the plane meets.
/// Cost: a few Booleans near the plane and O(size) a cut.
std::vector<Nef3> cut_set(const SetPart& part, Context& context);

}  // namespace plumb
