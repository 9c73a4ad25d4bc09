// Reading and writing of well-known text.
//
// A recursive-descent reader over tokens, with one token of lookahead across line breaks.
// Collections are the only recursion and are limited in depth. The number of positions is bounded
// by the commas and parentheses of the text, so the table is reserved and charged once before
// reading. Flaws of a list (a ring of two positions, a line of one position) are reported at its
// closing parenthesis. Dialects differ in the text around geometries, and in the numbers behind x
// and y. All of this is read and dropped, and a note names it. Curves are refused: edges of sets
// are straight, and a reader cannot know how fine a chain of edges must be. Format: OGC 06-103r4,
// Simple feature access, part 1 (2011), section on well-known text; docs/formats.md, section WKT.
// Tested by tests/io/wkt_test.cpp.
#include "plumb/io/plane/wkt.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "plumb/io/plane/shape_text.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/lines.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/io/text/watched_scan.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::string_view kMarks = "(),;>";

constexpr char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

bool is_word(std::string_view token, std::string_view upper_case) {
  return std::equal(token.begin(), token.end(), upper_case.begin(), upper_case.end(),
                    [](char a, char b) { return upper(a) == b; });
}

bool is_mark(std::string_view token) { return kMarks.find(token.front()) != kMarks.npos; }

bool starts_with_word(std::string_view text, std::string_view upper_case) {
  return is_word(text.substr(0, upper_case.size()), upper_case);
}

constexpr std::array<std::string_view, 9> kCurves{
    "CIRCULARSTRING",  "COMPOUNDCURVE", "CURVEPOLYGON", "CIRCLE",     "GEODESICSTRING",
    "ELLIPTICALCURVE", "NURBSCURVE",    "CLOTHOID",     "SPIRALCURVE"};

/// Whether a word is the name of a curve, with or without Z or M at its end.
bool is_curve(std::string_view word) {
  return std::ranges::any_of(kCurves,
                             [&](std::string_view c) { return starts_with_word(word, c); });
}

/// The whole globe in dialects of sets of the sphere.
constexpr std::string_view kGlobe = "FULLGLOBE";

/// The numbers of a position that follow x and y.
struct More {
  static constexpr int kUndecided = -1;  ///< As many as the first position has.
  int numbers = kUndecided;
  bool has_height = true;  ///< Whether the first one is Z, not M.
};

/// The words after the name of a geometry that announce them.
struct Dimension {
  std::string_view name;
  More more;
};
constexpr std::array<Dimension, 3> kDimensions{
    {{"ZM", {2, true}}, {"Z", {1, true}}, {"M", {1, false}}}};

/// Whether a token represents a missing number: nan, inf and NULL in any case, with a sign, and
/// forms such as 1.#QNAN.
bool is_no_number(std::string_view token) {
  if (token.starts_with('-') || token.starts_with('+')) token.remove_prefix(1);
  return is_word(token, "NAN") || is_word(token, "INF") || is_word(token, "INFINITY") ||
         is_word(token, "NULL") || token.starts_with("1.#");
}

/// Whether the token is a number in form. Its value is not needed, so it may have any size.
bool looks_like_number(std::string_view token, const Context& context) {
  const char* const end = token.data() + token.size();
  const auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
  const auto is_other = [&](char c) {
    return !is_digit(c) && c != '+' && c != '-' && c != '.' && c != '/' && c != 'e' && c != 'E';
  };
  return find_watched(token.data(), end, context, is_other) == end &&
         find_watched(token.data(), end, context, is_digit) != end;
}

bool are_equal(const ReadNumber& a, const ReadNumber& b) {
  if (a.is_double() && b.is_double()) return a.as_double() == b.as_double();
  return a.exact() == b.exact();
}

class WktReader {
 public:
  WktReader(std::string_view text, const ReadOptions& options, Context& context)
      : cursor_(text, options.name, &context),
        numbers_(context, options.exact_decimals, text.size()),
        shapes_(context, text.size()),
        context_(context) {}

  PlaneFile read();

  /// Whether a word names a geometry that is read.
  static bool is_geometry(std::string_view word) { return named(word).kind != nullptr; }

 private:
  using Body = void (WktReader::*)();
  struct Kind {
    std::string_view name;
    Body body;
  };
  static const std::array<Kind, 15> kKinds;

