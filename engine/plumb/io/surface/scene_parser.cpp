// Parsing of scenes: JSON events to lists of points, polygons, shapes, levels and drawings.
//
// SceneHandler is a state machine over the events of nlohmann-json: the member being read, the
// depth of lists in it, and a count of open values that have no meaning and are skipped. Each index
// is kept with its byte in the text, so an error found later still has a place. Numbers are read
// again from the text, exactly.
//
// ScenePointReader decides what decimals mean: a point well inside its face becomes the nearest
// doubles, and a point on or near a side is kept exactly as written, with sums within 2^-52 of a
// side put on it. A fraction always means itself. Format: docs/formats.md, section Scenes.
// Tested by tests/io/scene_reader_test.cpp.
#include "plumb/io/surface/scene_parser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/json_reader.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

// At least this far from the sides, rounding a weight has no effect on the topology.
constexpr double kClear = 0x1p-40;
constexpr std::uint64_t kBytesPerPoint = 2 * (sizeof(Point2) + 2 * sizeof(std::size_t));

const Rational& tiny() {
  static const Rational value = exact_rational(0x1p-52);
  return value;
}

}  // namespace

ScenePointReader::ScenePointReader(std::string_view text, const ReadOptions& options,
                                   JsonPlaces& places, Context& context)
    : text_(text.data()),
      places_(places),
      nearest_(context, options.exact_decimals, text.size()),
      exact_(context, true, text.size()),
      exact_decimals_(options.exact_decimals),
      context_(context) {}

void ScenePointReader::begin(std::size_t place) {
  place_ = place;
  numbers_ = 0;
}

void ScenePointReader::set_face(std::uint32_t face) {
  face_ = face;
  numbers_ = 1;
}

void ScenePointReader::read_weight(std::string_view token) {
  if (numbers_ > 2) {
    places_.fail(ErrorCode::Syntax, "a point is [face, u, v]: too many numbers", places_.token());
  }
  nearest_.read(places_.cursor_at_token(), token, weights_[numbers_ - 1]);
  tokens_[numbers_ - 1] = token;
  ++numbers_;
}

void ScenePointReader::end(ScenePoints& to) {
  if (numbers_ < 3) {
    places_.fail(ErrorCode::Syntax, "a point is [face, u, v]: too few numbers", places_.token());
  }
  with_place(places_.cursor_at_token(), [&] {
    context_.charge_memory(kBytesPerPoint + exact_bytes(weights_[0], weights_[1]), "the scene");
  });
  to.face.push_back(face_);
  to.place.push_back(place_);
  const auto any_has = [this](const char* characters) {
    return tokens_[0].find_first_of(characters) != std::string_view::npos ||
           tokens_[1].find_first_of(characters) != std::string_view::npos;
  };
  // A fraction is exact. A decimal in the same point is rounded independently, even if the sum of
  // the weights is then not 1.
  const bool is_fraction = any_has("/"), is_decimal = !exact_decimals_ && any_has(".eE");
  to.rounds.push_back(is_decimal && !is_fraction ? 1 : 0);
  if (weights_[0].is_double() && weights_[1].is_double()) {
    const double u = weights_[0].as_double(), v = weights_[1].as_double();
    if (u > kClear && v > kClear && u + v < 1 - kClear) {
      to.weights.push_back({u, v});
      return;
    }
  }
  std::array<Rational, 2> weights;
  for (std::size_t i = 0; i < 2; ++i) {
    // If the nearest double of a weight is zero, the weight is zero, even if it is not exactly
    // zero.
    const bool is_zero = weights_[i].is_double() && weights_[i].as_double() == 0;
    if (!is_fraction && !is_zero) {
      exact_.read(places_.cursor_at_token(), tokens_[i], weights_[i]);
    }
    weights[i] = weights_[i].exact();
  }
  add_near_side(weights, is_decimal, to);
}

