// Reading and writing of GeoJSON (RFC 7946).
//
// The reader is a state machine over tokens: a stack of open objects, each with the members seen so
// far, and for the coordinates of an object the levels of nested lists. Members come in any order,
// so coordinates may be read before their type is known. Therefore positions are collected with the
// ends of the lists around them, and the depth at which numbers occur is fixed by the first one;
// when the object ends its type says whether these lists are points, lines or rings. Members
// without a meaning are skipped as soon as their name is read, and their values are not examined.
// Nesting is limited, lists cost no recursion, and nothing is allocated per geometry. Format:
// docs/formats.md, section GeoJSON.
// Tested by tests/io/geojson_test.cpp and tests/io/json_scanner_test.cpp.
#include "plumb/io/plane/geojson.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/plane/shape_text.h"
#include "plumb/io/text/json_scanner.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::size_t kMostNestedObjects = 64;
constexpr std::size_t kMostNamesNoted = 12;

/// The members with a meaning. The first four state the content of an object.
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

/// The coordinates of a geometry, whose type may not be known yet. The lists keep their memory from
/// one geometry to the next.
struct Coordinates {
  struct ListEnd {
    std::uint32_t position;
    const char* place;  ///< Its closing bracket.
  };
  const char* place = nullptr;
  const char* empty = nullptr;  ///< End of the first list without items at the deepest level.
  int level = -1;               ///< Number of open lists, less one.
  int deepest = -1;             ///< Greatest level of a list so far.
  int depth = -1;               ///< Level of the positions; -1 if there is none yet.
  int numbers = 0;              ///< Numbers read of the current position.
  std::uint32_t first = 0;
  std::vector<ListEnd> lists;         ///< Ends of lists of positions; empty ones are left out.
  std::vector<std::size_t> polygons;  ///< Ends of lists of such lists, as indices into `lists`.

  void restart(const char* start, std::uint32_t first_position) {
    place = start;
    empty = nullptr;
    level = deepest = depth = -1;
    first = first_position;
    lists.clear();
    polygons.clear();
  }
};

/// The kinds that an object may have.
enum class Role : std::uint8_t { Any, Geometry, Feature };

struct Object {
  const char* place;
  Role role;
  const Type* type = nullptr;
  Member member = Member::Other;  ///< The member whose value is being read.
  bool is_in_list = false;        ///< Whether the reader is among the objects of that member.
  unsigned seen = 0;              ///< One bit for each member.

  static constexpr unsigned bit(Member member) { return 1U << static_cast<unsigned>(member); }
  bool has(Member m) const { return (seen & bit(m)) != 0; }
};

/// Returns a bound on the number of positions. Each position ends with a bracket, and "[0,0]," has
/// six bytes.
std::size_t most_positions(std::string_view text) {
  const auto ends = std::count(text.begin(), text.end(), ']');
  return std::min(static_cast<std::size_t>(ends), text.size() / 6);
}

/// Whether the value of a member states that there is none.
bool is_nothing(std::string_view value) {
  return value == "null" || value == "{}" || value == "[]";
}

class GeoJsonReader {
 public:
  GeoJsonReader(std::string_view text, const ReadOptions& options, Context& context)
      : json_(text, options.name, context),
        numbers_(context, options.exact_decimals, text.size()),
        keeps_features_(options.attributes),
        shapes_(context, text.size()) {
    shapes_.expect(TextCursor(text, options.name), most_positions(text));
  }

  PlaneFile read();

 private:
  enum class Expected : std::uint8_t { Object, ObjectOrNull, Array, String };

  void take(JsonToken token);
  Expected expected() const;
  [[noreturn]] void fail_expected() const;
  void require(Expected kind) const {
    if (is_in_coordinates_ || expected() != kind) fail_expected();
  }
  void begin_object();
  void end_object();
  void begin_array();
  void end_array();
  void take_name();
  void pass_over(std::string_view name);
  void take_type();
  void take_word(JsonToken token);

  void open_list();
  void take_number();
  bool take_no_number();
  void close_list();
  [[noreturn]] void fail_uneven() const;

  void finish(const Object& object);
  void check_members(const Object& object) const;
  void add_coordinates(const Type& type);
  void add_lists(const Type& type);
  void require_good(const std::string& flaw, const char* where) const {
    if (!flaw.empty()) fail(ErrorCode::BadShape, flaw, where);
  }
  [[noreturn]] void fail(ErrorCode code, const std::string& message, const char* where) const {
    json_.fail(code, message, where);
  }

  JsonScanner json_;
  NumberReader numbers_;
  bool keeps_features_;  // Whether the caller keeps ids and properties.
  ShapeCollector shapes_;
  std::vector<Object> objects_;  // The objects that are open.
  // The coordinates of the object that had coordinates last.
  Coordinates coordinates_;
  bool is_in_coordinates_ = false;              // Whether the reader is in the coordinates.
  bool has_more_numbers_ = false;               // Whether a position had numbers after x and y.
  std::size_t null_geometries_ = 0;             // Features and members without a geometry.
  std::vector<std::string_view> passed_names_;  // The names of members that were skipped.
  ReadNumber x_, y_;
};

