// Draws a set of the plane. Marked faces are filled; marked edges are solid, unmarked edges dashed;
// marked points are dots, unmarked points hollow; unbounded parts fade out towards the frame. The
// file is self-contained SVG without scripts; y points upwards.
//
// Main flow of write_nef2_svg:
//  1. window   makes a box around all vertices (PlaneWindow)
//  2. cut      intersects the set with the open box, exactly: every face and edge is then bounded
//  3. draw     draws fill, convex parts, edges and dots, except for what lies on the box
//  4. explain  writes axes, the legend of what occurs, and notes
#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of the picture of a set of the plane.
struct Nef2SvgOptions {
  std::string title = {};  ///< The title, such as the name of the file; any bytes.
  /// Convex parts of the set. Each part of dimension 2 has a colour of its own, with thin lines
  /// between the parts.
  std::span<const Nef2> pieces = {};
  Context* context = nullptr;  ///< Checked between parts; its exceptions are passed on.
};

/// Writes the picture of a set, with any exact coordinates and any number of faces. The file stays
/// below 20 MB and states what is left out for that. The output is deterministic. Cost: O(n log n).
/// Throws what `out` and the Context throw.
void write_nef2_svg(std::ostream& out, const Nef2& set, const Nef2SvgOptions& options = {});

}  // namespace plumb
#pragma GCC visibility pop