/// Adds a point on a side or near a side. The point is stored exactly as written, except for the
/// rounding that decimals allow.
void ScenePointReader::add_near_side(const std::array<Rational, 2>& weights, bool is_decimal,
                                     ScenePoints& to) {
  auto [u, v] = weights;
  const Rational rest = 1 - u - v;
  if (u < -tiny() || v < -tiny() || rest < -tiny()) {
    places_.fail(ErrorCode::BadShape, "a point outside its face: u, v and 1 - u - v are weights",
                 text_ + place_);
  }
  if (u < 0) u = 0;
  if (v < 0) v = 0;
  if (u + v > 1 || (is_decimal && rest <= tiny())) {
    u = u > 1 ? Rational(1) : u;
    v = 1 - u;
  }
  if (to.rounds.back() != 0 && u > 0 && v > 0 && u + v < 1) {
    const double x = nearest_double(u), y = nearest_double(v);
    if (x > 0 && y > 0 && exact_rational(x) + exact_rational(y) < 1) {
      to.weights.push_back({x, y});
      return;
    }
  }
  to.weights.push_back(u, v);
}

// Step 1 of scene_reader.h: the text as JSON, member by member.

namespace {

// Numbers are read again from the text. The parser only must not refuse a large number.
using Json = nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t,
                                  std::uint64_t, long double>;

enum class Member : std::uint8_t {
  Model,
  Points,
  Polygons,
  Shapes,
  Outside,
  Levels,
  Svg,
  Paths,
  Other
};
constexpr std::array<std::string_view, 8> kMemberNames{"model",   "points", "polygons", "shapes",
                                                       "outside", "levels", "svg",      "paths"};
/// Members of a drawing.
enum class Part : std::uint8_t { File, Center, Scale, Angle, Tolerance, Other };
constexpr std::array<std::string_view, 5> kPartNames{"file", "center", "scale", "angle",
                                                     "tolerance"};
constexpr std::uint64_t kBytesPerIndex = 2 * (sizeof(std::uint32_t) + sizeof(std::size_t));
constexpr std::uint32_t kMost = 0x3fff'ffff;

std::string quoted_name(std::string_view name) { return '"' + std::string(name) + '"'; }
std::string quoted_name(Member member) {
  return quoted_name(kMemberNames[static_cast<std::size_t>(member)]);
}
std::string quoted_name(Part part) {
  return quoted_name(kPartNames[static_cast<std::size_t>(part)]);
}

class SceneHandler : public nlohmann::json_sax<Json> {
 public:
  SceneHandler(std::string_view text, const ReadOptions& options, Context& context)
      : begin_(text.data()),
        places_(text, options.name, context),
        points_(text, options, places_, context),
        numbers_reader_(context, false, text.size()),
        context_(context) {}

  ParsedScene read() {
    Json::sax_parse(places_.begin(), places_.end(), this);
    places_.require_end();
    check_members();
    check_indices(scene_.polygons, scene_.points.size(), "point");
    if (scene_.shapes) check_indices(*scene_.shapes, scene_.polygons.size(), "polygon");
    if (scene_.drawings.empty()) check_levels();
    return std::move(scene_);
  }

  bool null() override { return take_other(); }
  bool boolean(bool) override { return take_other(); }
  bool number_integer(number_integer_t value) override { return take_number({}, value); }
  bool number_unsigned(number_unsigned_t value) override { return take_number(value); }
  bool number_float(number_float_t, const string_t&) override { return take_number({}); }
  bool binary(binary_t&) override { return false; }  // The event does not occur in texts.
  bool string(string_t& value) override;
  bool start_object(std::size_t) override;
  bool key(string_t& name) override;
  bool end_object() override;
  bool start_array(std::size_t) override;
  bool end_array() override;
  bool parse_error(std::size_t position, const std::string&,
                   const nlohmann::detail::exception& error) override {
    places_.fail_syntax(position, error.id, error.what());
  }

 private:
  std::size_t place() const { return static_cast<std::size_t>(places_.token() - begin_); }
  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    places_.fail(code, message, places_.token());
  }
  [[noreturn]] void fail_expected(const std::string& what) const {
    fail(ErrorCode::Syntax, "expected " + what + (is_open_ ? " in " + quoted_name(member_) : ""));
  }
  bool means_something() const { return skipped_ == 0; }
  bool is_other() const {
    return is_open_ && (is_drawing_ ? part_ == Part::Other : member_ == Member::Other);
  }
  bool is_in_point() const {
    return is_drawing_ ? is_in_center_ : is_open_ && member_ == Member::Points && depth_ == 2;
  }
  std::string expected() const;
  bool take_other();
  bool take_number(std::optional<std::uint64_t> value, std::optional<std::int64_t> negative = {});
  void add_to_drawing();
  void end_drawing();
  std::uint32_t index_of(std::optional<std::uint64_t> value) const;
  void add_index(ParsedScene::Lists& lists, std::uint32_t index);
  void end_list(ParsedScene::Lists& lists);
  void add_to_level(std::optional<std::uint64_t> value, std::optional<std::int64_t> negative);
  void end_level();
  ParsedScene::Lists& lists() {
    return member_ == Member::Polygons ? scene_.polygons : *scene_.shapes;
  }
  void check_members() const;
  void check_levels() const;
  void check_indices(const ParsedScene::Lists& lists, std::size_t count, const char* what) const;