  /// The parts of a word such as POINTZ.
  struct Named {
    const Kind* kind;  ///< Null for another word.
    More more;
  };

  bool find_token();
  std::string_view take(std::string_view expected);
  void take_mark(std::string_view mark);
  bool take_if(std::string_view upper_case);
  bool is_at_list() { return find_token() && (next_ == "(" || is_word(next_, "EMPTY")); }

  [[noreturn]] void fail_without_geometry() const;
  void read_reference_system();
  static const Kind* find_kind(std::string_view name);
  static Named named(std::string_view word);
  const Kind& take_kind();
  [[noreturn]] void fail_kind(std::string_view token) const;
  void take_dimension();
  template <class Item>
  void read_list(Item read_item);

  void read_geometry();
  void read_point();
  void read_line();
  void read_ring_as_polygon();
  void read_polygon();
  void read_curve_polygon();
  void read_ring();
  void read_points();
  void read_lines();
  void read_polygons();
  void read_curves();
  void read_surfaces();
  void read_faces();
  void read_patches();
  void read_collection();
  void read_member(Body body, std::string_view expected);

  void read_position();
  void read_more(int index);
  void skip_payload();
  void read_height(std::string_view token);
  std::uint32_t read_positions();
  void require_good(const std::string& flaw) const;

  TextCursor cursor_;
  NumberReader numbers_;
  ShapeCollector shapes_;
  const Context& context_;
  // The next token, which has not been consumed yet, or an empty text if there is none.
  std::string_view next_;
  const char* last_ = nullptr;  // The token that was consumed last.
  More more_;
  int nested_ = 0;
  // Whether heights must be equal, because the position belongs to a surface.
  bool is_flat_ = false;
  bool has_height_ = false;  // Whether height_ is the height of an earlier position of the surface.
  bool drops_heights_ = false, drops_measures_ = false;
  bool has_rings_as_polygons_ = false;
  ReadNumber x_, y_, height_, other_;
};

const std::array<WktReader::Kind, 15> WktReader::kKinds{{
    {"POINT", &WktReader::read_point},
    {"LINESTRING", &WktReader::read_line},
    {"LINEARRING", &WktReader::read_ring_as_polygon},
    {"POLYGON", &WktReader::read_polygon},
    {"CURVEPOLYGON", &WktReader::read_curve_polygon},
    {"TRIANGLE", &WktReader::read_polygon},
    {"MULTIPOINT", &WktReader::read_points},
    {"MULTILINESTRING", &WktReader::read_lines},
    {"MULTICURVE", &WktReader::read_curves},
    {"MULTIPOLYGON", &WktReader::read_polygons},
    {"MULTISURFACE", &WktReader::read_surfaces},
    {"TIN", &WktReader::read_patches},
    {"POLYHEDRALSURFACE", &WktReader::read_patches},
    {"GEOMETRYCOLLECTION", &WktReader::read_collection},
    {"GEOMCOLLECTION", &WktReader::read_collection},  // MySQL writes this.
}};

/// Returns a bound on the number of positions. Each position ends with a comma or a parenthesis,
/// and "0 0," has four bytes.
std::size_t most_positions_of_wkt(std::string_view text) {
  const auto ends =
      std::count_if(text.begin(), text.end(), [](char c) { return c == ',' || c == ')'; });
  return std::min(static_cast<std::size_t>(ends), text.size() / 4);
}

PlaneFile WktReader::read() {
  if (!cursor_.next_line()) fail_without_geometry();
  shapes_.expect(cursor_, most_positions_of_wkt(cursor_.rest()));
  bool has_geometry = false;
  while (find_token()) {
    if (take_if(";")) continue;
    read_reference_system();
    read_geometry();
    has_geometry = true;
  }
  if (!has_geometry) fail_without_geometry();
  if (drops_heights_) shapes_.pass_over(kHeights);
  if (drops_measures_) shapes_.pass_over(kMeasures);
  if (has_rings_as_polygons_) {
    shapes_.note("a LINEARRING is read as the polygon that it bounds");
  }
  return shapes_.take();
}

