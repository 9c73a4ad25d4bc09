// Reading of DXF: pairs of lines, and the entities that they describe; and the writer.
//
// A pair is a line with a code, which says what the next line means. Code 0 begins an entity, and
// the values up to the next code 0 belong to it. A POLYLINE is followed by entities VERTEX and ends
// with SEQEND. Values are stored as they are read, and the entity is made at its end, so their
// order does not matter, except that the values of a corner belong together. In a HATCH, the order
// of all values matters, so HatchParser reads them one after the other.
//
// Format: Autodesk, DXF Reference (AutoCAD 2012); docs/formats.md, section DXF.
// Tested by tests/io/dxf_test.cpp.
#include "plumb/io/plane/dxf.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <ostream>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "plumb/base/internal/degrees.h"
#include "plumb/io/plane/dxf_blocks.h"
#include "plumb/io/plane/dxf_curves.h"
#include "plumb/io/plane/dxf_fit.h"
#include "plumb/io/plane/shape_text.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/arithmetic/elementary.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::string_view kDxfBlanks = " \t\r";

std::string_view trimmed(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(kDxfBlanks), line.size()));
  return line.substr(0, line.find_last_not_of(kDxfBlanks) + 1);
}

/// The affine map of a plane that is seen from below.
constexpr SvgTransform kFromBelow{-1, 0, 0, 1, 0, 0};

/// The units that the values of $INSUNITS denote.
constexpr std::array<const char*, 7> kDxfUnits{"",           "inch",       "foot", "mile",
                                               "millimetre", "centimetre", "metre"};

class DxfReader {
 public:
  DxfReader(std::string_view text, const DxfSelection& selection, const ReadOptions& options,
            Context& context)
      : text_(text),
        rest_(text),
        selection_(selection),
        only_layer_(selection.layer),
        options_(options),
        numbers_(context, false, text.size()),
        context_(context),
        charge_(context) {}

  PlaneFile read() {
    if (text_.starts_with("AutoCAD Binary DXF")) {
      fail(ErrorCode::UnknownFormat, "binary DXF; save the drawing as text (ASCII DXF)");
    }
    while (next_pair()) take_pair();
    if (!has_end_) fail(ErrorCode::CountMismatch, "the drawing ends without EOF");
    content_.drawing.end_curve = static_cast<std::uint32_t>(content_.curves.curves.size());
    content_.drawing.end_insert = static_cast<std::uint32_t>(content_.inserts.size());
    read_blocks();
    content_.curves.curves = placed_curves(content_, only_layer_, options_.name, charge_, context_);
    note_layers();
    ShapeCollector shapes(context_, text_.size());
    const DxfRingRules rules{options_.rings == RingRule::Odd, selection_.as_openscad};
    add_dxf_rings(content_.curves, text_, options_, rules, shapes, context_);
    add_notes(shapes);
    return shapes.take();
  }

 private:
  /// A value of the current entity.
  struct Value {
    int code;
    double number;
  };

