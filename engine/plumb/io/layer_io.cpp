// Reading of layers.
//
// A file has one value of JSON or a sequence of them, such as a feature on each line. GeoJSON
// states the positions of each ring. TopoJSON states arcs, which rings share; a ring is a list of
// arcs, and ~i is arc i from its end to its start. The points of an arc are made once, so features
// that share an arc share its points. Both kinds of geometries are found by one walk over
// geometries, which keeps a stack of its own because collections may be nested.
//
// Layers are written in layer_writer.cpp. Tested by tests/io/layer_io_test.cpp.
#include "plumb/io/layer_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "plumb/base/internal/round_to_nearest.h"
#include "plumb/io/plane/gdal_layer.h"
#include "plumb/io/plane/shape_text.h"
#include "plumb/io/plane/wkb.h"
#include "plumb/io/plane/wkt.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/text/double_text.h"
#include "plumb/io/text/files.h"
#include "plumb/io/text/foreign_files.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/json_reader.h"
#include "plumb/io/text/lenient_json.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

// The memory of a point and a corner, while both lists grow.
constexpr std::uint64_t kBytesPerLayerPosition = 60;

constexpr std::array<std::string_view, 5> kCollectionMembers{"type", "features", "crs", "bbox",
                                                             "name"};
constexpr std::array<std::string_view, 6> kFeatureMembers{"type",     "id",   "properties",
                                                          "geometry", "bbox", "crs"};

/// A layer that is being read, and the counts for its notes.
struct LayerDraft {
  LayerFile file;
  std::size_t dropped = 0;        // Points and lines.
  std::size_t collapsed = 0;      // Rings with fewer than three positions.
  std::size_t unclosed = 0;       // Rings whose end differs from their start.
  JsonReplaced replaced;          // The parts of the text that are not JSON.
  bool has_heights = false;       // Whether positions have numbers after x and y.
  std::set<std::string> members;  // The names of unknown members of features and collections.
  std::size_t steps = 0;          // The number of points and corners so far, for checkpoints.
  std::size_t untyped = 0;        // Geometries that are objects without a type.
  bool has_unnamed_crs = false;
};

class LayerReader {
 public:
  using Id = JsonValues::Id;

  /// Reads the value `part` of the text of a file, and appends its features to `draft`.
  LayerReader(std::string_view text, std::string_view part, const LayerReadOptions& options,
              LayerDraft& draft, Context& context)
      : text_(text),
        part_(static_cast<std::size_t>(part.data() - text.data())),
        options_(options),
        context_(context),
        draft_(draft),
        file_(draft.file),
        lenient_(
            part, options.name,
            [this](std::size_t byte, ErrorCode code, const std::string& what) {
              fail_at(byte, code, what);
            },
            context),
        json_(lenient_.values()) {
    draft.replaced.add(lenient_.replaced());
  }

  void read() {
    const std::string type = type_of(JsonValues::kDocument);
    if (type == "Topology") {
      if (file_.layer.points.size() > 0) {
        fail(ErrorCode::Syntax, "a Topology after other values", JsonValues::kDocument);
      }
      read_topology();
    } else if (type == "FeatureCollection") {
      name_unknown_members(JsonValues::kDocument, kCollectionMembers);
      for (const Id feature : list(JsonValues::kDocument, "features")) read_feature(feature);
    } else if (type == "Feature") {
      read_feature(JsonValues::kDocument);
    } else {
      add_geometry(JsonValues::kDocument);
      file_.layer.end_feature("", "");
    }
    if (const std::optional<Id> crs = json_.find(JsonValues::kDocument, "crs")) read_crs(*crs);
  }

 private:
  [[noreturn]] void fail_at(std::size_t byte, ErrorCode code, const std::string& what) const {
    TextCursor cursor(text_, options_.name);
    cursor.move_to(text_.data() + part_ + byte);
    cursor.fail(code, what);
  }
  [[noreturn]] void fail(ErrorCode code, const std::string& what, Id at) {
    fail_at(lenient_.byte(at), code, what);
  }
  std::string type_of(Id object);
  JsonValues::Items list(Id object, std::string_view member);
  JsonValues::Items items(Id value, const char* what);
  std::string_view member_source(Id object, std::string_view member) const;
  double number(Id value);
  void name_unknown_members(Id object, std::span<const std::string_view> known);

