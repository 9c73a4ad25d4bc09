// Reading and writing of GeoJSON (RFC 7946).
//
// The reader is a state machine over events: a stack of open objects, each with the members seen so
// far, and for the coordinates of each object the levels of nested lists. Members come in any
// order, so coordinates may be read before their type is known. Therefore positions are collected
// with the ends of the lists around them, and the depth at which numbers occur is fixed by the
// first one; when the object ends its type says whether these lists are points, lines or rings.
// Nesting is limited, lists cost no recursion, and numbers are read from the text again, so they
// are exact where decimals are asked for exactly. Format: docs/formats.md, section GeoJSON.
// Tested by tests/io/geojson_test.cpp.
#include "plumb/io/plane/geojson.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/plane/shape_text.h"
#include "plumb/io/text/json_reader.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

// Numbers are read from the text again. The parser must only not refuse a large one that
// record_reader.h reads exactly.
using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                  std::uint64_t, long double>;

constexpr std::size_t kMostNestedObjects = 64;

/// Members with a meaning; the first four say what an object holds.
enum class Member : std::uint8_t { Coordinates, Geometries, Geometry, Features, Type, Other };

constexpr std::array<std::string_view, 5> kMemberNames{"coordinates", "geometries", "geometry",
                                                       "features", "type"};

Member member_named(std::string_view name) {
  const auto found = std::find(kMemberNames.begin(), kMemberNames.end(), name);
  return static_cast<Member>(found - kMemberNames.begin());
}

std::string quoted_name(Member member) {
  return '"' + std::string(kMemberNames[static_cast<std::size_t>(member)]) + '"';
}

struct Type {
  std::string_view name;
  Member content;
  int depth = 0;           ///< Depth of lists around a position.
  bool is_areal = false;   ///< Whether lists of positions are rings,
  bool is_points = false;  ///< Whether they are single points.
};

constexpr std::array<Type, 9> kTypes{{
    {"Point", Member::Coordinates, 0, false, true},
    {"MultiPoint", Member::Coordinates, 1, false, true},
    {"LineString", Member::Coordinates, 1},
    {"MultiLineString", Member::Coordinates, 2},
    {"Polygon", Member::Coordinates, 2, true},
    {"MultiPolygon", Member::Coordinates, 3, true},
    {"GeometryCollection", Member::Geometries},
    {"Feature", Member::Geometry},
    {"FeatureCollection", Member::Features},
}};

bool is_geometry(const Type& type) {
  return type.content == Member::Coordinates || type.content == Member::Geometries;
}

/// Coordinates of a geometry, whose type may not be known yet.
struct Coordinates {
  struct ListEnd {
    std::uint32_t position;
    const char* place;  ///< Its closing bracket.
  };
  const char* place = nullptr;
  int level = -1;    ///< Number of open lists, less one.
  int deepest = -1;  ///< Greatest level of a list so far.
  int depth = -1;    ///< Level of the positions; -1 if there is none yet.
  int numbers = 0;   ///< Numbers read of the current position.
  std::uint32_t first = 0;
  std::vector<ListEnd> lists;         ///< Ends of lists of positions; empty ones are left out.
  std::vector<std::size_t> polygons;  ///< Ends of lists of such lists, as indices into `lists`.
};

/// What an object may be.
enum class Role : std::uint8_t { Any, Geometry, Feature };

struct Object {
  const char* place;
  Role role;
  const Type* type = nullptr;
  Member member = Member::Other;  ///< The member whose value is being read.
  bool is_in_list = false;        ///< Whether the reader is among the objects of that member.
  unsigned seen = 0;              ///< A bit per member.
  Coordinates coordinates = {};

  static constexpr unsigned bit(Member member) { return 1U << static_cast<unsigned>(member); }
  bool has(Member m) const { return (seen & bit(m)) != 0; }
};

/// Returns a bound on the number of positions: each ends with a bracket, and "[0,0]," are six
/// bytes.
std::size_t most_positions(std::string_view text) {
  const auto ends = std::count(text.begin(), text.end(), ']');
  return std::min(static_cast<std::size_t>(ends), text.size() / 6);
}

