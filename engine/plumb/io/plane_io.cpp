// Sets of the plane from shapes and back, and files of them.
//
// A polygon with rings means the even-odd rule of its own rings, and shapes unite. Sweeping every
// polygon on its own and uniting the results would be slow, so rings are first looked at once per
// polygon (RingSides): if they meet at corners only and each keeps the polygon on one side, all
// rings are wound so that the polygon is on their left, and one sweep over all polygons with the
// rule Positive gives the union. Polygons that cross themselves are made sets of their own. Under
// the other rules all rings of a file go into one sweep.
//
// In the other direction, PlaneText rounds the set as a subdivision (plane_rounding.h), so that its
// parts are valid shapes of doubles, and reports what was lost. Formats: docs/formats.md, section
// Sets of the plane.
// Tested by tests/io/plane_io_test.cpp.
#include "plumb/io/plane_io.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <ostream>
#include <utility>

#include "plumb/io/layer_io.h"
#include "plumb/io/plane/dxf.h"
#include "plumb/io/plane/geojson.h"
#include "plumb/io/plane/nef2_format.h"
#include "plumb/io/plane/wkb.h"
#include "plumb/io/plane/wkt.h"
#include "plumb/io/svg_reader.h"
#include "plumb/io/text/charged_input.h"
#include "plumb/io/text/files.h"
#include "plumb/io/text/foreign_files.h"
#include "plumb/io/text/text_output.h"
#include "plumb/plane/sweep/sweep.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::uint32_t kPointsPerCheckpoint = 1024;

void copy_point(const PointTable2& from, std::uint32_t i, PointTable2& to) {
  if (from.is_double(i)) return to.push_back(from.approx(i));
  const RationalPoint2 p = from.exact(i);
  to.push_back(p.x, p.y);
}

/// Returns polygon p with a separate table of points, because the cost of a sweep depends on its
/// table.
PlaneShapes single_polygon(const PlaneShapes& shapes, std::size_t p) {
  PlaneShapes alone;
  for (std::uint32_t r = shapes.polygon_begin[p]; r < shapes.polygon_begin[p + 1]; ++r) {
    for (const std::uint32_t corner : shapes.ring(r)) {
      alone.ring_corners.push_back(static_cast<std::uint32_t>(alone.points.size()));
      copy_point(shapes.points, corner, alone.points);
    }
    alone.end_ring();
  }
  alone.end_polygon();
  return alone;
}

Nef2 by_rule(const PlaneShapes& shapes, WindingRule rule, Context& context) {
  return Nef2::polygons(shapes.points, shapes.ring_corners, shapes.ring_begin, rule,
                        Boundary::Closed, context);
}

/// The side of a ring on which its polygon lies.
enum class RingSide : std::uint8_t { Left, Right };

/// Sweeps the rings of one polygon. As long as they meet at corners only, the even-odd rule gives
/// each edge a side on which the polygon lies; rings that keep it on one side all the way can be
/// wound so that their winding numbers are 1 inside and 0 outside.
class RingSides : private SweepVisitor {
 public:
  /// Returns the side for every ring, or nothing if rings cross, overlap or change sides.
  static std::vector<RingSide> find(const PlaneShapes& polygon, Context& context) {
    return RingSides(polygon).run(context);
  }

 private:
  explicit RingSides(const PlaneShapes& polygon) : polygon_(polygon) {}
  std::vector<RingSide> run(Context& context);
  void collect_edges();
  bool on_event(const SweepEvent& event) override;
  bool is_corner(const SweepEvent& event);
  std::vector<RingSide> sides_of_rings() const;

  struct Edge {
    std::uint32_t ring;
    bool goes_right;  ///< Whether it runs from its lesser to its greater end.
  };

  const PlaneShapes& polygon_;
  std::vector<SweepSegment> segments_;
  std::vector<Edge> edges_;  ///< Edge of each of segments_.
  /// Whether the polygon lies above each of the segments_ that have been met so far.
  IdVector<SegmentId, char> inside_above_;
  bool crossed_ = false;
};

std::vector<RingSide> RingSides::run(Context& context) {
  collect_edges();
  sweep(polygon_.points, segments_, *this, context);
  return crossed_ ? std::vector<RingSide>() : sides_of_rings();
}