  const char* begin_;
  JsonPlaces places_;
  ScenePointReader points_;
  NumberReader numbers_reader_;  // Reads the numbers of drawings.
  Context& context_;
  ParsedScene scene_;

  bool is_open_ = false;  // Whether the object is open, and which of its members is being read.
  Member member_ = Member::Other;
  std::array<bool, kMemberNames.size()> seen_{};
  int depth_ = 0;            // The number of open lists in the member.
  std::size_t skipped_ = 0;  // The number of open lists and objects without a meaning.

  // The level being read.
  std::size_t numbers_ = 0;
  std::size_t level_place_ = 0;
  SurfaceLevel level_{};

  // The drawing being read.
  bool is_drawing_ = false;
  bool is_in_center_ = false;
  Part part_ = Part::Other;
  std::array<bool, kPartNames.size()> has_part_{};
  ParsedScene::Drawing drawing_;
};

// ---------------------------------------------------------------- structure

bool is_list(Member member) {
  return member == Member::Points || member == Member::Polygons || member == Member::Shapes ||
         member == Member::Levels || member == Member::Svg;
}

std::string SceneHandler::expected() const {
  if (!is_open_) return "an object";
  if (is_in_point()) return points_.needs_face() ? "the index of a face" : "a number or a fraction";
  if (is_drawing_) {
    return part_ == Part::File     ? "a file name"
           : part_ == Part::Center ? "a point [face, u, v]"
                                   : "a number";
  }
  if (member_ == Member::Svg) return depth_ == 0 ? "a drawing or a list of them" : "a drawing";
  if (member_ == Member::Model) return "a file name";
  if (member_ == Member::Outside) return "the index of a face";
  if (member_ == Member::Paths) return "\"local\" or \"shortest\"";
  if (depth_ == 0) return "a list";
  if (member_ == Member::Levels) {
    return depth_ == 1 ? "a level [shape, face, label]" : (numbers_ < 2 ? "an index" : "a label");
  }
  if (member_ == Member::Points) return "a point [face, u, v]";
  return depth_ == 1 ? "a list of indices" : "an index";
}

bool SceneHandler::take_other() {
  places_.find_token();
  if (means_something() && !is_other()) fail_expected(expected());
  return true;
}

bool SceneHandler::start_object(std::size_t) {
  places_.find_token();
  if (!means_something() || is_other()) {
    ++skipped_;
  } else if (!is_open_) {
    is_open_ = true;
  } else if (member_ == Member::Svg && !is_drawing_) {
    is_drawing_ = true;
    part_ = Part::Other;
    has_part_ = {};
    drawing_ = {};
    drawing_.place = place();
  } else {
    fail_expected(expected());
  }
  return true;
}

bool SceneHandler::key(string_t& name) {
  places_.find_token();
  if (!means_something()) return true;
  if (is_drawing_) {
    const auto part = std::find(kPartNames.begin(), kPartNames.end(), name);
    part_ = static_cast<Part>(part - kPartNames.begin());
    if (part_ != Part::Other && std::exchange(has_part_[static_cast<std::size_t>(part_)], true)) {
      fail(ErrorCode::Syntax, quoted_name(part_) + " is given twice");
    }
    return true;
  }
  const auto found = std::find(kMemberNames.begin(), kMemberNames.end(), name);
  member_ = static_cast<Member>(found - kMemberNames.begin());
  if (member_ == Member::Other) return true;
  if (std::exchange(seen_[static_cast<std::size_t>(member_)], true)) {
    fail(ErrorCode::Syntax, quoted_name(member_) + " is given twice");
  }
  if (member_ == Member::Shapes) scene_.shapes.emplace();
  return true;
}