  void read_crs(Id crs);
  void read_feature(Id feature);
  bool is_without_type(Id object) const;
  void add_geometry(Id geometry);
  void add_polygon(Id rings);
  void add_positions(Id ring);
  void end_ring();
  std::uint32_t add_point(Point2 p);

  void read_topology();
  void read_transform();
  void read_arcs();
  Id chosen_object();
  bool has_polygons(Id object) const;
  void add_arcs(Id ring);

  std::string_view text_;
  std::size_t part_;  // The first byte of the value.
  const LayerReadOptions& options_;
  Context& context_;
  LayerDraft& draft_;
  LayerFile& file_;  // The file that belongs to the draft.
  LenientJson lenient_;
  const JsonValues& json_;  // The values of lenient_.
  bool is_topology_ = false;
  bool is_quantised_ = false;
  Point2 scale_{1, 1}, translate_{0, 0};
  // The points of arc i have the numbers from arc_begin_[i] to arc_begin_[i + 1] - 1.
  std::vector<std::uint32_t> arc_begin_{0};
};

std::string LayerReader::type_of(Id object) {
  if (!json_.is_object(object)) fail(ErrorCode::Syntax, "expected an object", object);
  const std::optional<Id> type = json_.find(object, "type");
  if (!type || !json_.is_text(*type)) {
    fail(ErrorCode::Syntax, "an object without \"type\": is this GeoJSON or TopoJSON?", object);
  }
  return json_.text(*type);
}

JsonValues::Items LayerReader::items(Id value, const char* what) {
  if (!json_.is_list(value)) fail(ErrorCode::Syntax, std::string("expected ") + what, value);
  return json_.items(value);
}

JsonValues::Items LayerReader::list(Id object, std::string_view member) {
  const std::optional<Id> found = json_.find(object, member);
  if (!found || !json_.is_list(*found)) {
    fail(ErrorCode::Syntax, "expected a list \"" + std::string(member) + '"', object);
  }
  return json_.items(*found);
}

std::string_view LayerReader::member_source(Id object, std::string_view member) const {
  const std::optional<Id> found = json_.find(object, member);
  return found ? json_.source(*found) : std::string_view();
}

void LayerReader::name_unknown_members(Id object, std::span<const std::string_view> known) {
  constexpr std::size_t kMostNamed = 20;
  bool is_name = true;
  // Names and members alternate.
  for (const Id value : json_.items(object)) {
    if (is_name && draft_.members.size() < kMostNamed) {
      const std::string_view quoted = json_.source(value);
      const std::string_view name = quoted.substr(1, quoted.size() - 2);
      if (std::find(known.begin(), known.end(), name) == known.end()) {
        draft_.members.insert(json_.text(value));
      }
    }
    is_name = !is_name;
  }
}

double LayerReader::number(Id value) {
  const std::string_view token = json_.source(value);
  if (token == "null") fail(ErrorCode::Syntax, "a coordinate that is null or not finite", value);
  if (!json_.is_number(value)) fail(ErrorCode::Syntax, "expected a number", value);
  double result = 0;
  const char* const last = token.data() + token.size();
  const auto [end, code] = double_from_chars(token.data(), last, result);
  // The value is tiny, or its text is long.
  if (code != std::errc() || end != last) return json_.number(value);
  return result;
}

std::uint32_t LayerReader::add_point(Point2 p) {
  constexpr std::size_t kSteps = 4096;
  if (draft_.steps++ % kSteps == 0) {
    context_.checkpoint("read", draft_.steps, 0);
    context_.charge_memory(kSteps * kBytesPerLayerPosition, "the layer");
  }
  file_.layer.points.push_back(p);
  return static_cast<std::uint32_t>(file_.layer.points.size() - 1);
}

// ---------------------------------------------------------------- features

