// A set of the plane as a picture: marked faces filled, marked edges solid, unmarked ones dashed;
// points that belong are dots, points that do not are hollow; what goes on to infinity fades out
// towards the frame. Self-contained SVG without scripts, y axis upwards.
//
// Flow of write_nef2_svg:
//  1. PlaneWindow     a box around all vertices
//  2. the set * the open box: every face and edge is bounded then, cut off exactly
//  3. fill, pieces (piece_layer.h), edges, dots of that, but for what lies on the box
//  4. axes, legend of what occurs, notes
#pragma once

#include <ostream>
#include <span>
#include <string>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What the page of a set of the plane shows.
struct Nef2SvgOptions {
  std::string title = {};  ///< e.g. the file's name; any bytes
  /// Convex pieces of the set: those of dimension 2 have a colour each and thin lines between them.
  std::span<const Nef2> pieces = {};
  Context* context = nullptr;  ///< asked between pieces; what it throws comes out
};

/// Writes the picture of any set: any exact coordinates, any number of faces; the file stays below
/// 20 MB, what is left out for that is said in it. Deterministic. O(n log n).
void write_nef2_svg(std::ostream& out, const Nef2& set, const Nef2SvgOptions& options = {});

}  // namespace plumb
#pragma GCC visibility pop