  void note_layers() {
    constexpr std::size_t kCurvesPerCheckpoint = 4096;
    const std::vector<DxfCurve>& curves = content_.curves.curves;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      if (c % kCurvesPerCheckpoint == 0) context_.checkpoint("layers", c, curves.size());
      layers_.insert(std::string(curves[c].layer));
    }
  }

  // ---------------------------------------------------------------- pairs

  /// Returns the next line and moves the position behind it.
  std::string_view take_line() {
    ++line_;
    const std::size_t end = rest_.find('\n');
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
    return line;
  }

  /// Reads the next pair. Returns false at the end of the drawing.
  bool next_pair() {
    constexpr std::size_t kPairsPerCheckpoint = 4096;
    if (has_end_) return false;
    if (pairs_++ % kPairsPerCheckpoint == 0) {
      context_.checkpoint("read", text_.size() - rest_.size(), text_.size());
    }
    where_ = rest_.data();
    if (rest_.find_first_not_of(" \t\r\n") == rest_.npos) return false;
    const std::string_view code = trimmed(take_line());
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), code_);
    if (error != std::errc() || end != code.data() + code.size()) {
      fail(ErrorCode::Syntax, "expected the code of a group, found " + quoted(code));
    }
    if (rest_.empty()) fail(ErrorCode::CountMismatch, "the value of the last group is missing");
    value_ = trimmed(take_line());
    return true;
  }

  double number() {
    ReadNumber number;
    try {
      TextCursor cursor(value_, {}, &context_);
      if (!cursor.next_line()) throw Error(ErrorCode::Syntax, "a number is missing");
      numbers_.read(cursor, cursor.token(), number);
    } catch (const Error& error) {
      fail(error.code(), error.message());
    }
    return number.is_double() ? number.as_double() : nearest_double(number.exact());
  }

  void take_pair() {
    if (code_ == 0) return begin_entity();
    if (section_.empty() && code_ == 2 && entity_ == "SECTION") {
      section_ = value_;
      return;
    }
    if (section_ == "HEADER") return take_variable();
    if (section_ == "BLOCKS" && entity_ == "BLOCK" && code_ == 2) {
      constexpr std::uint64_t kBlockBytes = 256;  // The memory of the nodes of two maps.
      with_line([&] { charge_.add(kBlockBytes, "the drawing"); });
      block_places_.insert({value_, {block_rest_, block_line_}});
    }
    if (section_ == "ENTITIES") take_value();
  }

  void take_variable() {
    if (code_ == 9) variable_ = value_;
    if (code_ == 70 && variable_ == "$INSUNITS") unit_ = number();
  }

  /// Stores a value of the current entity, if an entity that is read may need it.
  void take_value() {
    constexpr std::uint64_t kStep = 4096;
    if (code_ == 8) layer_ = value_;
    if (code_ == 2) name_ = value_;
    const bool is_count = code_ >= 91 && code_ < 98 && entity_ == "HATCH";
    const bool is_number = (code_ >= 10 && code_ < 80) || (code_ >= 210 && code_ < 240) || is_count;
    if (!is_read_ || !is_number) return;
    if (values_.size() == charged_values_) {
      with_line([&] { charge_.add(2 * kStep * sizeof(Value), "the drawing"); });
      charged_values_ += kStep;
    }
    values_.push_back({code_, number()});
  }

  // ---------------------------------------------------------------- entities

  void begin_entity() {
    close_entity();
    if (value_ == "BLOCK") {
      block_rest_ = rest_;
      block_line_ = line_;
    }
    entity_ = value_;
    values_.clear();
    layer_ = "0";
    name_ = {};
    entity_where_ = where_;
    entity_line_ = line_ - 1;
    if (entity_ == "ENDSEC" || entity_ == "SECTION") section_ = {};
    if (entity_ == "EOF") has_end_ = true;
    const bool is_filled =
        entity_ == "HATCH" || entity_ == "SOLID" || entity_ == "TRACE" || entity_ == "3DFACE";
    is_read_ = section_ == "ENTITIES" && maker_of(entity_) != nullptr &&
               !(is_filled && selection_.as_openscad);
    if (section_ == "ENTITIES" && !is_read_) skipped_.insert({entity_, 0}).first->second += 1;
  }

  /// Ends the entity before the entity that the current pair begins.
  void close_entity() {
    if (section_ == "ENTITIES") end_entity();
    if (is_in_polyline_ && value_ != "VERTEX" && value_ != "SEQEND") {
      fail(ErrorCode::CountMismatch, "a POLYLINE ends without SEQEND");
    }
  }

  using Maker = void (DxfReader::*)();
  static Maker maker_of(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, Maker>, 15> kMakers{{
        {"LINE", &DxfReader::make_line},
        {"LWPOLYLINE", &DxfReader::make_polyline},
        {"POLYLINE", &DxfReader::begin_polyline},
        {"VERTEX", &DxfReader::add_vertex},
        {"SEQEND", &DxfReader::end_polyline},
        {"ARC", &DxfReader::make_arc},
        {"CIRCLE", &DxfReader::make_arc},
        {"ELLIPSE", &DxfReader::make_ellipse},
        {"SPLINE", &DxfReader::make_spline},
        {"HATCH", &DxfReader::make_hatch},
        {"SOLID", &DxfReader::make_solid},
        {"TRACE", &DxfReader::make_solid},
        {"3DFACE", &DxfReader::make_face},
        {"INSERT", &DxfReader::make_insert},
        {"BLOCK", &DxfReader::set_base},
    }};
    const auto* const found = std::find_if(kMakers.begin(), kMakers.end(),
                                           [&](const auto& each) { return each.first == name; });
    return found == kMakers.end() ? nullptr : found->second;
  }

  void end_entity() {
    if (!is_read_) return;
    is_read_ = false;
    // The vertices of a POLYLINE are on the layer of the POLYLINE, even if they state a different
    // layer.
    const bool is_part = entity_ == "VERTEX" || entity_ == "SEQEND";
    // The layer of an entity in a block, or of an insert, may depend on the inserts of the block.
    const bool is_placed_later = block_ != nullptr || entity_ == "INSERT";
    if (!only_layer_.empty() && layer_ != only_layer_ && !is_part && !is_placed_later) return;
    if (value(67, 0) == 1) {
      skipped_.insert({"entities of paper space", 0}).first->second += 1;
      return;
    }
    for (const Value& each : values_) {
      has_heights_ |= ((each.code >= 30 && each.code <= 33) || each.code == 38) && each.number != 0;
    }
    (this->*maker_of(entity_))();
  }

  /// Returns the first value with a code.
  double value(int code, double otherwise) const {
    const auto found = std::find_if(values_.begin(), values_.end(),
                                    [&](const Value& each) { return each.code == code; });
    return found == values_.end() ? otherwise : found->number;
  }
  double required(int code) const {
    const auto found = std::find_if(values_.begin(), values_.end(),
                                    [&](const Value& each) { return each.code == code; });
    if (found == values_.end()) {
      fail_entity(ErrorCode::CountMismatch, "lacks a value with the code " + std::to_string(code));
    }
    return found->number;
  }
  bool has(int code) const {
    return std::any_of(values_.begin(), values_.end(),
                       [&](const Value& each) { return each.code == code; });
  }
  Point2 required_point(int code) const { return {required(code), required(code + 10)}; }
  bool has_flag(unsigned flag) const {
    const double flags = value(70, 0);
    return flags >= 0 && flags < 65536 && (static_cast<unsigned>(flags) & flag) != 0;
  }

  DxfCurve new_curve(DxfKind kind) const {
    DxfCurve curve;
    curve.kind = kind;
    curve.where = entity_where_;
    curve.layer = layer_;
    curve.first_vertex = curve.end_vertex =
        static_cast<std::uint32_t>(content_.curves.vertices.size());
    return curve;
  }

  /// Whether the plane of the entity is the plane of the drawing seen from below.
  bool is_seen_from_below() const {
    const double x = value(210, 0), y = value(220, 0), z = value(230, 1);
    if (x != 0 || y != 0 || z == 0) {
      fail_entity(ErrorCode::UnknownFormat, "lies in another plane than the drawing");
    }
    return z < 0;
  }

  void push_curve(DxfCurve curve) {
    with_line([&] { charge_.add(2 * sizeof(DxfCurve), "the drawing"); });
    curve.end_vertex = static_cast<std::uint32_t>(content_.curves.vertices.size());
    content_.curves.curves.push_back(curve);
  }

  void push_vertex(Point2 p, double bulge) {
    with_line([&] { charge_.add(2 * sizeof(DxfVertex), "the drawing"); });
    content_.curves.vertices.push_back({p, bulge});
  }

  void make_line() {
    const DxfCurve curve = new_curve(DxfKind::Polyline);
    const Point2 from = required_point(10), to = required_point(11);
    if (from == to) return;  // A line without length is skipped.
    push_vertex(from, 0);
    push_vertex(to, 0);
    push_curve(curve);
  }

  /// Makes a polyline. Each of its corners begins with the code 10.
  void make_polyline() {
    DxfCurve curve = new_curve(DxfKind::Polyline);
    curve.is_closed = has_flag(1);
    if (is_seen_from_below()) curve.transform = kFromBelow;
    for (const Value& each : values_) {
      if (each.code == 10) push_vertex({each.number, 0}, 0);
      if (content_.curves.vertices.size() == curve.first_vertex) continue;
      if (each.code == 20) content_.curves.vertices.back().p.y = each.number;
      if (each.code == 42) content_.curves.vertices.back().bulge = each.number;
    }
    finish_polyline(curve);
  }

  void finish_polyline(const DxfCurve& curve) {
    const std::size_t corners = content_.curves.vertices.size() - curve.first_vertex;
    if (corners >= 2) return push_curve(curve);
    content_.curves.vertices.resize(curve.first_vertex);
    skipped_.insert({"polylines of fewer than two corners", 0}).first->second += 1;
  }

  void begin_polyline() {
    constexpr unsigned kMesh = 16 + 64;
    if (has_flag(kMesh)) {
      skipped_.insert({"meshes", 0}).first->second += 1;
      return;
    }
    polyline_ = new_curve(DxfKind::Polyline);
    polyline_.is_closed = has_flag(1);
    if (is_seen_from_below()) polyline_.transform = kFromBelow;
    is_in_polyline_ = true;
  }

  /// Adds a corner. A corner of the control frame of a spline is not on the curve.
  void add_vertex() {
    constexpr unsigned kOfFrame = 16;
    if (is_in_polyline_ && !has_flag(kOfFrame)) push_vertex(required_point(10), value(42, 0));
  }

  void end_polyline() {
    if (is_in_polyline_) finish_polyline(polyline_);
    is_in_polyline_ = false;
  }

  void make_arc() {
    DxfCurve curve = new_curve(DxfKind::Arc);
    const double radius = required(40);
    if (!(radius >= 0)) fail_entity(ErrorCode::BadShape, "has a negative radius");
    if (is_seen_from_below()) curve.transform = kFromBelow;
    curve.is_closed = entity_ == "CIRCLE";
    curve.centre = required_point(10);
    curve.u = {radius, 0};
    curve.v = {0, radius};
    set_angles(curve, curve.is_closed ? 0 : required(50), curve.is_closed ? 360 : required(51));
    divide(curve, radius);
    if (radius > 0) push_curve(curve);
  }

  /// The axes of an ellipse are in the coordinates of the drawing, while the centre of an arc is
  /// not.
  void make_ellipse() {
    DxfCurve curve = new_curve(DxfKind::Arc);
    const double ratio = required(40) * (is_seen_from_below() ? -1 : 1);
    constexpr double kDegrees = 180 / 3.14159265358979323846;
    curve.centre = required_point(10);
    curve.u = required_point(11);
    curve.v = {-ratio * curve.u.y, ratio * curve.u.x};
    set_angles(curve, value(41, 0) * kDegrees, value(42, 2 * 3.14159265358979323846) * kDegrees);
    curve.is_closed = std::fabs(curve.to - curve.from - 360) < 1e-6;  // In files, 2 pi is rounded.
    if (curve.is_closed) curve.to = curve.from + 360;
    divide(curve, std::hypot(curve.u.x, curve.u.y));
    if (ratio != 0 && curve.u != Point2{0, 0}) push_curve(curve);
  }

  /// Sets the number of chords to the number of OpenSCAD, if the drawing is read for OpenSCAD.
  void divide(DxfCurve& curve, double radius) const {
    if (!selection_.division || !(radius > 0)) return;
    with_line([&] {
      const double chords = chords_of(radius * selection_.scale, *selection_.division);
      curve.chords = static_cast<std::uint32_t>(std::ceil(chords * (curve.to - curve.from) / 360));
    });
  }

  void set_angles(DxfCurve& curve, double from, double to) const {
    constexpr double kMost = 1e6;
    if (!(std::fabs(from) <= kMost && std::fabs(to) <= kMost)) {
      fail_entity(ErrorCode::NumberOutOfRange, "has an angle of more than a million degrees");
    }
    curve.from = from;
    curve.to = to;
    while (curve.to <= curve.from) curve.to += 360;
    while (curve.to > curve.from + 360) curve.to -= 360;
  }

  void make_spline() {
    DxfCurve curve = new_curve(DxfKind::Spline);
    curve.is_closed = has_flag(1);
    curve.first_knot = static_cast<std::uint32_t>(content_.curves.knots.size());
    std::size_t weight = curve.first_vertex;  // The vertex to which the next weight belongs.
    for (const Value& each : values_) {
      auto& vertices = content_.curves.vertices;
      if (each.code == 10) push_vertex({each.number, 0}, 0);
      if (each.code == 20 && vertices.size() > curve.first_vertex) {
        vertices.back().p.y = each.number;
      }
      if (each.code == 40) push_knot(each.number, curve.first_knot);
    }
    for (const Value& each : values_) {
      if (each.code == 41) set_weight(weight++, each.number);
    }
    const bool has_control_points = content_.curves.vertices.size() > curve.first_vertex;
    if (!has_control_points && make_fit_curve(curve)) return;
    set_degree(curve, required(71));
    finish_spline(curve);
  }

  void set_weight(std::size_t vertex, double weight) {
    constexpr double kMost = 1e100;  // Products with coordinates of drawings remain doubles.
    if (!(weight >= 1 / kMost && weight <= kMost)) {
      fail_entity(ErrorCode::BadShape, "has a weight that is not above zero, or that is huge");
    }
    if (vertex >= content_.curves.vertices.size()) {
      fail_entity(ErrorCode::CountMismatch, "has more weights than control points");
    }
    content_.curves.vertices[vertex].weight = weight;
  }

  void set_degree(DxfCurve& curve, double degree) const {
    if (!(degree >= 1 && degree <= kMostSplineDegree && degree == std::floor(degree))) {
      fail_entity(ErrorCode::UnknownFormat, "has another degree than 1 to " +
                                                std::to_string(kMostSplineDegree) +
                                                "; replace it by arcs or lines");
    }
    curve.degree = static_cast<std::uint32_t>(degree);
  }

  void finish_spline(DxfCurve& curve) {
    curve.end_knot = static_cast<std::uint32_t>(content_.curves.knots.size());
    const std::size_t points = content_.curves.vertices.size() - curve.first_vertex;
    if (points <= curve.degree || curve.end_knot - curve.first_knot != points + curve.degree + 1) {
      fail_entity(ErrorCode::CountMismatch,
                  "has " + std::to_string(points) + " control points and " +
                      std::to_string(curve.end_knot - curve.first_knot) +
                      " knots; there must be as many knots as points, the degree and 1 together");
    }
    const auto& knots = content_.curves.knots;
    if (knots[curve.first_knot + curve.degree] == knots[curve.first_knot + points]) {
      content_.curves.vertices.resize(curve.first_vertex);
      content_.curves.knots.resize(curve.first_knot);
      skipped_.insert({"splines without length, whose knots are all equal", 0}).first->second += 1;
      return;
    }
    push_curve(curve);
  }

  /// Makes the curve through fit points. Returns false if there are none. A sequence of Bezier
  /// curves is a spline whose inner knots occur three times.
  bool make_fit_curve(DxfCurve& curve) {
    std::vector<Point2> points;
    for (const Value& each : values_) {
      if (each.code == 11) points.push_back({each.number, 0});
      if (each.code == 21 && !points.empty()) points.back().y = each.number;
    }
    if (points.empty()) return false;
    constexpr std::uint64_t kBytesOfPoint = 256;  // The memory of fit_curve() and of its result.
    with_line([&] { charge_.add(kBytesOfPoint * points.size(), "the drawing"); });
    FitEnds ends{curve.is_closed, {}, {}};
    if (has(12)) ends.begin = Point2{value(12, 0), value(22, 0)};
    if (has(13)) ends.end = Point2{value(13, 0), value(23, 0)};
    const FitCurve fit = fit_curve(points, ends, context_);
    content_.curves.knots.resize(curve.first_knot);
    if (fit.control.empty()) {
      skipped_.insert({"splines of fewer than two points", 0}).first->second += 1;
      return true;
    }
    for (const Point2& p : fit.control) push_vertex(p, 0);
    const auto repeat = [&](double knot, int count) {
      for (int k = 0; k < count; ++k) push_knot(knot, curve.first_knot);
    };
    repeat(fit.begin.front(), 1);
    for (const double knot : fit.begin) repeat(knot, 3);
    repeat(fit.begin.back(), 1);
    curve.degree = 3;
    finish_spline(curve);
    ++fitted_;
    return true;
  }

  void push_knot(double knot, std::uint32_t first) {
    if (content_.curves.knots.size() > first && knot < content_.curves.knots.back()) {
      fail_entity(ErrorCode::BadShape, "has knots that descend");
    }
    with_line([&] { charge_.add(2 * sizeof(double), "the drawing"); });
    content_.curves.knots.push_back(knot);
  }

  // ---------------------------------------------------------------- filled polygons

  /// A SOLID lists its third and fourth corner in the order of the letter Z.
  void make_solid() {
    add_area(std::array{10, 11, 13, 12}, is_seen_from_below() ? kFromBelow : SvgTransform{});
  }
  void make_face() { add_area(std::array{10, 11, 12, 13}, {}); }

  /// Adds a separate area with three or four corners. In a triangle, the fourth corner is missing
  /// or equal to the third.
  void add_area(const std::array<int, 4>& codes, const SvgTransform& transform) {
    ++areas_;
    DxfCurve curve = new_edge(DxfKind::Polyline);
    curve.is_closed = true;
    curve.transform = transform;
    for (const int code : codes) {
      const Point2 p = required_point(code == 13 && !has(13) ? 12 : code);
      const auto& vertices = content_.curves.vertices;
      const bool is_first = vertices.size() == curve.first_vertex;
      if (is_first || vertices.back().p != p) push_vertex(p, 0);
    }
    finish_polyline(curve);
  }

  // ---------------------------------------------------------------- hatches

  /// Adds the borders of a hatch. They all belong to one area. If islands are ignored, each border
  /// bounds a separate area.
  void make_hatch() {
    const SvgTransform transform = is_seen_from_below() ? kFromBelow : SvgTransform{};
    next_value_ = 0;
    while (next_value_ < values_.size() && values_[next_value_].code != 91) ++next_value_;
    const std::size_t first_curve = content_.curves.curves.size();
    const double paths = next_number(91);
    constexpr double kIgnoresIslands = 2;
    const bool is_one_area = value(75, 0) != kIgnoresIslands;
    if (is_one_area) ++areas_;
    for (double path = 0; path < paths; ++path) {
      if (!is_one_area) ++areas_;
      add_border();
    }
    for (std::size_t c = first_curve; c < content_.curves.curves.size(); ++c) {
      content_.curves.curves[c].transform = transform;
    }
  }

  /// Returns the next value of a hatch, which must have the given code.
  double next_number(int code) {
    if (next_value_ == values_.size() || values_[next_value_].code != code) {
      fail_entity(ErrorCode::CountMismatch,
                  "lacks a value with the code " + std::to_string(code) + " in a border");
    }
    return values_[next_value_++].number;
  }
  double next_number(int code, double otherwise) {
    const bool is_there = next_value_ < values_.size() && values_[next_value_].code == code;
    return is_there ? values_[next_value_++].number : otherwise;
  }
  Point2 next_point(int code) {
    const double x = next_number(code);
    return {x, next_number(code + 10)};
  }
  DxfCurve new_edge(DxfKind kind) const {
    DxfCurve curve = new_curve(kind);
    curve.area = areas_;
    return curve;
  }

  void add_border() {
    const double flags = next_number(92);
    constexpr unsigned kPolyline = 2;
    const bool is_polyline =
        flags >= 0 && flags < 65536 && (static_cast<unsigned>(flags) & kPolyline) != 0;
    if (is_polyline) {
      add_polyline_border();
    } else {
      const double edges = next_number(93);
      for (double edge = 0; edge < edges; ++edge) add_edge();
    }
    skip_hatch_data();
  }

  void add_polyline_border() {
    next_number(72, 0);
    next_number(73, 0);
    DxfCurve curve = new_edge(DxfKind::Polyline);
    curve.is_closed = true;
    const double corners = next_number(93);
    for (double corner = 0; corner < corners; ++corner) {
      const Point2 p = next_point(10);
      push_vertex(p, next_number(42, 0));
    }
    finish_polyline(curve);
  }

  void add_edge() {
    constexpr double kLine = 1, kArc = 2, kEllipse = 3, kSpline = 4;
    const double kind = next_number(72);
    if (kind == kLine) return add_line_edge();
    if (kind == kArc) return add_arc_edge();
    if (kind == kEllipse) return add_ellipse_edge();
    if (kind == kSpline) return add_spline_edge();
    fail_entity(ErrorCode::UnknownFormat, "has a border of another kind than 1 to 4");
  }

  void add_line_edge() {
    const DxfCurve curve = new_edge(DxfKind::Polyline);
    const Point2 from = next_point(10), to = next_point(11);
    if (from == to) return;
    push_vertex(from, 0);
    push_vertex(to, 0);
    push_curve(curve);
  }

  void add_arc_edge() {
    DxfCurve curve = new_edge(DxfKind::Arc);
    curve.centre = next_point(10);
    const double radius = next_number(40);
    if (!(radius >= 0)) fail_entity(ErrorCode::BadShape, "has a negative radius");
    curve.u = {radius, 0};
    curve.v = {0, radius};
    const double from = next_number(50), to = next_number(51);
    set_edge_angles(curve, from, to, 1);
    if (radius > 0) push_curve(curve);
  }

  void add_ellipse_edge() {
    DxfCurve curve = new_edge(DxfKind::Arc);
    curve.centre = next_point(10);
    curve.u = next_point(11);
    const double ratio = next_number(40);
    curve.v = {-ratio * curve.u.y, ratio * curve.u.x};
    const double from = next_number(50), to = next_number(51);
    set_edge_angles(curve, from, to, ratio);
    if (ratio != 0 && curve.u != Point2{0, 0}) push_curve(curve);
  }

  /// Sets the angles of an arc. The next value states whether they are counter-clockwise or
  /// clockwise. The angles of an ellipse are the angles of its points, not those of the circle
  /// whose image it is.
  void set_edge_angles(DxfCurve& curve, double from, double to, double ratio) {
    const bool is_whole = std::fabs(std::fabs(to - from) - 360) < 1e-6;
    const bool is_clockwise = next_number(73, 1) == 0;
    const double first = is_clockwise ? -to : from, last = is_clockwise ? -from : to;
    set_angles(curve, on_circle(first, ratio), on_circle(last, ratio));
    curve.is_closed = is_whole;
    if (is_whole) curve.to = curve.from + 360;
  }

  static double on_circle(double degrees, double ratio) {
    if (ratio == 1 || std::remainder(degrees, 90) == 0) return degrees;
    const Point2 at = unit_vector(degrees);
    const double t = arc_tangent(at.y, at.x * ratio) * 180 / 3.14159265358979323846;
    return degrees + std::remainder(t - degrees, 360);
  }

  void add_spline_edge() {
    DxfCurve curve = new_edge(DxfKind::Spline);
    const double degree = next_number(94);
    next_number(73, 0);
    next_number(74, 0);
    const double knots = next_number(95), points = next_number(96);
    curve.first_knot = static_cast<std::uint32_t>(content_.curves.knots.size());
    for (double k = 0; k < knots; ++k) push_knot(next_number(40), curve.first_knot);
    for (double k = 0; k < points; ++k) {
      push_vertex(next_point(10), 0);
      set_weight(content_.curves.vertices.size() - 1, next_number(42, 1));
    }
    set_degree(curve, degree);
    finish_spline(curve);
    skip_hatch_data();
  }

  /// Skips the fit points of a spline, and the number of the entities from which a border was made.
  void skip_hatch_data() {
    constexpr std::array kCodes{97, 11, 21, 12, 22, 13, 23};
    while (next_value_ < values_.size() &&
           std::find(kCodes.begin(), kCodes.end(), values_[next_value_].code) != kCodes.end()) {
      ++next_value_;
    }
  }

  // ---------------------------------------------------------------- blocks

  /// Reads the blocks that are inserted, each once. A block that no insert names is not read, so it
  /// causes no errors.
  void read_blocks() {
    for (std::size_t i = 0; i < content_.inserts.size(); ++i) {
      const std::string_view name = content_.inserts[i].block;
      const auto place = block_places_.find(name);
      if (place == block_places_.end()) {
        skipped_.insert({"inserts of blocks that are missing", 0}).first->second += 1;
      } else if (content_.blocks.find(name) == content_.blocks.end()) {
        read_block(content_.blocks[name], place->second.first, place->second.second);
      }
    }
  }

  void read_block(DxfBlock& block, std::string_view rest, std::size_t line) {
    block_ = &block;
    block.first_curve = static_cast<std::uint32_t>(content_.curves.curves.size());
    block.first_insert = static_cast<std::uint32_t>(content_.inserts.size());
    rest_ = rest;
    line_ = line;
    has_end_ = false;
    section_ = "ENTITIES";
    entity_ = "BLOCK";
    is_read_ = true;
    values_.clear();
    const auto ends_block = [&] {
      return code_ == 0 && (value_ == "ENDBLK" || value_ == "ENDSEC" || value_ == "EOF");
    };
    while (next_pair() && !ends_block()) take_pair();
    close_entity();
    block.end_curve = static_cast<std::uint32_t>(content_.curves.curves.size());
    block.end_insert = static_cast<std::uint32_t>(content_.inserts.size());
  }

  void set_base() {
    if (block_ != nullptr) block_->base = {value(10, 0), value(20, 0)};
  }

  /// Stores an insert. The array is rotated with the block, but the scales do not change its steps.
  void make_insert() {
    DxfInsert insert;
    insert.block = name_;
    insert.layer = layer_;
    insert.line = entity_line_;
    insert.scale = {value(41, 1), value(42, 1)};
    insert.spacing = {value(44, 0), value(45, 0)};
    insert.columns = number_in_array(70);
    insert.rows = number_in_array(71);
    const Point2 at = required_point(10), turn = unit_vector(value(50, 0));
    insert.placing = {turn.x, turn.y, -turn.y, turn.x, at.x, at.y};
    if (is_seen_from_below()) insert.placing = product(kFromBelow, insert.placing);
    if (insert.scale.x == 0 || insert.scale.y == 0) {
      fail_entity(ErrorCode::BadShape, "has the scale 0");
    }
    with_line([&] { charge_.add(2 * sizeof(DxfInsert), "the drawing"); });
    content_.inserts.push_back(insert);
  }

  std::uint32_t number_in_array(int code) const {
    constexpr double kMost = 32767;
    const double count = value(code, 1);
    if (!(count >= 0 && count <= kMost)) {
      fail_entity(ErrorCode::NumberOutOfRange, "has an array with a side below 0 or above 32767");
    }
    return std::max(static_cast<std::uint32_t>(count), std::uint32_t{1});
  }

  // ---------------------------------------------------------------- notes and errors

  void add_notes(ShapeCollector& shapes) const {
    constexpr std::size_t kMostNamed = 16;
    std::size_t named = 0;
    for (const auto& [name, count] : skipped_) {
      if (++named > kMostNamed) {
        shapes.pass_over("other entities");
        break;
      }
      shapes.pass_over(std::string(name.substr(0, text_prefix(name))) + " (" +
                       std::to_string(count) + ")");
    }
    if (has_heights_) shapes.pass_over(kHeights);
    if (fitted_ > 0) {
      shapes.note("splines without control points, drawn through their fit points: " +
                  std::to_string(fitted_));
    }
    if (layers_.size() > 1) {
      std::string names;
      for (const std::string& name : layers_) {
        if (names.size() > 200) {
          names += ", ...";
          break;
        }
        names += (names.empty() ? "" : ", ") + plumb::quoted(name);
      }
      shapes.note("all layers are read together: " + names);
    }
    const bool is_known = unit_ >= 1 && unit_ < static_cast<double>(kDxfUnits.size());
    if (is_known) {
      shapes.note(std::string("the unit of the drawing is the ") +
                  kDxfUnits[static_cast<std::size_t>(unit_)] + "; the coordinates are not scaled");
    }
  }

  template <class Call>
  void with_line(Call call) const {
    with_place(*this, call);
  }

 public:
  /// Throws an error with the place of the line that was read last.
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    throw Error(code, message, {options_.name, std::max<std::size_t>(line_, 1), 1});
  }

 private:
  /// Throws an error with the place of the first line of the entity.
  [[noreturn]] void fail_entity(ErrorCode code, const std::string& message) const {
    throw Error(code, "the " + std::string(entity_) + ' ' + message,
                {options_.name, entity_line_, 1});
  }

  std::string_view text_;
  std::string_view rest_;
  DxfSelection selection_;
  std::string_view only_layer_;  // Empty if all layers are read.
  const ReadOptions& options_;
  NumberReader numbers_;
  Context& context_;
  MemoryCharge charge_;
  std::size_t line_ = 0;
  std::size_t pairs_ = 0;
  const char* where_ = nullptr;
  int code_ = 0;
  std::string_view value_;
  std::string_view section_;
  std::string_view variable_;
  double unit_ = 0;
  bool has_end_ = false;
  // The current entity.
  std::string_view entity_;
  std::string_view layer_ = "0";
  std::string_view name_;
  const char* entity_where_ = nullptr;
  std::size_t entity_line_ = 0;
  bool is_read_ = false;
  std::vector<Value> values_;
  std::size_t next_value_ = 0;  // For a hatch.
  std::uint32_t areas_ = 0;     // The number of areas of the hatches.
  std::uint64_t charged_values_ = 0;
  bool is_in_polyline_ = false;
  DxfCurve polyline_;
  // Blocks: the place where the text of each block begins, and the block that is being read.
  std::map<std::string_view, std::pair<std::string_view, std::size_t>, DxfNameOrder> block_places_;
  std::string_view block_rest_;
  std::size_t block_line_ = 0;
  DxfBlock* block_ = nullptr;
  // All entities.
  DxfContent content_;
  bool has_heights_ = false;
  std::size_t fitted_ = 0;  // The number of splines that have fit points but no control points.
  std::map<std::string_view, std::size_t> skipped_;
  std::set<std::string> layers_;
};

}  // namespace