/// Reads the name of a coordinate reference system: {"type": "name", "properties": {"name": TEXT}}.
void LayerReader::read_crs(Id crs) {
  if (!json_.is_object(crs)) return;  // The value is null.
  const std::optional<Id> properties = json_.find(crs, "properties");
  std::optional<Id> name;
  if (properties && json_.is_object(*properties)) name = json_.find(*properties, "name");
  if (name && json_.is_text(*name)) {
    file_.crs = json_.text(*name);
    file_.layer.crs = file_.crs;
  } else {
    draft_.has_unnamed_crs = true;
  }
}

void LayerReader::read_feature(Id feature) {
  if (type_of(feature) != "Feature") fail(ErrorCode::Syntax, "expected a Feature", feature);
  name_unknown_members(feature, kFeatureMembers);
  const std::optional<Id> geometry = json_.find(feature, "geometry");
  if (geometry) add_geometry(*geometry);
  file_.layer.end_feature(member_source(feature, "id"), member_source(feature, "properties"));
}

/// Whether an object stands for a geometry that is missing: its type is null, or it has no members.
/// In TopoJSON, it may have members and no type.
bool LayerReader::is_without_type(Id object) const {
  const std::optional<Id> type = json_.find(object, "type");
  if (is_topology_) return !type || !json_.is_text(*type);
  if (!type) return json_.items(object).begin() == json_.items(object).end();
  return json_.source(*type) == "null";
}

/// Adds the polygons of a geometry and of all geometries in it.
void LayerReader::add_geometry(Id geometry) {
  const char* const member = is_topology_ ? "arcs" : "coordinates";
  std::vector<Id> open{geometry};
  while (!open.empty()) {
    const Id at = open.back();
    open.pop_back();
    if (!json_.is_object(at)) {
      if (json_.source(at) != "null") fail(ErrorCode::Syntax, "expected a geometry or null", at);
      continue;
    }
    if (is_without_type(at)) {
      // TopoJSON states a missing geometry so, and old converters left it so in GeoJSON.
      if (!is_topology_) ++draft_.untyped;
      continue;
    }
    const std::string type = type_of(at);
    if (type == "Polygon") {
      const std::optional<Id> rings = json_.find(at, member);
      if (!rings) fail(ErrorCode::Syntax, "a Polygon needs " + std::string(member), at);
      add_polygon(*rings);
    } else if (type == "MultiPolygon") {
      for (const Id rings : list(at, member)) add_polygon(rings);
    } else if (type == "GeometryCollection") {
      const std::size_t first = open.size();
      for (const Id part : list(at, "geometries")) open.push_back(part);
      std::reverse(open.begin() + static_cast<std::ptrdiff_t>(first), open.end());
    } else if (type == "Point" || type == "MultiPoint" || type == "LineString" ||
               type == "MultiLineString") {
      ++draft_.dropped;
    } else {
      fail(ErrorCode::Syntax, "expected a geometry, found " + plumb::quoted(type), at);
    }
  }
}

void LayerReader::add_polygon(Id rings) {
  for (const Id ring : items(rings, "a list of rings")) {
    if (is_topology_) {
      add_arcs(ring);
    } else {
      add_positions(ring);
    }
    end_ring();
  }
  if (file_.layer.ring_count() > file_.layer.polygon_begin.back()) file_.layer.end_polygon();
}

void LayerReader::add_positions(Id ring) {
  for (const Id position : items(ring, "a list of positions")) {
    const JsonValues::Items numbers = items(position, "a position");
    double xy[2] = {0, 0};
    std::size_t count = 0;
    for (const Id value : numbers) {
      if (count == 2) {
        draft_.has_heights = true;
        break;
      }
      xy[count++] = number(value);
    }
    if (count < 2) fail(ErrorCode::BadShape, "a position needs two numbers, x and y", position);
    file_.layer.ring_corners.push_back(add_point({xy[0], xy[1]}));
  }
}

