// The path data of SVG (attribute d): M L H V C S Q T A Z, absolute and relative.
#pragma once

#include "plumb/io/svg_outline.h"
#include "plumb/io/svg_value.h"

namespace plumb {

/// Adds the subpaths as rings; each is closed, as it is for being filled. Errors: Syntax, NumberOutOfRange and those of
/// the outline.
void read_svg_path(SvgValue& text, SvgOutline& outline);

/// An ellipse as a whole.
void add_svg_ellipse(const TextCursor& at, Point2 centre, double rx, double ry,
                     SvgOutline& outline);

}  // namespace plumb