void RingSides::collect_edges() {
  for (std::uint32_t r = 0; r < polygon_.ring_count(); ++r) {
    const auto ring = polygon_.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const SweepSegment segment{ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]};
      const Sign order = compare_xy(polygon_.points, segment.from, segment.to);
      if (order == Sign::Zero) continue;  // The corner is repeated.
      segments_.push_back(segment);
      edges_.push_back({r, order == Sign::Negative});
    }
  }
  inside_above_.resize(segments_.size());
}

bool RingSides::on_event(const SweepEvent& event) {
  if (!is_corner(event)) {
    crossed_ = true;
    return false;
  }
  bool inside = event.below.is_valid() && inside_above_[event.below] != 0;
  for (const SegmentId edge : event.outgoing) {
    inside = !inside;
    inside_above_[edge] = inside ? 1 : 0;
  }
  return true;
}

/// Whether every edge at this place starts or ends here, and no edge lies on another edge.
bool RingSides::is_corner(const SweepEvent& event) {
  return !event.points.empty() && event.has_ends_only();
}

std::vector<RingSide> RingSides::sides_of_rings() const {
  std::vector<RingSide> sides(polygon_.ring_count(), RingSide::Left);
  std::vector<char> known(polygon_.ring_count());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto [ring, goes_right] = edges_[e];
    const RingSide side = goes_right == (inside_above_[e] != 0) ? RingSide::Left : RingSide::Right;
    if (known[ring] != 0 && sides[ring] != side) return {};
    known[ring] = 1;
    sides[ring] = side;
  }
  return sides;
}

/// Appends the rings of polygon p, with directions such that the polygon lies on their left.
void append_wound(const PlaneShapes& shapes, std::size_t p, const std::vector<RingSide>& sides,
                  PlaneShapes& to) {
  for (std::uint32_t r = shapes.polygon_begin[p]; r < shapes.polygon_begin[p + 1]; ++r) {
    const auto ring = shapes.ring(r);
    if (sides[r - shapes.polygon_begin[p]] == RingSide::Left) {
      to.ring_corners.insert(to.ring_corners.end(), ring.begin(), ring.end());
    } else {
      to.ring_corners.insert(to.ring_corners.end(), ring.rbegin(), ring.rend());
    }
    to.end_ring();
  }
}

void reverse_ring(PlaneShapes& shapes, std::size_t r) {
  std::reverse(shapes.ring_corners.begin() + shapes.ring_begin[r],
               shapes.ring_corners.begin() + shapes.ring_begin[r + 1]);
}

/// Reverses holes that have the same direction as the outer ring of their polygon.
PlaneShapes with_turned_holes(PlaneShapes shapes) {
  for (std::size_t p = 0; p < shapes.polygon_count(); ++p) {
    const std::uint32_t outer = shapes.polygon_begin[p];
    const std::uint32_t end = shapes.polygon_begin[p + 1];
    if (end - outer < 2) continue;
    const Sign way = polygon_area_sign(shapes.points, shapes.ring(outer));
    for (std::uint32_t r = outer + 1; r < end; ++r) {
      const Sign hole = polygon_area_sign(shapes.points, shapes.ring(r));
      if (hole == way) reverse_ring(shapes, r);
    }
  }
  return shapes;
}

/// Whether a note should state that a rule other than the even-odd rule gives a set that differs
/// from `odd`. This is the case if the holes of a polygon overlap or lie outside of it, or if the
/// polygon is empty. One ring that crosses itself, such as a star, is drawn so on purpose.
bool is_ambiguous(const PlaneShapes& polygon, const Nef2& odd, Context& context) {
  PlaneShapes turned = with_turned_holes(polygon);
  if (turned.ring_count() == 1) {
    return odd.counts().faces < 2 && by_rule(turned, WindingRule::NonZero, context) != odd;
  }
  if (polygon_area_sign(turned.points, turned.ring(0)) == Sign::Negative) {
    for (std::size_t r = 0; r < turned.ring_count(); ++r) reverse_ring(turned, r);
  }
  return by_rule(turned, WindingRule::Positive, context) != odd;
}

/// The set of some polygons.
struct SetOfPolygons {
  std::vector<Nef2> sets;     ///< Its parts.
  std::size_t ambiguous = 0;  ///< Number of polygons for which the choice of the rule matters.
};

