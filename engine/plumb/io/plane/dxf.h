// Reads and writes drawings in DXF (docs/formats.md, "DXF"), the exchange format of programs that
// draw plans, as polygons.
//
// A drawing has lines and curves without width. Closed curves, and open curves that join to closed
// chains, are the rings of one polygon. The even-odd rule of all rings together decides which
// points they enclose, so a ring in a ring is a hole.
//
// Main flow of read_dxf():
//  1. records  reads pairs of a code and a value, and collects the curves of section ENTITIES,
//              and of the blocks that they insert (dxf_blocks.h)
//  2. flatten  replaces arcs, ellipses and splines by chords, which are at most the tolerance away
//              (svg_outline.h)
//  3. join     joins open curves at their ends. Ends that the file states join if they are equal,
//              or apart by at most 2^-40 of the largest coordinate. The end of an arc, an ellipse
//              or a spline is computed, and joins the nearest other end within the tolerance
//
// Curves: LINE, LWPOLYLINE, POLYLINE, ARC, CIRCLE, ELLIPSE, SPLINE of degree 1 to 25, also with
// weights. A SPLINE without control points is the cubic spline through its fit points (dxf_fit.h).
// Each HATCH is an area of its own, whose border consists of the same curves; areas unite.
// INSERT places blocks of them. Other entities are left out, and a note names them and the layers.
// Coordinates are read as the nearest doubles, and are not scaled: a note names the unit. Heights
// are dropped with a note.
//
// Cost: O(n log n) for n points, and O(1) for each pair of ends that are nearer than the tolerance.
// Errors have the place FILE:LINE: Syntax; NumberOutOfRange; CountMismatch for incomplete entities;
// BadShape for a chain that is not closed, for a block that contains itself, and for curves in a
// drawing without extent if no tolerance is given; UnknownFormat for binary DXF, for splines of
// higher degree, and for curves and inserts in other planes; ResourceLimit; Cancelled.
#pragma once

#include <iosfwd>
#include <optional>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/read_options.h"
#include "plumb/model/primitives.h"

namespace plumb {

/// Returns the polygon of a drawing, with notes. Under RingRule::Odd all rings belong to one
/// polygon, under another rule each ring is a polygon. The memory of the shapes stays charged to
/// `context`.
PlaneFile read_dxf(std::string_view text, const ReadOptions& options, Context& context);
/// The parts of a drawing that are read, and the way of reading them.
struct DxfSelection {
  std::string_view layer;  ///< The only layer that is read; all layers if it has no characters.
  /// Whether the drawing is read as OpenSCAD reads it: an open chain is closed by a straight line,
  /// with a note, and hatches are left out.
  bool as_openscad = false;
  /// How OpenSCAD divides circles, arcs and ellipses, and the scale of their radii. Without a value
  /// the tolerance says how.
  std::optional<CircleDivision> division = {};
  double scale = 1;
};
/// Returns the polygon of the selected parts of a drawing.
PlaneFile read_dxf_selection(std::string_view text, const DxfSelection& selection,
                             const ReadOptions& options, Context& context);
/// Returns the set of this polygon.
PlaneRead read_dxf_set(std::string_view text, const DxfSelection& selection,
                       const ReadOptions& options, Context& context);

/// Whether a text begins like a drawing: with a comment or with the begin of a section.
bool begins_like_dxf(std::string_view text);

/// Writes a closed LWPOLYLINE for each ring, on layer 0. Lines and points are not written. Numbers
/// are the nearest doubles, as in format_double(). Throws the exceptions of `out` and the errors of
/// the Context.
void write_dxf(std::ostream& out, const PlaneShapes& shapes, Context& context);

}  // namespace plumb