bool SceneHandler::end_object() {
  places_.find_token();
  if (skipped_ > 0) {
    --skipped_;
  } else if (is_drawing_) {
    end_drawing();
  }
  return true;
}

bool SceneHandler::start_array(std::size_t) {
  places_.find_token();
  if (!means_something() || is_other()) {
    ++skipped_;
    return true;
  }
  if (is_drawing_) {
    if (part_ != Part::Center || is_in_center_) fail_expected(expected());
    is_in_center_ = true;
    points_.begin(place());
    return true;
  }
  const int deepest = member_ == Member::Svg ? 1 : 2;
  if (!is_open_ || !is_list(member_) || depth_ == deepest) fail_expected(expected());
  ++depth_;
  if (is_in_point()) points_.begin(place());
  level_place_ = place();
  numbers_ = 0;
  return true;
}

bool SceneHandler::end_array() {
  places_.find_token();
  if (skipped_ > 0) {
    --skipped_;
    return true;
  }
  if (is_drawing_) {
    points_.end(scene_.centers);
    is_in_center_ = false;
    return true;
  }
  if (depth_ == 2) {
    if (member_ == Member::Points) {
      points_.end(scene_.points);
    } else if (member_ == Member::Levels) {
      end_level();
    } else {
      end_list(lists());
    }
  }
  --depth_;
  return true;
}

void SceneHandler::check_members() const {
  const bool has_drawing = seen_[static_cast<std::size_t>(Member::Svg)];
  for (const Member m : {Member::Model, Member::Points, Member::Polygons}) {
    if (seen_[static_cast<std::size_t>(m)] || (m != Member::Model && has_drawing)) continue;
    places_.fail(ErrorCode::Syntax, "a scene needs " + quoted_name(m), begin_);
  }
}

void SceneHandler::check_indices(const ParsedScene::Lists& lists, std::size_t count,
                                 const char* what) const {
  for (std::size_t i = 0; i < lists.items.size(); ++i) {
    if (lists.items[i] < count) continue;
    places_.fail(ErrorCode::BadIndex,
                 "no " + std::string(what) + ' ' + std::to_string(lists.items[i]) + ": there are " +
                     std::to_string(count) + ", counted from 0",
                 begin_ + lists.places[i]);
  }
}

/// Checks the shapes of levels. If there are drawings, the number of shapes is not yet known, and
/// make_scene() checks them.
void SceneHandler::check_levels() const {
  const std::size_t shapes = scene_.shapes ? scene_.shapes->size() : scene_.polygons.size();
  for (const auto& [level, place] : scene_.levels) {
    if (level.shape < shapes) continue;
    places_.fail(ErrorCode::BadIndex,
                 "no shape " + std::to_string(level.shape) + ": there are " +
                     std::to_string(shapes) + ", counted from 0",
                 begin_ + place);
  }
}

// ---------------------------------------------------------------- values

bool SceneHandler::string(string_t& value) {
  places_.find_token();
  if (!means_something() || is_other()) return true;
  const bool is_file = is_open_ && (is_drawing_ ? part_ == Part::File : member_ == Member::Model);
  if (is_file) {
    constexpr std::size_t kLongest = 4095;  // The longest name that systems allow.
    const bool is_path = value.size() <= kLongest && value.find('\0') == value.npos;
    if (value.empty() || !is_path) fail_expected("a file name");
    (is_drawing_ ? drawing_.file : scene_.model) = value;
    return true;
  }
  if (is_open_ && !is_drawing_ && member_ == Member::Paths) {
    if (value != "local" && value != "shortest") fail_expected(expected());
    scene_.has_shortest_paths = value == "shortest";
    return true;
  }
  if (!is_in_point() || points_.needs_face()) fail_expected(expected());
  const std::string_view token = places_.token_text();
  if (token.size() < 3 || token.substr(1, token.size() - 2) != value ||
      value.find(' ') != value.npos) {
    fail_expected(expected());
  }
  points_.read_weight(token.substr(1, token.size() - 2));
  return true;
}

