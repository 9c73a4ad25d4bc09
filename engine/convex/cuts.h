// The first method: planes through reflex edges.
//
// Main flow of cut_solid():
//  1. choose   (choose_plane.h) a plane through a reflex edge of the piece
//  2. cut      (plane_cut.h) along the part of the section that the edge bounds
//  3. repeat   with one piece, or two, until nothing is reflex
//
// Main flow of cut_set(), for a part of any kind:
//  1. cut_solid     if the part is a solid with one connected surface: this is done with most
//  2. divide        what is none, or is stuck, by a Boolean with a half-space; then its parts in turn
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

/// Lists of faces.
struct SolidPieces {
  std::vector<std::vector<FaceId>> convex;
  std::vector<std::vector<FaceId>> stuck;  ///< no plane cuts these this way (PlaneSection::find())
};

SolidPieces cut_solid(CutSurface& surface, Context& context);

/// The convex pieces of one part. Method Best: neighbours are merged.
std::vector<Nef3> cut_set(const SetPart& part, const DecomposeOptions& options, Context& context);

}  // namespace plumb
