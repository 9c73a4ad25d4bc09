// Reads SVG drawings (docs/formats.md, "Drawings") as closed polygons in the plane.
//
// Main flow of read_svg:
//  1. scan     reads elements and attributes (svg_syntax.h). This step expands no entities and
//              loads no other files.
//  2. place    composes the transform of each element with the transforms of the groups that
//              contain the element
//  3. trace    converts rect, circle, ellipse, line, polyline, polygon and path to lines and curves
//              (svg_outline.h). Every subpath is closed: SVG closes subpaths in the same way when
//              it fills them.
//  4. flatten  replaces curves by chords. The distance of a curve from its chords is at most the
//              tolerance (svg_outline.h)
//  5. turn     moves the origin to the middle or to the lower left corner of the drawing, and makes
//              the y-axis point upwards (SvgFrame)
//
// Shapes: each element that has an outline becomes one shape, in the order of the file. The
// subpaths of the element are the rings of the shape. The fill rule of each shape is reported.
// Style sheets within the file are applied to the properties display, visibility and fill-rule.
// Colours, strokes and other styles are ignored. Clips, masks, markers and patterns are ignored,
// too, and notes name those that shapes refer to.
//
// Skipped elements: elements that only define something are skipped with their contents, because
// they draw nothing. These elements are defs, clipPath, mask, marker and pattern, and a symbol that
// no `use` draws. Elements with unknown names are skipped, too. A few elements that draw something
// are not supported: `text`, `image`, `switch` and `foreignObject`. These elements are skipped with
// a note.
//
// Middle: the middle of the drawing is determined as follows:
//   - If the drawing has a viewBox, the middle is the middle of this box.
//   - Otherwise, if width and height are given and neither is a percentage, the middle is
//     (width / 2, height / 2).
//   - In all other cases the middle is the origin of the drawing.
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

/// The position of the origin and the unit of the points that read_svg() returns.
enum class SvgFrame : std::uint8_t {
  /// The origin is the middle of the drawing. The unit is the unit of the drawing.
  Middle,
  /// The origin is the lower left corner of the viewBox, or of the box with the stated width and
  /// height. The unit is the millimetre if width or height has a physical unit (mm, cm, in, pt,
  /// pc). Otherwise the unit is the unit of the drawing.
  Corner,
};

/// Closed polygons in flat arrays. A shape is a list of rings. A ring is a list of points.
struct SvgDrawing {
  /// All points. The x-axis points to the right, and the y-axis points upwards. The origin depends
  /// on the frame.
  std::vector<Point2> points;
  /// For each point, the byte offset in the text at which its definition starts.
  std::vector<std::size_t> places;
  /// For each ring, the offset of its first point in `points`. The last entry is the size of
  /// `points`.
  std::vector<std::uint32_t> ring_begin = {0};
  /// For each shape, the index of its first ring. The last entry is the number of rings.
  std::vector<std::uint32_t> shape_begin = {0};
  /// For each shape, 1 if its fill rule is evenodd, and 0 if it is nonzero.
  std::vector<std::uint8_t> is_even_odd;
  std::vector<std::string> notes;  ///< Notes for a human reader that report skipped elements.

  std::size_t ring_count() const { return ring_begin.size() - 1; }    ///< Number of rings.
  std::size_t shape_count() const { return shape_begin.size() - 1; }  ///< Number of shapes.
  /// Returns the points of ring `r`. The ring has an edge from its last point to its first point.
  std::span<const Point2> ring(std::size_t r) const {
    return std::span(points).subspan(ring_begin[r], ring_begin[r + 1] - ring_begin[r]);
  }
};

/// Returns the drawing that `text` describes. `tolerance` is the largest allowed distance of a
/// curve from its chords, in units of the drawing. The tolerance must be positive. If `tolerance`
/// is not given, the tolerance is a thousandth of the larger side of the viewBox. In a drawing
/// without a viewBox, it is a thousandth of the larger of width and height. The memory of the
/// drawing stays charged to `context`. If the frame is SvgFrame::Corner, the tolerance is measured
/// in the unit of the result, not in units of the drawing.
///
/// Cost: O(bytes + points). Errors name their position in the text. The errors are:
///   - the errors of the scanner (svg_syntax.h)
///   - Syntax and NumberOutOfRange
///   - BadShape for a negative size, and for a curve in a drawing without a size if `tolerance` is
///     not given
///   - ResourceLimit and Cancelled
SvgDrawing read_svg(std::string_view text, const ReadOptions& options,
                    std::optional<double> tolerance, Context& context = unlimited_context(),
                    SvgFrame frame = SvgFrame::Middle);

}  // namespace plumb
#pragma GCC visibility pop