void add_polygons(const PlaneShapes& shapes, SetOfPolygons& result, Context& context) {
  std::vector<Nef2>& sets = result.sets;
  PlaneShapes wound;
  for (std::size_t p = 0; p < shapes.polygon_count(); ++p) {
    const PlaneShapes alone = single_polygon(shapes, p);
    const std::vector<RingSide> sides = RingSides::find(alone, context);
    if (sides.empty()) {
      sets.push_back(by_rule(alone, WindingRule::EvenOdd, context));
      if (is_ambiguous(alone, sets.back(), context)) ++result.ambiguous;
    } else {
      append_wound(shapes, p, sides, wound);
    }
  }
  if (wound.ring_count() == 0) return;
  sets.push_back(Nef2::polygons(shapes.points, wound.ring_corners, wound.ring_begin,
                                WindingRule::Positive, Boundary::Closed, context));
}

/// Adds lines and points. A point is a line with one corner.
void add_lines(const PlaneShapes& shapes, std::vector<Nef2>& sets, Context& context) {
  if (shapes.line_count() == 0 && shapes.single_points.empty()) return;
  std::vector<std::uint32_t> corners = shapes.line_corners;
  std::vector<std::uint32_t> begin = shapes.line_begin;
  for (const std::uint32_t point : shapes.single_points) {
    corners.push_back(point);
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  sets.push_back(Nef2::polylines(shapes.points, corners, begin, context));
}

class ShapesOfParts {
 public:
  explicit ShapesOfParts(Context& context) : context_(context) {}

  PlaneShapes convert(const PlaneParts& parts) {
    for (const PolygonWithHoles2& polygon : parts.polygons) {
      add_ring(polygon.outer);
      for (const auto& hole : polygon.holes) add_ring(hole);
      shapes_.end_polygon();
    }
    for (const auto& line : parts.lines) {
      for (const RationalPoint2& point : line) shapes_.line_corners.push_back(add_point(point));
      shapes_.end_line();
    }
    for (const RationalPoint2& point : parts.points) {
      shapes_.single_points.push_back(add_point(point));
    }
    return std::move(shapes_);
  }

 private:
  std::uint32_t add_point(const RationalPoint2& p) {
    if (shapes_.points.size() % kPointsPerCheckpoint == 0) context_.checkpoint("shapes", 0, 1);
    shapes_.points.push_back(p.x, p.y);
    return static_cast<std::uint32_t>(shapes_.points.size() - 1);
  }
  void add_ring(const std::vector<RationalPoint2>& ring) {
    for (const RationalPoint2& point : ring) shapes_.ring_corners.push_back(add_point(point));
    shapes_.end_ring();
  }

  Context& context_;
  PlaneShapes shapes_;
};

/// Throws if the exact value exceeds all doubles. In a table, the approximation is clamped where
/// the nearest double is infinite.
void require_finite(double approx, const Rational& exact) {
  const bool is_largest = std::fabs(approx) == std::numeric_limits<double>::max();
  if (!is_largest || std::isfinite(nearest_double(exact))) return;
  throw Error(ErrorCode::NumberOutOfRange,
              "a coordinate lies beyond the largest double; .nef2 can hold it");
}

}  // namespace

namespace {

/// Returns the set of all shapes as parts.
SetOfPolygons parts_of(const PlaneShapes& shapes, RingRule rule, Context& context) {
  SetOfPolygons result;
  if (rule == RingRule::Odd) {
    add_polygons(shapes, result, context);
  } else {
    PlaneShapes turned = with_turned_holes(shapes);
    for (std::size_t r = 0; rule == RingRule::Negative && r < turned.ring_count(); ++r) {
      reverse_ring(turned, r);
    }
    const bool is_signed = rule != RingRule::NonZero;
    result.sets.push_back(
        by_rule(turned, is_signed ? WindingRule::Positive : WindingRule::NonZero, context));
  }
  add_lines(shapes, result.sets, context);
  return result;
}

Nef2 united(const std::vector<Nef2>& sets, Context& context) {
  return sets.size() == 1 ? sets.front() : union_of(sets, context);
}

}  // namespace

Nef2 to_set(const PlaneShapes& shapes, RingRule rule, Context& context) {
  return united(parts_of(shapes, rule, context).sets, context);
}

Nef2 to_set(const PlaneShapes& shapes, Context& context) {
  return to_set(shapes, RingRule::Odd, context);
}

PlaneShapes to_shapes(const PlaneParts& parts, Context& context) {
  return ShapesOfParts(context).convert(parts);
}

