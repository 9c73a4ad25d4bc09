// The lines and curves of a drawing, and how open curves are joined to rings, for the reader of
// DXF.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/plane/shape_text.h"
#include "plumb/io/read_options.h"
#include "plumb/io/svg/svg_outline.h"
#include "plumb/predicates/point.h"

namespace plumb {

/// The largest degree that programs give a spline.
inline constexpr std::uint32_t kMostSplineDegree = SvgOutline::kMostDegree;

/// The kind of a curve.
enum class DxfKind : std::uint8_t { Polyline, Arc, Spline };

/// A corner of a polyline, or a control point of a spline.
struct DxfVertex {
  Point2 p;
  /// Of a corner: the tangent of a quarter of the angle of the arc to the next corner.
  double bulge = 0;
  double weight = 1;  ///< The weight of a control point, which is positive.
};

/// A line or a curve, as it is stated.
struct DxfCurve {
  DxfKind kind = DxfKind::Polyline;
  bool is_closed = false;
  std::uint32_t first_vertex = 0, end_vertex = 0;  ///< The vertices of a polyline or a spline.
  std::uint32_t first_knot = 0, end_knot = 0;      ///< The knots of a spline.
  std::uint32_t degree = 3;  ///< The degree of a spline, from 1 to kMostSplineDegree.
  Point2 centre, u, v;       ///< Of an arc: centre + cos t u + sin t v.
  double from = 0, to = 0;   ///< Degrees, from < to; a closed arc has 360.
  std::uint32_t chords = 0;  ///< Of an arc: how many chords replace it; 0 if the tolerance decides.
  /// 0 for a line of the drawing. All curves of the border of a hatch have the number of the hatch.
  std::uint32_t area = 0;
  const char* where = nullptr;  ///< The place where the text states it.
  std::string_view layer = "0";
  SvgTransform transform;  ///< Maps coordinates of the curve to coordinates of the drawing.
};

/// The curves of a drawing, in flat arrays.
struct DxfCurves {
  std::vector<DxfCurve> curves;
  std::vector<DxfVertex> vertices;
  std::vector<double> knots;
};

/// Returns the larger side of a box that contains all curves.
double extent_of(const DxfCurves& drawing);

/// The rule by which the rings of a drawing become polygons.
struct DxfRingRules {
  bool is_one_polygon = true;       ///< Whether all rings of an area belong to one polygon.
  bool closes_open_chains = false;  ///< Whether a straight line closes an open chain, with a note.
};

/// Adds the rings of all curves to `shapes`, area by area. For this, it flattens the curves and
/// joins open curves. Errors: see read_dxf().
void add_dxf_rings(const DxfCurves& drawing, std::string_view text, const ReadOptions& options,
                   const DxfRingRules& rules, ShapeCollector& shapes, Context& context);

}  // namespace plumb