/// Ends a ring. Its last corner is left out if it lies where the first one does; otherwise an edge
/// closes the ring.
void LayerReader::end_ring() {
  Layer& layer = file_.layer;
  const std::size_t first = layer.ring_begin.back();
  const auto is_equal = [&layer](std::uint32_t i, std::uint32_t j) {
    const Point2 p = layer.points.approx(i), q = layer.points.approx(j);
    return p.x == q.x && p.y == q.y;
  };
  std::vector<std::uint32_t>& corners = layer.ring_corners;
  // Some programs leave the last position out, and published TopoJSON has rings whose ends are a
  // quantum apart.
  const bool is_open = corners.size() > first && !is_equal(corners[first], corners.back());
  while (corners.size() > first + 1 && is_equal(corners[first], corners.back())) corners.pop_back();
  const auto begin = corners.begin() + static_cast<std::ptrdiff_t>(first);
  corners.erase(std::unique(begin, corners.end(), is_equal), corners.end());
  if (corners.size() - first < 3) {
    corners.resize(first);
    ++draft_.collapsed;
    return;
  }
  if (is_open) ++draft_.unclosed;
  layer.end_ring();
}

// ---------------------------------------------------------------- TopoJSON

void LayerReader::read_topology() {
  is_topology_ = true;
  read_transform();
  read_arcs();
  const Id object = chosen_object();
  const bool is_collection = type_of(object) == "GeometryCollection";
  std::vector<Id> geometries;
  if (is_collection) {
    for (const Id geometry : list(object, "geometries")) geometries.push_back(geometry);
  } else {
    geometries.push_back(object);
  }
  for (const Id geometry : geometries) {
    add_geometry(geometry);
    if (json_.is_object(geometry)) {
      file_.layer.end_feature(member_source(geometry, "id"), member_source(geometry, "properties"));
    } else {
      file_.layer.end_feature("", "");  // null
    }
  }
}

void LayerReader::read_transform() {
  const std::optional<Id> transform = json_.find(JsonValues::kDocument, "transform");
  if (!transform || !json_.is_object(*transform)) return;
  is_quantised_ = true;
  const auto pair = [&](std::string_view member) {
    double xy[2] = {0, 0};
    std::size_t count = 0;
    for (const Id value : list(*transform, member)) {
      if (count < 2) xy[count] = number(value);
      ++count;
    }
    if (count != 2) fail(ErrorCode::BadShape, "a transform has pairs of numbers", *transform);
    return Point2{xy[0], xy[1]};
  };
  scale_ = pair("scale");
  translate_ = pair("translate");
}

void LayerReader::read_arcs() {
  for (const Id arc : list(JsonValues::kDocument, "arcs")) {
    Point2 sum{0, 0};
    for (const Id position : items(arc, "a list of positions")) {
      double xy[2] = {0, 0};
      std::size_t count = 0;
      for (const Id value : items(position, "a position")) {
        if (count == 2) {
          draft_.has_heights = true;
          break;
        }
        xy[count++] = number(value);
      }
      if (count < 2) fail(ErrorCode::BadShape, "a position needs two numbers, x and y", position);
      Point2 p{xy[0], xy[1]};
      if (is_quantised_) {
        sum = {sum.x + p.x, sum.y + p.y};
        p = {sum.x * scale_.x + translate_.x, sum.y * scale_.y + translate_.y};
      }
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
        fail(ErrorCode::NumberOutOfRange, "a position lies beyond the largest double", position);
      }
      add_point(p);
    }
    arc_begin_.push_back(static_cast<std::uint32_t>(file_.layer.points.size()));
  }
}

/// Whether an object of TopoJSON has a polygon.
bool LayerReader::has_polygons(Id object) const {
  std::vector<Id> open{object};
  while (!open.empty()) {
    const Id at = open.back();
    open.pop_back();
    if (!json_.is_object(at)) continue;
    const std::optional<Id> type = json_.find(at, "type");
    if (!type || !json_.is_text(*type)) continue;
    const std::string name = json_.text(*type);
    if (name == "Polygon" || name == "MultiPolygon") return true;
    const std::optional<Id> parts = json_.find(at, "geometries");
    if (!parts || !json_.is_list(*parts)) continue;
    for (const Id part : json_.items(*parts)) open.push_back(part);
  }
  return false;
}