void WktReader::fail_without_geometry() const {
  cursor_.fail(ErrorCode::CountMismatch,
               "the file has no content; expected a geometry such as POINT (1 2)");
}

/// Finds the next token, possibly on a later line. Returns false at the end of the text.
bool WktReader::find_token() {
  if (!next_.empty()) return true;
  while (cursor_.at_line_end()) {
    if (!cursor_.next_line()) return false;
  }
  next_ = cursor_.word(kMarks);
  return true;
}

std::string_view WktReader::take(std::string_view expected) {
  if (!find_token()) {
    cursor_.fail(ErrorCode::Syntax,
                 "expected " + std::string(expected) + ", found the end of the file");
  }
  last_ = next_.data();
  return std::exchange(next_, {});
}

void WktReader::take_mark(std::string_view mark) {
  const std::string expected = quoted(mark);
  const std::string_view token = take(expected);
  if (token != mark) cursor_.fail_token(token, expected);
}

bool WktReader::take_if(std::string_view upper_case) {
  if (!find_token() || !is_word(next_, upper_case)) return false;
  take(upper_case);
  return true;
}

/// Reads the prefixes of dialects: SRID=4326; (EWKT) or <URI> (GeoSPARQL).
void WktReader::read_reference_system() {
  constexpr std::string_view kSrid = "SRID=";
  const bool is_uri = next_.starts_with('<');
  if (!is_uri && !starts_with_word(next_, kSrid)) return;
  const std::string_view token = take("a geometry");
  const std::string_view number = token.substr(std::min(kSrid.size(), token.size()));
  const bool is_number = !number.empty() && number.find_first_not_of("-0123456789") == number.npos;
  if (!is_uri && !is_number) cursor_.fail_token(token, "SRID=NUMBER;");
  take_mark(is_uri ? ">" : ";");
  shapes_.pass_over(kReferenceSystems);
}

const WktReader::Kind* WktReader::find_kind(std::string_view name) {
  const auto found = std::find_if(kKinds.begin(), kKinds.end(),
                                  [&](const Kind& kind) { return is_word(name, kind.name); });
  return found == kKinds.end() ? nullptr : &*found;
}

WktReader::Named WktReader::named(std::string_view word) {
  if (const Kind* const kind = find_kind(word)) return {kind, {}};
  for (const auto& [name, more] : kDimensions) {
    const std::size_t size = word.size() - std::min(name.size(), word.size());
    if (!is_word(word.substr(size), name)) continue;
    if (const Kind* const kind = find_kind(word.substr(0, size))) return {kind, more};
  }
  return {nullptr, {}};
}

/// Reads the name of a geometry, with or without Z, M or ZM at its end.
const WktReader::Kind& WktReader::take_kind() {
  const std::string_view token = take("a geometry");
  const Named found = named(token);
  if (found.kind == nullptr) fail_kind(token);
  more_ = found.more;
  return *found.kind;
}

void WktReader::fail_kind(std::string_view token) const {
  if (is_curve(token)) {
    cursor_.fail(ErrorCode::Syntax, quoted(token).append(": ").append(kNoCurves), token.data());
  }
  if (starts_with_word(token, kGlobe)) {
    cursor_.fail(ErrorCode::Syntax,
                 quoted(token) +
                     ": the whole globe is no polygon of the plane; the whole plane is "
                     "written as .nef2",
                 token.data());
  }
  if (starts_with_word(token, "BOX") || is_word(token, "ENVELOPE")) {
    cursor_.fail(
        ErrorCode::Syntax,
        quoted(token) + ": a box is no geometry of WKT; write it as a POLYGON (ST_Envelope does)",
        token.data());
  }
  cursor_.fail_token(token,
                     "POINT, LINESTRING, POLYGON, MULTIPOINT, MULTILINESTRING, MULTIPOLYGON, "
                     "GEOMETRYCOLLECTION or another geometry of straight edges");
}

/// Reads "Z", "M" or "ZM" after the name of a geometry, if there is one.
void WktReader::take_dimension() {
  if (more_.numbers != More::kUndecided) return;
  for (const auto& [name, more] : kDimensions) {
    if (!take_if(name)) continue;
    more_ = more;
    return;
  }
}