PlaneFile GeoJsonReader::read() {
  for (JsonToken token = json_.next(); token != JsonToken::End; token = json_.next()) take(token);
  if (has_more_numbers_) shapes_.pass_over("numbers of positions after x and y");
  // For a file without any shape, a note states that it is empty.
  if (null_geometries_ > 0 && shapes_.position_count() > 0) {
    shapes_.pass_over("geometries that are null (" + std::to_string(null_geometries_) + ')');
  }
  return shapes_.take();
}

void GeoJsonReader::take(JsonToken token) {
  switch (token) {
    case JsonToken::BeginObject:
      return begin_object();
    case JsonToken::EndObject:
      return end_object();
    case JsonToken::BeginArray:
      return begin_array();
    case JsonToken::EndArray:
      return end_array();
    case JsonToken::Name:
      return take_name();
    case JsonToken::String:
      return take_type();
    case JsonToken::Number:
      return take_number();
    default:
      return take_word(token);
  }
}

// ---------------------------------------------------------------- structure

GeoJsonReader::Expected GeoJsonReader::expected() const {
  if (objects_.empty()) return Expected::Object;
  if (objects_.back().is_in_list) {
    return objects_.back().member == Member::Geometries ? Expected::ObjectOrNull : Expected::Object;
  }
  switch (objects_.back().member) {
    case Member::Type:
      return Expected::String;
    case Member::Geometry:
      return Expected::ObjectOrNull;
    default:
      return Expected::Array;
  }
}

void GeoJsonReader::fail_expected() const {
  constexpr std::array<std::string_view, 4> kNames{"an object", "an object or null", "an array",
                                                   "a string"};
  std::string message = "expected ";
  message +=
      is_in_coordinates_ ? "a number or an array" : kNames[static_cast<std::size_t>(expected())];
  if (!objects_.empty()) message += " in " + quoted_name(objects_.back().member);
  fail(ErrorCode::Syntax, message, json_.token());
}

/// Processes null, true, false or a word that is not JSON.
void GeoJsonReader::take_word(JsonToken token) {
  if (is_in_coordinates_ && take_no_number()) return;
  const std::string_view word = json_.token_text();
  if (token == JsonToken::Word && word != "true" && word != "false") {
    fail(ErrorCode::Syntax, "not JSON: invalid literal " + quoted(word), json_.token());
  }
  if (token != JsonToken::Null) fail_expected();
  require(Expected::ObjectOrNull);
  ++null_geometries_;
}

void GeoJsonReader::take_type() {
  require(Expected::String);
  const std::string_view name = json_.string_text();
  const auto found = std::find_if(kTypes.begin(), kTypes.end(),
                                  [&](const Type& type) { return type.name == name; });
  if (found == kTypes.end()) {
    fail(ErrorCode::Syntax, "the type is none of GeoJSON's: Point .. FeatureCollection",
         json_.token());
  }
  objects_.back().type = &*found;
}

void GeoJsonReader::begin_object() {
  const Expected wanted = expected();
  if (is_in_coordinates_ || wanted == Expected::Array || wanted == Expected::String) {
    fail_expected();
  }
  if (objects_.size() > kMostNestedObjects) {
    fail(ErrorCode::Syntax, "objects nested more than 64 deep", json_.token());
  }
  const Role role = objects_.empty()                             ? Role::Any
                    : objects_.back().member == Member::Features ? Role::Feature
                                                                 : Role::Geometry;
  objects_.push_back({json_.token(), role});
}

void GeoJsonReader::take_name() {
  Object& object = objects_.back();
  const std::string_view name = json_.string_text();
  object.member = member_named(name);
  if (object.member == Member::Other) return pass_over(name);
  if (object.has(object.member)) {
    fail(ErrorCode::Syntax, quoted_name(object.member) + " is given twice", json_.token());
  }
  object.seen |= Object::bit(object.member);
}

/// Skips a member without a meaning for shapes. The first ones with different names are noted.
void GeoJsonReader::pass_over(std::string_view name) {
  const std::string_view written = json_.token_text();
  const bool is_kept = keeps_features_ && (name == "id" || name == "properties");
  const bool is_worth_a_note = !is_nothing(json_.skip_value()) && !is_kept;
  if (!is_worth_a_note || passed_names_.size() > kMostNamesNoted) return;
  if (std::ranges::find(passed_names_, written) != passed_names_.end()) return;
  passed_names_.push_back(written);
  shapes_.pass_over(passed_names_.size() > kMostNamesNoted ? "other members" : quoted(name));
}