PlaneShapes with_nearest_doubles(PlaneShapes shapes, Context& context) {
  if (shapes.points.all_double()) return shapes;
  PointTable2 doubles;
  doubles.reserve(shapes.points.size());
  for (std::uint32_t i = 0; i < shapes.points.size(); ++i) {
    if (i % kPointsPerCheckpoint == 0) context.checkpoint("round", i, shapes.points.size());
    const Point2 p = shapes.points.approx(i);
    if (!shapes.points.is_double(i)) {
      const RationalPoint2 exact = shapes.points.exact(i);
      require_finite(p.x, exact.x);
      require_finite(p.y, exact.y);
    }
    doubles.push_back(p);
  }
  shapes.points = std::move(doubles);
  return shapes;
}

std::optional<PlaneFormat> plane_format_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  if (extension == ".wkt") return PlaneFormat::Wkt;
  if (extension == ".geojson" || extension == ".json") return PlaneFormat::GeoJson;
  if (extension == ".nef2") return PlaneFormat::Nef2;
  if (extension == ".wkb") return PlaneFormat::Wkb;
  if (extension == ".dxf") return PlaneFormat::Dxf;
  if (extension == ".svg") return PlaneFormat::Svg;
  return {};
}

PlaneFormat guess_plane_format(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (begins_like_wkb(text)) return PlaneFormat::Wkb;
  if (begins_like_dxf(text)) return PlaneFormat::Dxf;
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  // Record separators are between values of JSON (RFC 8142).
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n\x1e"), text.size()));
  if (text.starts_with('{') || text.starts_with('[')) return PlaneFormat::GeoJson;
  // WKT may begin with the name of a reference system: "<http://...>".
  for (const std::string_view begin : {"<svg", "<?xml", "<!"}) {
    if (text.starts_with(begin)) return PlaneFormat::Svg;
  }
  return text.starts_with("plumb-") ? PlaneFormat::Nef2 : PlaneFormat::Wkt;
}

PlaneFormat plane_format_of(const std::string& path, std::string_view text) {
  const std::optional<PlaneFormat> named = plane_format_of(path);
  return named ? *named : guess_plane_format(text);
}

namespace {

std::string_view rule_name(RingRule rule) {
  switch (rule) {
    case RingRule::NonZero:
      return "nonzero";
    case RingRule::Positive:
      return "positive";
    case RingRule::Negative:
      return "negative";
    default:
      return "odd";
  }
}

/// States that a file is the empty set: in a note if all its geometries are empty and there are no
/// other notes, and otherwise in a warning.
void note_emptiness(bool has_shapes, RingRule rule, PlaneRead& read) {
  if (!has_shapes) {
    const bool has_other_contents = !read.notes.empty();
    (has_other_contents ? read.warnings : read.notes)
        .emplace_back("the file has no point, line or polygon, so the set is empty");
  } else if (read.set.is_empty()) {
    read.warnings.emplace_back("the rings of the file enclose nothing by the rule \"" +
                               std::string(rule_name(rule)) + "\", so the set is empty");
  }
}

/// Makes a set of shapes. If the set is empty, a note or a warning states this.
PlaneRead set_of(PlaneFile file, RingRule rule, Context& context) {
  const SetOfPolygons parts = parts_of(file.shapes, rule, context);
  PlaneRead read{united(parts.sets, context), std::move(file.notes), {}};
  if (parts.ambiguous != 0) {
    const std::size_t polygons = file.shapes.polygon_count();
    const std::string which = polygons == 1 ? "the polygon"
                                            : std::to_string(parts.ambiguous) + " of " +
                                                  std::to_string(polygons) + " polygons";
    read.notes.push_back("the rings of " + which +
                         " overlap; the even-odd rule decided what they enclose");
  }
  note_emptiness(!file.shapes.empty(), rule, read);
  return read;
}

/// Returns shape `s` of a drawing. Rings of fewer than three points enclose nothing.
PlaneShapes shape_of(const SvgDrawing& drawing, std::size_t s) {
  constexpr std::size_t kFewest = 3;
  PlaneShapes shape;
  for (std::uint32_t r = drawing.shape_begin[s]; r < drawing.shape_begin[s + 1]; ++r) {
    if (drawing.ring(r).size() < kFewest) continue;
    for (const Point2& p : drawing.ring(r)) {
      shape.ring_corners.push_back(static_cast<std::uint32_t>(shape.points.size()));
      shape.points.push_back({p.x + 0.0, p.y + 0.0});
    }
    shape.end_ring();
  }
  return shape;
}

/// Returns the winding rule for one shape. It is the rule of the shape, unless the caller has a
/// different rule.
WindingRule rule_of_shape(bool is_even_odd) {
  return is_even_odd ? WindingRule::EvenOdd : WindingRule::NonZero;
}

/// Makes a set of a drawing: the union of its shapes or, if the caller has a different rule, the
/// result of this rule for all rings together.
PlaneRead set_of_drawing(SvgDrawing drawing, RingRule rule, Context& context) {
  std::vector<Nef2> sets;
  PlaneShapes all;
  for (std::size_t s = 0; s < drawing.shape_count(); ++s) {
    const PlaneShapes shape = shape_of(drawing, s);
    if (rule == RingRule::Odd) {
      sets.push_back(by_rule(shape, rule_of_shape(drawing.is_even_odd[s] != 0), context));
      continue;
    }
    const auto first = static_cast<std::uint32_t>(all.points.size());
    for (std::uint32_t i = 0; i < shape.points.size(); ++i) copy_point(shape.points, i, all.points);
    for (std::size_t r = 0; r < shape.ring_count(); ++r) {
      for (const std::uint32_t corner : shape.ring(r)) all.ring_corners.push_back(first + corner);
      all.end_ring();
      all.end_polygon();
    }
  }
  PlaneRead read{rule == RingRule::Odd ? union_of(sets, context) : to_set(all, rule, context),
                 std::move(drawing.notes)};
  note_emptiness(drawing.ring_count() > 0, rule, read);
  return read;
}

}  // namespace