/// Returns the object of that name. Without a name, returns the first object that has polygons, or
/// the first object.
LayerReader::Id LayerReader::chosen_object() {
  const std::optional<Id> objects = json_.find(JsonValues::kDocument, "objects");
  if (!objects || !json_.is_object(*objects)) {
    fail(ErrorCode::Syntax, "expected an object \"objects\"", JsonValues::kDocument);
  }
  std::vector<std::pair<std::string, Id>> all;
  bool is_name = true;
  // Names and members alternate.
  for (const Id value : json_.items(*objects)) {
    if (is_name) {
      all.emplace_back(json_.text(value), value);
    } else {
      all.back().second = value;
    }
    is_name = !is_name;
  }
  const auto is_wanted = [&](const auto& object) {
    return options_.object.empty() ? has_polygons(object.second) : object.first == options_.object;
  };
  auto found = std::find_if(all.begin(), all.end(), is_wanted);
  if (found == all.end() && options_.object.empty()) found = all.begin();
  std::optional<Id> chosen;
  if (found != all.end()) chosen = found->second;
  std::string others;
  for (const auto& [name, value] : all) {
    if (value != chosen) others += (others.empty() ? "" : ", ") + plumb::quoted(name);
  }
  if (!chosen) {
    throw Error(ErrorCode::BadArgument,
                others.empty() ? "the file has no object"
                               : "there is no object " + plumb::quoted(options_.object) +
                                     "; the file has " + others,
                {options_.name});
  }
  if (!others.empty() && options_.object.empty()) {
    file_.notes.push_back("passed over: objects " + others + " (--object NAME reads another one)");
  }
  return *chosen;
}

/// Appends the points of the arcs of a ring. Each arc begins where the previous arc ends.
void LayerReader::add_arcs(Id ring) {
  std::vector<std::uint32_t>& corners = file_.layer.ring_corners;
  const auto arcs = static_cast<std::int64_t>(arc_begin_.size() - 1);
  for (const Id value : items(ring, "a list of arcs")) {
    const double stated = number(value);
    const double index = stated < 0 ? -1 - stated : stated;
    if (!(index < static_cast<double>(arcs)) || index != std::floor(index)) {
      fail(ErrorCode::BadIndex, "there is no such arc", value);
    }
    const auto arc = static_cast<std::size_t>(index);
    const std::uint32_t begin = arc_begin_[arc], end = arc_begin_[arc + 1];
    constexpr std::size_t kMostCorners = std::size_t{1} << 30U;
    if (corners.size() + (end - begin) > kMostCorners) {
      fail(ErrorCode::ResourceLimit, "more than 2^30 corners", value);
    }
    context_.charge_memory((end - begin) * sizeof(std::uint32_t), "the layer");
    draft_.steps += end - begin;
    for (std::uint32_t i = 0; i < end - begin; ++i) {
      corners.push_back(stated < 0 ? end - 1 - i : begin + i);
    }
  }
}

/// Returns the file of a draft, with notes.
LayerFile noted(LayerDraft draft) {
  std::vector<std::string>& notes = draft.file.notes;
  draft.file.has_points_or_lines = draft.dropped > 0;
  if (draft.dropped > 0) {
    notes.push_back("passed over: points and lines (" + std::to_string(draft.dropped) + ')');
  }
  if (draft.collapsed > 0) {
    notes.push_back("passed over: rings with fewer than three different positions (" +
                    std::to_string(draft.collapsed) + ')');
  }
  if (draft.unclosed > 0) {
    notes.push_back(std::string(kClosedByEdge) + " (" + std::to_string(draft.unclosed) + ')');
  }
  if (draft.untyped > 0) {
    notes.push_back("read as null: geometries without a type (" + std::to_string(draft.untyped) +
                    ')');
  }
  if (draft.has_heights) notes.push_back("passed over: numbers of positions after x and y");
  if (!draft.replaced.is_none()) notes.push_back(draft.replaced.note());
  if (!draft.members.empty()) {
    std::string names;
    for (const std::string& name : draft.members) {
      names += (names.empty() ? "" : ", ") + plumb::quoted(name);
    }
    notes.push_back("passed over: members " + names);
  }
  if (draft.has_unnamed_crs) notes.push_back("passed over: a \"crs\" without a name");
  return std::move(draft.file);
}

// Blanks, and the record separator of RFC 8142.
constexpr std::string_view kBetweenValues = " \t\r\n\x1e";