bool SceneHandler::take_number(std::optional<std::uint64_t> value,
                               std::optional<std::int64_t> negative) {
  places_.find_number();
  if (!means_something() || is_other()) return true;
  if (is_in_point()) {
    if (points_.needs_face()) {
      points_.set_face(index_of(value));
    } else {
      points_.read_weight(places_.token_text());
    }
  } else if (is_drawing_) {
    add_to_drawing();
  } else if (is_open_ && member_ == Member::Outside) {
    scene_.outside = index_of(value);
    scene_.outside_place = place();
  } else if (!is_open_ || depth_ < 2) {
    fail_expected(expected());
  } else if (member_ == Member::Levels) {
    add_to_level(value, negative);
  } else {
    add_index(lists(), index_of(value));
  }
  return true;
}

std::uint32_t SceneHandler::index_of(std::optional<std::uint64_t> value) const {
  if (!value) fail_expected(is_in_point() ? expected() : "an index");
  if (*value > kMost) fail(ErrorCode::BadIndex, "an index too large for any scene");
  return static_cast<std::uint32_t>(*value);
}

void SceneHandler::add_index(ParsedScene::Lists& lists, std::uint32_t index) {
  with_place(places_.cursor_at_token(),
             [&] { context_.charge_memory(kBytesPerIndex, "the scene"); });
  lists.items.push_back(index);
  lists.places.push_back(place());
}

void SceneHandler::end_list(ParsedScene::Lists& lists) {
  with_place(places_.cursor_at_token(),
             [&] { context_.charge_memory(kBytesPerIndex, "the scene"); });
  lists.begin.push_back(static_cast<std::uint32_t>(lists.items.size()));
}

void SceneHandler::add_to_level(std::optional<std::uint64_t> value,
                                std::optional<std::int64_t> negative) {
  constexpr std::uint32_t kMostLabel = 0x3fff'ffff;
  if (numbers_ == 0) level_.shape = index_of(value);
  if (numbers_ == 1) level_.face = FaceId(index_of(value));
  if (numbers_ == 2) {
    if (!value && !negative) fail_expected(expected());
    if (value ? *value > kMostLabel : *negative < -std::int64_t{kMostLabel}) {
      fail(ErrorCode::NumberOutOfRange, "a label too large");
    }
    level_.label = value ? static_cast<std::int32_t>(*value) : static_cast<std::int32_t>(*negative);
  }
  if (++numbers_ > 3) fail(ErrorCode::Syntax, "a level is [shape, face, label]: too many numbers");
}

void SceneHandler::end_level() {
  if (numbers_ < 3) fail(ErrorCode::Syntax, "a level is [shape, face, label]: too few numbers");
  with_place(places_.cursor_at_token(),
             [&] { context_.charge_memory(2 * sizeof(ParsedScene::Level), "the scene"); });
  scene_.levels.push_back({level_, level_place_});
}

// ---------------------------------------------------------------- drawings

void SceneHandler::add_to_drawing() {
  if (part_ == Part::File || part_ == Part::Center) fail_expected(expected());
  ReadNumber number;
  numbers_reader_.read(places_.cursor_at_token(), places_.token_text(), number);
  const double value = number.is_double() ? number.as_double() : nearest_double(number.exact());
  if (!std::isfinite(value)) fail(ErrorCode::NumberOutOfRange, "beyond the largest double");
  if (part_ != Part::Angle && value <= 0) {
    fail(ErrorCode::BadShape, quoted_name(part_) + " is not above zero");
  }
  if (part_ == Part::Scale) drawing_.scale = value;
  if (part_ == Part::Angle) drawing_.angle = value;
  if (part_ == Part::Tolerance) drawing_.tolerance = value;
}

void SceneHandler::end_drawing() {
  for (const Part p : {Part::File, Part::Center, Part::Scale}) {
    if (!has_part_[static_cast<std::size_t>(p)]) {
      places_.fail(ErrorCode::Syntax, "a drawing needs " + quoted_name(p), begin_ + drawing_.place);
    }
  }
  with_place(places_.cursor_at_token(), [&] {
    context_.charge_memory(2 * (sizeof(ParsedScene::Drawing) + drawing_.file.size()), "the scene");
  });
  scene_.drawings.push_back(std::move(drawing_));
  is_drawing_ = false;
}

}  // namespace

ParsedScene parse_scene(std::string_view text, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  return SceneHandler(text, options, context).read();
}

}  // namespace plumb