PlaneRead read_dxf_set(std::string_view text, const DxfSelection& selection,
                       const ReadOptions& options, Context& context) {
  return set_of(read_dxf_selection(text, selection, options, context), options.rings, context);
}

namespace {

/// Returns the name of the format in foreign_files.h.
std::string_view kind_of(PlaneFormat format) {
  switch (format) {
    case PlaneFormat::Nef2:
      return "nef2";
    case PlaneFormat::GeoJson:
      return "GeoJSON";
    case PlaneFormat::Dxf:
      return "DXF";
    case PlaneFormat::Svg:
      return "SVG";
    case PlaneFormat::Wkb:
      return "WKT WKB";
    default:
      return "WKT";
  }
}

PlaneRead read_plane_set_as(std::string_view text, PlaneFormat format, const ReadOptions& options,
                            Context& context) {
  switch (format) {
    case PlaneFormat::Nef2:
      return {read_nef2(text, options, context), {}};
    case PlaneFormat::GeoJson:
      return set_of(read_geojson(text, options, context), options.rings, context);
    case PlaneFormat::Wkb:
      return set_of(read_wkb(text, options, context), options.rings, context);
    case PlaneFormat::Dxf:
      return set_of(read_dxf(text, options, context), options.rings, context);
    case PlaneFormat::Svg:
      return set_of_drawing(
          read_svg(text, options, options.curve_tolerance, context, SvgFrame::Corner),
          options.rings, context);
    default:
      return set_of(read_wkt(text, options, context), options.rings, context);
  }
}

}  // namespace

PlaneRead read_plane_set(std::string_view text, PlaneFormat format, const ReadOptions& options,
                         Context& context) {
  return naming_foreign_files(text, kind_of(format), options.name,
                              [&] { return read_plane_set_as(text, format, options, context); });
}

namespace {

/// Reads the set of all features of a layer.
PlaneRead read_plane_set_by_gdal(const std::string& path, const ReadOptions& options,
                                 Context& context) {
  const LayerText input = read_layer_text(path, {}, context);
  PlaneRead read = read_plane_set(input.text, PlaneFormat::GeoJson, options, context);
  read.notes.insert(read.notes.begin(), input.notes.begin(), input.notes.end());
  context.release_memory(input.text.size());
  return read;
}

}  // namespace

PlaneRead read_plane_set_file(const std::string& path, std::optional<PlaneFormat> format,
                              ReadOptions options, Context& context) {
  options.name = input_name(path);
  if (!format && is_read_by_gdal(path)) return read_plane_set_by_gdal(path, options, context);
  const ChargedInput input(path, context);
  if (!format) format = plane_format_of(path, input.bytes());
  return read_plane_set(input.bytes(), *format, options, context);
}