class GeoJsonHandler : public nlohmann::json_sax<Json> {
 public:
  GeoJsonHandler(std::string_view text, const ReadOptions& options, Context& context)
      : places_(text, options.name, context),
        numbers_(context.limits(), options.exact_decimals, text.size()),
        shapes_(context, text.size()) {
    shapes_.expect(TextCursor(text, options.name), most_positions(text));
  }

  PlaneShapes read() {
    Json::sax_parse(places_.begin(), places_.end(), this);
    places_.require_end();
    return shapes_.take();
  }

  bool null() override { return take_scalar(Expected::ObjectOrNull); }
  bool boolean(bool) override { return take_scalar(Expected::Anything); }
  bool number_integer(number_integer_t) override { return take_number(); }
  bool number_unsigned(number_unsigned_t) override { return take_number(); }
  bool number_float(number_float_t, const string_t&) override { return take_number(); }
  bool string(string_t& value) override;
  bool binary(binary_t&) override { return false; }  // Does not occur in texts.
  bool start_object(std::size_t) override;
  bool key(string_t& name) override;
  bool end_object() override;
  bool start_array(std::size_t) override;
  bool end_array() override;
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override;

 private:
  enum class Expected : std::uint8_t { Object, ObjectOrNull, Array, String, Anything };

  Expected expected() const;
  [[noreturn]] void fail_expected() const;
  bool take_scalar(Expected kind);
  bool take_number();
  void set_type(const std::string& name);

  void open_list();
  void add_number();
  void close_list();
  [[noreturn]] void fail_uneven() const;

  void finish(const Object& object);
  void check_members(const Object& object) const;
  void add_coordinates(const Object& object);
  void add_lists(const Type& type, const Coordinates& coordinates);
  void require_good(const std::string& flaw, const char* where) const {
    if (!flaw.empty()) fail(ErrorCode::BadShape, flaw, where);
  }
  [[noreturn]] void fail(ErrorCode code, const std::string& message, const char* where) const {
    places_.fail(code, message, where);
  }

  JsonPlaces places_;
  NumberReader numbers_;
  ShapeCollector shapes_;
  std::vector<Object> objects_;  // Open objects.
  std::size_t skipped_ = 0;      // Number of open lists and objects without a meaning.
  // Whether the reader is in the coordinates of the innermost object.
  bool is_in_coordinates_ = false;
  ReadNumber x_, y_;
};

bool GeoJsonHandler::parse_error(std::size_t position, const std::string&,
                                 const nlohmann::detail::exception& error) {
  places_.fail_syntax(position, error.id, error.what());
}

// ---------------------------------------------------------------- structure

GeoJsonHandler::Expected GeoJsonHandler::expected() const {
  if (objects_.empty() || objects_.back().is_in_list) return Expected::Object;
  switch (objects_.back().member) {
    case Member::Type:
      return Expected::String;
    case Member::Geometry:
      return Expected::ObjectOrNull;
    case Member::Other:
      return Expected::Anything;
    default:
      return Expected::Array;
  }
}

void GeoJsonHandler::fail_expected() const {
  constexpr std::array<std::string_view, 4> kNames{"an object", "an object or null", "an array",
                                                   "a string"};
  std::string message = "expected ";
  message +=
      is_in_coordinates_ ? "a number or an array" : kNames[static_cast<std::size_t>(expected())];
  if (!objects_.empty()) message += " in " + quoted_name(objects_.back().member);
  fail(ErrorCode::Syntax, message, places_.token());
}

bool GeoJsonHandler::take_scalar(Expected kind) {
  places_.find_token();
  if (skipped_ > 0) return true;
  const Expected wanted = expected();
  if (is_in_coordinates_ || (wanted != kind && wanted != Expected::Anything)) fail_expected();
  return true;
}

bool GeoJsonHandler::string(string_t& value) {
  take_scalar(Expected::String);
  if (skipped_ == 0 && expected() == Expected::String) set_type(value);
  return true;
}