/// Returns the first object of a text that begins with one, or the whole text if the object does
/// not end.
std::string_view first_object(std::string_view text) {
  std::size_t open = 0;
  bool is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') is_quoted = !is_quoted;
    if (is_quoted) {
      if (c == '\\') ++i;
      continue;
    }
    if (c == '{') ++open;
    if (c == '}' && --open == 0) return text.substr(0, i + 1);
  }
  return text;
}

/// Returns the next value of a sequence of JSON texts, and removes it from `rest`. If a text does
/// not begin with a brace, its value extends to the end.
std::string_view take_value(std::string_view& rest) {
  rest.remove_prefix(std::min(rest.find_first_not_of(kBetweenValues), rest.size()));
  const std::string_view value = rest.starts_with('{') ? first_object(rest) : rest;
  rest.remove_prefix(value.size());
  rest.remove_prefix(std::min(rest.find_first_not_of(kBetweenValues), rest.size()));
  return value;
}

/// Reads a JSON text, or a sequence of them: one after the other, with blanks or record separators
/// between them.
LayerFile read_json_layer(std::string_view text, const LayerReadOptions& options,
                          Context& context) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  LayerDraft draft;
  std::string_view rest = text;
  if (rest.starts_with(kByteOrderMark)) rest.remove_prefix(kByteOrderMark.size());
  do {
    const std::string_view value = take_value(rest);
    LayerReader(text, value, options, draft, context).read();
  } while (!rest.empty());
  return noted(std::move(draft));
}

}  // namespace

namespace {

/// Returns the polygons of shapes as features.
LayerFile layer_of_shapes(PlaneFile file, Context& context) {
  LayerFile result;
  result.notes = std::move(file.notes);
  PlaneShapes& shapes = file.shapes;
  if (!shapes.line_corners.empty() || !shapes.single_points.empty()) {
    result.has_points_or_lines = true;
    result.notes.push_back("passed over: points and lines");
  }
  Layer& layer = result.layer;
  layer.points = std::move(shapes.points);
  // The index of the next entry of file.continued, a polygon of the feature of the one before.
  std::size_t next = 0;
  auto empty = file.without_polygons.begin();
  const auto add_empty_before = [&](std::size_t p) {
    for (; empty != file.without_polygons.end() && *empty <= p; ++empty) layer.end_feature("", "");
  };
  add_empty_before(0);
  for (std::size_t p = 0; p < shapes.polygon_count(); ++p) {
    if (p % 1024 == 0) context.checkpoint("read", p, shapes.polygon_count());
    for (std::size_t r = shapes.polygon_begin[p]; r < shapes.polygon_begin[p + 1]; ++r) {
      const std::span<const std::uint32_t> ring = shapes.ring(r);
      if (ring.size() < 3) continue;
      layer.ring_corners.insert(layer.ring_corners.end(), ring.begin(), ring.end());
      layer.end_ring();
    }
    if (layer.ring_count() > layer.polygon_begin.back()) layer.end_polygon();
    while (next < file.continued.size() && file.continued[next] <= p) ++next;
    if (next < file.continued.size() && file.continued[next] == p + 1) continue;
    layer.end_feature("", "");
    add_empty_before(p + 1);
  }
  return result;
}

bool begins_like_json(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\x1e\xef\xbb\xbf");
  return first != text.npos && text[first] == '{';
}

}  // namespace

std::string lack_of_polygons(const LayerFile& file) {
  if (file.layer.ring_count() > 0 || !file.has_points_or_lines) return {};
  return "the file has points or lines, but no polygons, of which layers consist; plumb plane "
         "reads "
         "it";
}

bool begins_like_layer(std::string_view text) {
  return begins_like_json(text) || begins_like_wkb(text) || begins_like_wkt(text);
}

bool is_read_by_gdal(const std::string& path) { return has_gdal() && is_gdal_format(path); }

