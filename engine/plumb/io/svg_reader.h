// Reads drawings: SVG (docs/formats.md, "Drawings"), as closed polygons in the plane.
//
// Main flow of read_svg:
//  1. scan     reads elements and attributes (svg_syntax.h); nothing is expanded or loaded
//  2. place    composes the transforms of groups and of the element
//  3. trace    turns rect, circle, ellipse, line, polyline, polygon and path into lines and curves
//              (svg_outline.h); every subpath is closed, as it is for filling
//  4. flatten  replaces curves by chords within the tolerance (svg_outline.h)
//  5. turn     moves the middle of the drawing to the origin and makes y point upwards
//
// Each element that has an outline gives one shape, in the order of the file; its subpaths are the
// rings of the shape. Colours, strokes, styles, clips and fill rules are ignored. Contents that are
// only defined (defs, symbol, clipPath, mask, marker, pattern) and elements with other names are
// skipped. Skipped elements that would be drawn (use, text, image, nested drawings) give a note.
//
// The middle of the drawing is that of viewBox, or else that of width and height if both are
// lengths, or else the origin of the drawing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/predicates/point.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Closed polygons in flat arrays: shapes are lists of rings, rings are lists of points.
struct SvgDrawing {
  std::vector<Point2> points;       ///< Points; x to the right, y upwards, origin in the middle.
  std::vector<std::size_t> places;  ///< The byte of the text that gives each point.
  std::vector<std::uint32_t> ring_begin = {0};   ///< First points of rings, and the end.
  std::vector<std::uint32_t> shape_begin = {0};  ///< First rings of shapes, and the end.
  std::vector<std::string> notes;                ///< What was left out, for people.

  std::size_t ring_count() const { return ring_begin.size() - 1; }    ///< Number of rings.
  std::size_t shape_count() const { return shape_begin.size() - 1; }  ///< Number of shapes.
  /// Returns the points of ring `r`. The ring closes from its last point to its first.
  std::span<const Point2> ring(std::size_t r) const {
    return std::span(points).subspan(ring_begin[r], ring_begin[r + 1] - ring_begin[r]);
  }
};

/// Returns the drawing that `text` holds. `tolerance` is the largest distance of a curve from its
/// chords, in units of the drawing, and must be positive; the default is a thousandth of the larger
/// side of viewBox, or of width and height. The memory of the drawing stays charged to `context`.
///
/// Cost: O(bytes + points). Errors, thrown with their place: the errors of the scanner; Syntax;
/// NumberOutOfRange; BadShape for a negative size, and for a curve if the tolerance is unknown;
/// ResourceLimit; Cancelled.
SvgDrawing read_svg(std::string_view text, const ReadOptions& options,
                    std::optional<double> tolerance, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