bool GeoJsonHandler::take_number() {
  places_.find_number();
  if (skipped_ > 0) return true;
  if (is_in_coordinates_) {
    add_number();
  } else if (expected() != Expected::Anything) {
    fail_expected();
  }
  return true;
}

void GeoJsonHandler::set_type(const std::string& name) {
  const auto found = std::find_if(kTypes.begin(), kTypes.end(),
                                  [&](const Type& type) { return type.name == name; });
  if (found == kTypes.end()) {
    fail(ErrorCode::Syntax, "the type is none of GeoJSON's: Point .. FeatureCollection",
         places_.token());
  }
  objects_.back().type = &*found;
}

bool GeoJsonHandler::start_object(std::size_t) {
  places_.find_token();
  const Expected wanted = expected();
  if (skipped_ > 0 || (!is_in_coordinates_ && wanted == Expected::Anything)) {
    ++skipped_;
    return true;
  }
  if (is_in_coordinates_ || wanted == Expected::Array || wanted == Expected::String) {
    fail_expected();
  }
  if (objects_.size() > kMostNestedObjects) {
    fail(ErrorCode::Syntax, "objects nested more than 64 deep", places_.token());
  }
  const Role role = objects_.empty()                             ? Role::Any
                    : objects_.back().member == Member::Features ? Role::Feature
                                                                 : Role::Geometry;
  objects_.push_back({places_.token(), role});
  return true;
}

bool GeoJsonHandler::key(string_t& name) {
  places_.find_token();
  if (skipped_ > 0) return true;
  Object& object = objects_.back();
  object.member = member_named(name);
  if (object.member == Member::Other) return true;
  if (object.has(object.member)) {
    fail(ErrorCode::Syntax, quoted_name(object.member) + " is given twice", places_.token());
  }
  object.seen |= Object::bit(object.member);
  return true;
}

bool GeoJsonHandler::end_object() {
  places_.find_token();
  if (skipped_ > 0) {
    --skipped_;
    return true;
  }
  finish(objects_.back());
  objects_.pop_back();
  return true;
}

bool GeoJsonHandler::start_array(std::size_t) {
  places_.find_token();
  const Expected wanted = expected();
  if (skipped_ > 0 || (!is_in_coordinates_ && wanted == Expected::Anything)) {
    ++skipped_;
  } else if (is_in_coordinates_) {
    open_list();
  } else if (wanted != Expected::Array) {
    fail_expected();
  } else if (objects_.back().member == Member::Coordinates) {
    is_in_coordinates_ = true;
    objects_.back().coordinates.place = places_.token();
    objects_.back().coordinates.first = shapes_.position_count();
    open_list();
  } else {
    objects_.back().is_in_list = true;
  }
  return true;
}

bool GeoJsonHandler::end_array() {
  places_.find_token();
  if (skipped_ > 0) {
    --skipped_;
  } else if (is_in_coordinates_) {
    close_list();
  } else {
    objects_.back().is_in_list = false;
  }
  return true;
}

// ---------------------------------------------------------------- coordinates

void GeoJsonHandler::fail_uneven() const {
  fail(ErrorCode::BadShape, "coordinates are nested unevenly", places_.token());
}

void GeoJsonHandler::open_list() {
  Coordinates& c = objects_.back().coordinates;
  ++c.level;
  c.deepest = std::max(c.deepest, c.level);
  c.numbers = 0;
  if (c.depth >= 0 && c.level > c.depth) fail_uneven();
}

void GeoJsonHandler::add_number() {
  Coordinates& c = objects_.back().coordinates;
  if (c.depth < 0) c.depth = c.level;
  // A list deeper than this one has occurred: its numbers would be no position.
  if (c.level != c.depth || c.deepest > c.depth) fail_uneven();
  ++c.numbers;
  if (c.numbers > 2) return;
  numbers_.read(places_.cursor_at_token(), places_.token_text(), c.numbers == 1 ? x_ : y_);
}

