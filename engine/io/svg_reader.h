// Reads drawings: SVG (docs/formats.md, "Drawings"), as closed polygons.
//
// Main flow of read_svg:
//  1. scan     elements and attributes (xml_scanner.h): nothing is expanded, nothing loaded
//  2. place    the transforms of groups and of the element, one after the other
//  3. trace    rect, circle, ellipse, line, polyline, polygon, path as lines and curves (svg_path.h); every
//              subpath is closed, as it is for being filled
//  4. flatten  curves to chords within the tolerance (svg_outline.h)
//  5. turn     the middle of the drawing to the origin, y upwards
//
// One shape for each element that has an outline, in the order of the file; its subpaths are rings of it. Colours,
// strokes, styles, clips and fill rules mean nothing. What is only defined (defs, symbol, clipPath, mask, marker,
// pattern) is passed over, and so are elements of other names; of those that would be drawn (use, text, image,
// nested drawings) a note is made.
//
// The middle: of viewBox; else of width and height, if both are lengths; else the origin of the drawing.
#pragma once

#include <optional>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/io/svg_drawing.h"

#pragma GCC visibility push(default)
namespace plumb {

/// `tolerance`: how far a curve may be from its chords, in units of the drawing, more than zero; none: a thousandth of the
/// larger side of viewBox, or of width and height. The memory of the drawing stays charged to `context`.
///
/// Cost: O(bytes + points). Errors with their place: those of the scanner; Syntax, NumberOutOfRange; BadShape for a
/// negative size, and for a curve where the tolerance is unknown; ResourceLimit; Cancelled.
SvgDrawing read_svg(std::string_view text, const ReadOptions& options,
                    std::optional<double> tolerance, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