void WktReader::read_geometry() {
  const Kind& kind = take_kind();
  if (nested_ > kMostNested) {
    cursor_.fail(ErrorCode::Syntax, "collections nested more than 64 deep", last_);
  }
  take_dimension();
  const std::size_t polygons = shapes_.polygon_count(), others = shapes_.without_polygons();
  (this->*kind.body)();
  shapes_.end_geometry(cursor_, polygons, others);
}

/// Reads EMPTY, "()", or a list "(" items ")" with commas between the items.
template <class Item>
void WktReader::read_list(Item read_item) {
  if (take_if("EMPTY")) return;
  const std::string_view open = take("'(' or EMPTY");
  if (open != "(") cursor_.fail_token(open, "'(' or EMPTY");
  if (take_if(")")) return;
  for (;;) {
    read_item();
    const std::string_view token = take("',' or ')'");
    if (token == ")") return;
    if (token != ",") cursor_.fail_token(token, "',' or ')'");
  }
}

/// Reads x, y and the numbers after them. All positions of a geometry must have the same count of
/// numbers as the first one. Otherwise, a comma may be missing.
void WktReader::read_position() {
  for (ReadNumber* const number : {&x_, &y_}) {
    const std::string_view token = take("a number");
    numbers_.read(cursor_, token, *number);
  }
  if (more_.numbers == More::kUndecided) {
    constexpr int kMost = 2;
    more_.numbers = 0;
    while (more_.numbers < kMost && find_token() && !is_mark(next_)) {
      read_more(more_.numbers++);
    }
  } else {
    for (int i = 0; i < more_.numbers; ++i) read_more(i);
  }
  shapes_.add_position(cursor_, x_, y_);
}

/// Reads the number at `index` among the numbers after x and y. Its value is not used, so it may be
/// missing.
void WktReader::read_more(int index) {
  const bool is_height = index == 0 && more_.has_height;
  const std::string_view token = take("a number");
  const bool is_missing = is_no_number(token);
  if (!is_missing && !looks_like_number(token, context_)) cursor_.fail_token(token, "a number");
  if (is_missing && cursor_.rest().starts_with('(')) skip_payload();
  if (is_height && is_flat_ && !is_missing) read_height(token);
  (is_height ? drops_heights_ : drops_measures_) = true;
}

/// Skips texts such as "(ind)", which some C libraries write after nan.
void WktReader::skip_payload() {
  take_mark("(");
  take("the end of nan(...)");
  take_mark(")");
}

/// Reads a height of a surface. Heights must be equal, because vertical faces would become lines in
/// the plane.
void WktReader::read_height(std::string_view token) {
  numbers_.read(cursor_, token, other_);
  if (has_height_ && !are_equal(height_, other_)) {
    cursor_.fail(ErrorCode::BadShape, std::string(kSurfaceInSpace), token.data());
  }
  if (!has_height_) std::swap(height_, other_);
  has_height_ = true;
}

/// Reads a list of positions and returns the index of the first one.
std::uint32_t WktReader::read_positions() {
  const std::uint32_t first = shapes_.position_count();
  read_list([this] { read_position(); });
  return first;
}

/// Reports a flaw of a list at its closing parenthesis.
void WktReader::require_good(const std::string& flaw) const {
  if (!flaw.empty()) cursor_.fail(ErrorCode::BadShape, flaw, last_);
}

void WktReader::read_point() {
  const std::uint32_t first = read_positions();
  const std::uint32_t last = shapes_.position_count();
  if (last - first > 1) require_good("a point of more than one position");
  shapes_.add_points(first, last);
}

void WktReader::read_line() {
  const std::uint32_t first = read_positions();
  if (first == shapes_.position_count()) return;
  require_good(shapes_.add_line(first, shapes_.position_count()));
}

/// Reads a closed line as the polygon that it bounds, because a line without an interior would
/// surprise users who mean a polygon. A note states this.
void WktReader::read_ring_as_polygon() {
  const std::uint32_t first = shapes_.position_count();
  read_ring();
  shapes_.end_polygon();
  has_rings_as_polygons_ |= first != shapes_.position_count();
}

void WktReader::read_ring() {
  const std::uint32_t first = read_positions();
  if (first == shapes_.position_count()) return;
  require_good(shapes_.add_ring(first, shapes_.position_count()));
}