void GeoJsonHandler::close_list() {
  Coordinates& c = objects_.back().coordinates;
  const std::uint32_t count = shapes_.position_count();
  if (c.level == c.depth) {
    if (c.numbers < 2)
      fail(ErrorCode::BadShape, "a position needs two numbers, x and y", places_.token());
    shapes_.add_position(places_.cursor_at_token(), x_, y_);
  } else if (c.level + 1 == c.depth) {
    const std::uint32_t before = c.lists.empty() ? c.first : c.lists.back().position;
    if (count != before) c.lists.push_back({count, places_.token()});
  } else if (c.level + 2 == c.depth) {
    c.polygons.push_back(c.lists.size());
  }
  is_in_coordinates_ = --c.level >= 0;
}

// ---------------------------------------------------------------- finished objects

void GeoJsonHandler::finish(const Object& object) {
  check_members(object);
  if (object.type->content == Member::Coordinates) add_coordinates(object);
}

void GeoJsonHandler::check_members(const Object& object) const {
  if (object.type == nullptr) {
    fail(ErrorCode::Syntax, "an object without \"type\": is this GeoJSON?", object.place);
  }
  const std::string name(object.type->name);
  if (object.role == Role::Geometry && !is_geometry(*object.type)) {
    fail(ErrorCode::Syntax, "expected a geometry, found a " + name, object.place);
  }
  if (object.role == Role::Feature && object.type->content != Member::Geometry) {
    fail(ErrorCode::Syntax, "expected a Feature, found a " + name, object.place);
  }
  for (const Member m :
       {Member::Coordinates, Member::Geometries, Member::Geometry, Member::Features}) {
    const bool is_needed = m == object.type->content;
    if (object.has(m) == is_needed) continue;
    fail(ErrorCode::Syntax, "a " + name + (is_needed ? " needs " : " has no ") + quoted_name(m),
         object.place);
  }
}

void GeoJsonHandler::add_coordinates(const Object& object) {
  const Type& type = *object.type;
  const Coordinates& c = object.coordinates;
  const bool is_empty = c.depth < 0;
  if (is_empty ? c.deepest > type.depth : c.depth != type.depth) {
    fail(ErrorCode::BadShape,
         "coordinates of a " + std::string(type.name) + " are positions in " +
             std::to_string(type.depth) + " lists",
         c.place);
  }
  if (is_empty) return;
  if (type.is_points) {
    shapes_.add_points(c.first, shapes_.position_count());
  } else {
    add_lists(type, c);
  }
}

void GeoJsonHandler::add_lists(const Type& type, const Coordinates& c) {
  std::uint32_t first = c.first;
  auto polygon_end = c.polygons.begin();
  for (std::size_t i = 0; i < c.lists.size(); ++i) {
    while (polygon_end != c.polygons.end() && *polygon_end <= i) {
      shapes_.end_polygon();
      ++polygon_end;
    }
    const auto [last, place] = c.lists[i];
    require_good(type.is_areal ? shapes_.add_ring(first, last) : shapes_.add_line(first, last),
                 place);
    first = last;
  }
  if (type.is_areal) shapes_.end_polygon();
}

}  // namespace

PlaneShapes read_geojson(std::string_view text, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  return GeoJsonHandler(text, options, context).read();
}

namespace {

class GeoJsonWriter : public ShapeWriter {
 public:
  GeoJsonWriter(std::ostream& out, const PlaneShapes& shapes, Context& context)
      : ShapeWriter(out, shapes, {'[', ",", ']'}, context) {}

 private:
  void begin_collection(bool) override { out_ << R"({"type":"GeometryCollection","geometries":[)"; }
  void end_collection(bool) override { out_ << "]}"; }
  void begin_geometry(std::string_view name, bool is_multiple) override {
    out_ << R"({"type":")" << (is_multiple ? "Multi" : "") << name << R"(","coordinates":)";
  }
  void end_geometry() override { out_ << '}'; }
  void write_point(Point2 p) override { write_position(p); }
  void write_position(Point2 p) override { out_ << '[' << p.x << ',' << p.y << ']'; }
};

}  // namespace

void write_geojson(std::ostream& out, const PlaneShapes& shapes, Context& context) {
  GeoJsonWriter(out, shapes, context).write();
}

}  // namespace plumb
