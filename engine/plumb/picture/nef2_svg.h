// Draws a set of the plane as SVG:
//   - Marked faces are filled.
//   - Marked edges are solid lines, and unmarked edges are dashed lines.
//   - Marked points are filled dots, and unmarked points are hollow dots.
//   - Unbounded parts fade out towards the sides of the picture.
// The file does not load other files and has no scripts. The y-axis points upwards.
//
// Main flow of write_nef2_svg:
//  1. window   makes the window, a box that contains all vertices (PlaneWindow)
//  2. cut      intersects the set with the interior of the box, exactly. After this step, every
//              face and every edge is bounded.
//  3. draw     draws filled faces, convex parts, edges and dots. Edges and dots on the border of
//              the box are left out.
//  4. explain  writes axes, notes, and a legend that explains each kind of cell in the picture
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
  std::string title = {};  ///< The title, such as the name of the file. May be any bytes.
  /// Convex parts of the set. Each part of dimension 2 is drawn in its own colour, and thin lines
  /// separate the parts.
  std::span<const Nef2> pieces = {};
  /// The context of the picture. A null pointer means that there are no limits, no stop request and
  /// no progress callback.
  Context* context = nullptr;
};

/// Writes the picture of a set. The set may have any exact coordinates and any number of faces. The
/// file is always smaller than 20 MB. If parts of the set are left out to stay below this size, the
/// picture names these parts. The output is deterministic. Cost: O(n log n) for n cells. Exceptions
/// of `out` and of the Context reach the caller.
void write_nef2_svg(std::ostream& out, const Nef2& set, const Nef2SvgOptions& options = {});

}  // namespace plumb
#pragma GCC visibility pop