bool begins_like_dxf(std::string_view text) {
  take_prefix(text, "\xEF\xBB\xBF");
  if (text.starts_with("AutoCAD Binary DXF")) return true;
  const std::size_t end = text.find('\n');
  if (end == text.npos) return false;
  const std::string_view code = trimmed(text.substr(0, end));
  text.remove_prefix(end + 1);
  const std::string_view value = trimmed(text.substr(0, text.find('\n')));
  return code == "999" || (code == "0" && value == "SECTION");
}

PlaneFile read_dxf(std::string_view text, const ReadOptions& options, Context& context) {
  return read_dxf_selection(text, {}, options, context);
}

PlaneFile read_dxf_selection(std::string_view text, const DxfSelection& selection,
                             const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  take_prefix(text, "\xEF\xBB\xBF");
  return DxfReader(text, selection, options, context).read();
}

void write_dxf(std::ostream& stream, const PlaneShapes& shapes, Context& context) {
  TextOutput out(stream, context);
  out << "  0\nSECTION\n  2\nHEADER\n  9\n$ACADVER\n  1\nAC1015\n  0\nENDSEC\n"
      << "  0\nSECTION\n  2\nENTITIES\n";
  for (std::size_t r = 0; r < shapes.ring_count(); ++r) {
    const auto ring = shapes.ring(r);
    out << "  0\nLWPOLYLINE\n100\nAcDbEntity\n  8\n0\n100\nAcDbPolyline\n 90\n"
        << std::uint64_t{ring.size()} << "\n 70\n1\n";
    for (const std::uint32_t corner : ring) {
      const Point2 p = shapes.points.approx(corner);
      out << " 10\n" << p.x << "\n 20\n" << p.y << '\n';
    }
  }
  out << "  0\nENDSEC\n  0\nEOF\n";
  out.flush();
}

}  // namespace plumb