void require_layer_format(const std::string& path) {
  if (is_read_by_gdal(path)) return;
  const std::string extension = std::filesystem::path(path).extension().string();
  constexpr std::array kNames{".shp", ".gpkg",    ".fgb",        ".gdb",     ".kml",   ".kmz",
                              ".gml", ".dxf",     ".parquet",    ".mif",     ".tab",   ".mvt",
                              ".gmt", ".pmtiles", ".geoparquet", ".feather", ".arrow", ".jml"};
  if (std::find(kNames.begin(), kNames.end(), extension) == kNames.end()) return;
  throw Error(ErrorCode::UnknownFormat,
              extension +
                  " is not read; GDAL converts it: ogr2ogr -f GeoJSON -lco "
                  "COORDINATE_PRECISION=17 layer.geojson FILE" +
                  extension +
                  (is_gdal_format(path) ? " (or build plumb with it: PLUMB_WITH_GDAL)" : ""),
              {input_name(path)});
}

LayerText read_layer_text(const std::string& path, const LayerReadOptions& options,
                          Context& context) {
  require_layer_format(path);
  LayerText text;
  text.text = is_read_by_gdal(path) ? read_gdal_layer(path, options.object, text.notes, context)
                                    : read_input(path, context);
  return text;
}

namespace {

/// Whether an edge seems to cross the antimeridian: its ends are near to it, on different sides. An
/// edge from -180 to 180 leads around the map and does not cross it.
bool crosses_antimeridian(Point2 a, Point2 b) {
  constexpr double kNear = 150, kRound = 360;
  return a.x * b.x < 0 && std::fabs(a.x) > kNear && std::fabs(b.x) > kNear &&
         std::fabs(a.x - b.x) < kRound;
}

/// Returns the features with rings that seem to cross the antimeridian.
std::vector<std::uint32_t> features_across(const Layer& layer) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t f = 0; f < layer.feature_count(); ++f) {
    const std::uint32_t first = layer.polygon_begin[layer.feature_begin[f]];
    const std::uint32_t end = layer.polygon_begin[layer.feature_begin[f + 1]];
    bool is_across = false;
    for (std::uint32_t r = first; r < end && !is_across; ++r) {
      const std::span<const std::uint32_t> ring = layer.ring(r);
      std::uint32_t last = ring.back();
      for (const std::uint32_t corner : ring) {
        is_across = is_across ||
                    crosses_antimeridian(layer.points.approx(last), layer.points.approx(corner));
        last = corner;
      }
    }
    if (is_across) found.push_back(f);
  }
  return found;
}

bool is_on_globe(const Layer& layer) {
  constexpr double kLongitude = 180, kLatitude = 90;
  return std::all_of(layer.ring_corners.begin(), layer.ring_corners.end(), [&](std::uint32_t c) {
    const Point2 p = layer.points.approx(c);
    return std::fabs(p.x) <= kLongitude && std::fabs(p.y) <= kLatitude;
  });
}

/// Returns a note on the features that have an edge across the whole map, if there are some and the
/// coordinates may be degrees.
std::optional<std::string> antimeridian_note(const Layer& layer) {
  if (!is_on_globe(layer)) return {};
  const std::vector<std::uint32_t> across = features_across(layer);
  if (across.empty()) return {};
  std::string note = feature_title(layer, across.front());
  if (across.size() > 1) note += " and " + std::to_string(across.size() - 1) + " more";
  return note +
         ": an edge crosses the antimeridian, if coordinates are degrees; layers are flat, so "
         "this edge runs across the map";
}

}  // namespace

LayerFile read_layer(std::string_view text, const LayerReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  const ReadOptions read{.name = options.name};
  LayerFile file = naming_foreign_files(text, "GeoJSON TopoJSON WKT WKB", options.name, [&] {
    if (begins_like_wkb(text)) return layer_of_shapes(read_wkb(text, read, context), context);
    if (begins_like_wkt(text)) return layer_of_shapes(read_wkt(text, read, context), context);
    return read_json_layer(text, options, context);
  });
  if (std::optional<std::string> n = antimeridian_note(file.layer)) file.notes.push_back(*n);
  return file;
}

LayerFile read_layer_file(const std::string& path, LayerReadOptions options, Context& context) {
  options.name = input_name(path);
  const LayerText input = read_layer_text(path, options, context);
  LayerFile file = read_layer(input.text, options, context);
  file.notes.insert(file.notes.begin(), input.notes.begin(), input.notes.end());
  context.release_memory(input.text.size());
  return file;
}

}  // namespace plumb