std::string PlaneLosses::closing() const {
  return open ? "the set is not closed; its closure was written (.nef2 keeps marks)" : "";
}

namespace {

/// Returns the parts of a sentence as "a, b and c".
std::string joined_by_and(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ";
    text += parts[i];
  }
  return text;
}

/// Returns a description of the effect of rounding, such as "1 face was left out and 2 vertices
/// were merged".
std::string changes_of(const PlaneRoundingReport& report, bool tells_moves) {
  std::vector<std::string> parts;
  const auto add = [&parts](std::size_t count, const char* one, const char* many,
                            const char* what) {
    if (count == 0) return;
    const bool is_one = count == 1;
    parts.push_back(std::to_string(count) + ' ' + (is_one ? one : many) +
                    (is_one ? " was " : " were ") + what);
  };
  add(report.collapsed, "face", "faces", "left out");
  add(report.edges_folded, "folded piece of an edge", "folded pieces of edges", "left out");
  add(report.vertices_merged, "vertex", "vertices", "merged with others");
  add(report.edges_bent, "edge", "edges", "bent");
  if (tells_moves) add(report.vertices_moved, "vertex", "vertices", "moved further");
  return joined_by_and(parts);
}

}  // namespace

bool is_reshaped(const PlaneRoundingReport& report, const PlaneWriteOptions& options) {
  PlaneRoundingReport changes = report;
  if (options.grid) changes.vertices_moved = 0;
  return changes.is_changed();
}

std::string rounding_sentence(const PlaneRoundingReport& report, const PlaneWriteOptions& options) {
  if (!is_reshaped(report, options)) return "";
  const std::string changes = changes_of(report, !options.grid);
  if (!options.grid && options.rounding == OutputRounding::Nearest) {
    return "the nearest doubles are not a valid shape, and nothing was repaired; a repair changes "
           "the shape: " +
           changes;
  }
  return "rounding to " + std::string(options.grid ? "the grid" : "doubles") +
         " changed the shape: " + changes + "; no point moved by more than " +
         format_double(report.largest_move);
}

std::vector<std::string> PlaneLosses::sentences() const {
  std::vector<std::string> list;
  if (unbounded) list.push_back("unbounded parts were left out; unbounded sets need .nef2");
  if (thin) list.push_back("lines and points were left out; DXF holds areas only");
  if (filled) {
    list.push_back("points that are missing inside the set were filled (.nef2 keeps marks)");
  }
  if (is_reshaped()) {
    list.push_back(rounding_sentence(rounding, options) + " (.nef2 is exact)");
  }
  return list;
}

PlaneText::PlaneText(const Nef2& set, PlaneFormat format, const PlaneWriteOptions& options,
                     Context& context)
    : set_(set), format_(format) {
  losses_.options = options;
  if (format == PlaneFormat::Nef2) return;
  if (format == PlaneFormat::Svg) {
    throw Error(ErrorCode::UnknownFormat, "SVG can be read but not written");
  }
  losses_.unbounded = !set.is_bounded();
  losses_.open = !set.is_closed();
  losses_.filled = closure_fills_inside(set);
  const RoundedSet rounded =
      options.grid ? round_to_grid(set, *options.grid, context) : round_to_doubles(set, context);
  losses_.rounding = rounded.report;
  const bool is_raw = !options.grid && options.rounding == OutputRounding::Nearest;
  shapes_ = to_shapes((is_raw ? set : rounded.set).parts(context), context);
  const bool is_thin = shapes_.line_count() > 0 || !shapes_.single_points.empty();
  losses_.thin = format == PlaneFormat::Dxf && is_thin;
  if (is_raw) shapes_ = with_nearest_doubles(std::move(shapes_), context);
}

void PlaneText::write(std::ostream& out, Context& context) const {
  switch (format_) {
    case PlaneFormat::Nef2:
      return write_nef2(out, set_.complex(), context);
    case PlaneFormat::GeoJson:
      return write_geojson(out, shapes_, context);
    case PlaneFormat::Wkb:
      return write_wkb(out, shapes_, context);
    case PlaneFormat::Dxf:
      return write_dxf(out, shapes_, context);
    default:
      return write_wkt(out, shapes_, context);
  }
}

}  // namespace plumb