void GeoJsonReader::end_object() {
  finish(objects_.back());
  objects_.pop_back();
}

void GeoJsonReader::begin_array() {
  if (is_in_coordinates_) return open_list();
  require(Expected::Array);
  Object& object = objects_.back();
  if (object.member != Member::Coordinates) {
    object.is_in_list = true;
    return;
  }
  is_in_coordinates_ = true;
  coordinates_.restart(json_.token(), shapes_.position_count());
  open_list();
}

void GeoJsonReader::end_array() {
  if (is_in_coordinates_) return close_list();
  objects_.back().is_in_list = false;
}

// ---------------------------------------------------------------- coordinates

void GeoJsonReader::fail_uneven() const {
  fail(ErrorCode::BadShape, "coordinates are nested unevenly", json_.token());
}

void GeoJsonReader::open_list() {
  Coordinates& c = coordinates_;
  ++c.level;
  if (c.level > c.deepest) {
    c.deepest = c.level;
    c.empty = nullptr;
  }
  c.numbers = 0;
  if (c.depth >= 0 && c.level > c.depth) fail_uneven();
}

void GeoJsonReader::take_number() {
  if (!is_in_coordinates_) fail_expected();
  Coordinates& c = coordinates_;
  if (c.depth < 0) c.depth = c.level;
  // A list that is nested more deeply has occurred, so the numbers would not be a position.
  if (c.level != c.depth || c.deepest > c.depth) fail_uneven();
  ++c.numbers;
  if (c.numbers > 2) {
    has_more_numbers_ = true;
    return;
  }
  numbers_.read(json_.cursor_at_token(), json_.token_text(), c.numbers == 1 ? x_ : y_);
}

/// Skips null or a word such as NaN in place of a number after x and y, which is not used.
bool GeoJsonReader::take_no_number() {
  Coordinates& c = coordinates_;
  if (c.level != c.depth || c.numbers < 2) return false;
  ++c.numbers;
  has_more_numbers_ = true;
  return true;
}

void GeoJsonReader::close_list() {
  Coordinates& c = coordinates_;
  const std::uint32_t count = shapes_.position_count();
  if (c.level == c.deepest && c.numbers == 0) {
    if (c.empty == nullptr) c.empty = json_.token();
  } else if (c.level == c.depth) {
    if (c.numbers < 2)
      fail(ErrorCode::BadShape, "a position needs two numbers, x and y", json_.token());
    shapes_.add_position(json_.cursor_at_token(), x_, y_);
  } else if (c.level + 1 == c.depth) {
    const std::uint32_t before = c.lists.empty() ? c.first : c.lists.back().position;
    if (count != before) c.lists.push_back({count, json_.token()});
  } else if (c.level + 2 == c.depth) {
    c.polygons.push_back(c.lists.size());
  }
  is_in_coordinates_ = --c.level >= 0;
}

// ---------------------------------------------------------------- finished objects

void GeoJsonReader::finish(const Object& object) {
  check_members(object);
  if (object.type->content == Member::Coordinates) add_coordinates(*object.type);
  const bool is_feature = object.type->content == Member::Geometry;
  if (is_feature && !object.has(Member::Geometry)) ++null_geometries_;
}

void GeoJsonReader::check_members(const Object& object) const {
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
    // If a feature has no geometry, some programs leave out the member.
    const bool may_lack = is_needed && m == Member::Geometry;
    if (object.has(m) == is_needed || may_lack) continue;
    fail(ErrorCode::Syntax, "a " + name + (is_needed ? " needs " : " has no ") + quoted_name(m),
         object.place);
  }
}

/// Adds the coordinates that were read last. They belong to the object that ends, because
/// check_members() refuses an object that has both coordinates and inner objects.
void GeoJsonReader::add_coordinates(const Type& type) {
  const Coordinates& c = coordinates_;
  const bool is_empty = c.depth < 0;
  if (is_empty ? c.deepest > type.depth : c.depth != type.depth) {
    fail(ErrorCode::BadShape,
         "coordinates of a " + std::string(type.name) + " are positions in " +
             std::to_string(type.depth) + " lists",
         c.place);
  }
  if (is_empty) return;
  if (type.is_points) return shapes_.add_points(c.first, shapes_.position_count());
  if (c.empty != nullptr) {
    fail(ErrorCode::BadShape, "a position needs two numbers, x and y", c.empty);
  }
  add_lists(type);
}

void GeoJsonReader::add_lists(const Type& type) {
  const Coordinates& c = coordinates_;
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

PlaneFile read_geojson(std::string_view text, const ReadOptions& options, Context& context) {
  if (text.find_first_not_of(" \t\r\n") == text.npos) {
    TextCursor cursor(text, options.name);
    cursor.next_line();
    cursor.fail(ErrorCode::CountMismatch, "the file has no content");
  }
  const RoundToNearest rounding;
  return GeoJsonReader(text, options, context).read();
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