void WktReader::read_polygon() {
  read_list([this] { read_ring(); });
  shapes_.end_polygon();
}

/// Reads a polygon with rings of any kind, if all are straight. In this case, the name of the kind
/// may precede each ring.
void WktReader::read_curve_polygon() {
  read_list([this] {
    take_if("LINESTRING");
    if (find_token() && is_curve(next_)) fail_kind(next_);
    read_ring();
  });
  shapes_.end_polygon();
}

/// Reads points with or without their own parentheses, because both forms occur.
void WktReader::read_points() {
  read_list([this] {
    if (is_at_list()) return read_point();
    read_position();
    shapes_.add_points(shapes_.position_count() - 1, shapes_.position_count());
  });
}

void WktReader::read_lines() {
  read_list([this] { read_line(); });
}

void WktReader::read_polygons() {
  const std::size_t first = shapes_.polygon_count();
  read_list([this] { read_polygon(); });
  shapes_.join_polygons(cursor_, first);
}

/// Reads a member of a collection. Members have names only if they are not of the ordinary kind.
void WktReader::read_member(Body body, std::string_view expected) {
  if (!is_at_list()) {
    const Kind& kind = take_kind();
    const bool is_surface =
        body == &WktReader::read_polygon && kind.body == &WktReader::read_curve_polygon;
    if (kind.body != body && !is_surface) {
      cursor_.fail_token({last_, kind.name.size()}, expected);
    }
    body = kind.body;
    take_dimension();
  }
  (this->*body)();
}

void WktReader::read_curves() {
  read_list([this] { read_member(&WktReader::read_line, "a LINESTRING or '('"); });
}

void WktReader::read_surfaces() {
  const std::size_t first = shapes_.polygon_count();
  read_faces();
  shapes_.join_polygons(cursor_, first);
}

void WktReader::read_faces() {
  read_list([this] { read_member(&WktReader::read_polygon, "a POLYGON or '('"); });
}

/// Reads the faces of a surface. It is a set of the plane if all its heights are equal.
void WktReader::read_patches() {
  is_flat_ = true;
  has_height_ = false;
  read_faces();
  is_flat_ = false;
}

void WktReader::read_collection() {
  ++nested_;
  read_list([this] { read_geometry(); });
  --nested_;
}

}  // namespace

bool begins_like_wkt(std::string_view text) {
  constexpr std::array<std::string_view, 3> kReferenceSystems{"SRID=", "<HTTP", "<URN:"};
  const auto begins = [&](std::string_view word) { return starts_with_word(text, word); };
  if (std::ranges::any_of(kReferenceSystems, begins)) return true;
  const auto end =
      std::ranges::find_if_not(text, [](char c) { return 'A' <= upper(c) && upper(c) <= 'Z'; });
  const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  return WktReader::is_geometry(word) || is_curve(word) || is_word(word, kGlobe);
}

PlaneFile read_wkt(std::string_view text, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  return read_lines(without_padding(text), options, context, [&](std::string_view lines) {
    return WktReader(lines, options, context).read();
  });
}

namespace {

class WktWriter : public ShapeWriter {
 public:
  WktWriter(std::ostream& out, const PlaneShapes& shapes, Context& context)
      : ShapeWriter(out, shapes, {'(', ", ", ')'}, context) {}

 private:
  void begin_collection(bool is_empty) override {
    out_ << (is_empty ? "GEOMETRYCOLLECTION EMPTY" : "GEOMETRYCOLLECTION (");
  }
  void end_collection(bool is_empty) override {
    if (!is_empty) out_ << ')';
  }
  void begin_geometry(std::string_view name, bool is_multiple) override {
    std::string upper_case(name);
    std::transform(name.begin(), name.end(), upper_case.begin(), upper);
    out_ << (is_multiple ? "MULTI" : "") << upper_case << ' ';
  }
  void end_geometry() override {}
  void write_point(Point2 p) override {
    write_list(0, 1, [&](std::size_t) { write_position(p); });
  }
  void write_position(Point2 p) override { out_ << p.x << ' ' << p.y; }
};

}  // namespace

void write_wkt(std::ostream& out, const PlaneShapes& shapes, Context& context) {
  WktWriter(out, shapes, context).write();
}

}  // namespace plumb
