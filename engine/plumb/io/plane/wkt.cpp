// Reading and writing of well-known text.
//
// A recursive-descent reader over tokens, with one token of lookahead across line breaks.
// Collections are the only recursion and are limited in depth. The number of positions is bounded
// by the commas and parentheses of the text, so the table is reserved and charged once before
// reading. Flaws of a list (a ring that is not closed, a line of one position) are reported at its
// closing parenthesis. Format: OGC 06-103r4, Simple feature access, part 1 (2011), section on
// well-known text; docs/formats.md, section WKT.
// Tested by tests/io/wkt_test.cpp.
#include "plumb/io/plane/wkt.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include "plumb/io/plane/shape_text.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::string_view kMarks = "(),";
constexpr int kMostNested = 64;

constexpr char upper(char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

bool is_word(std::string_view token, std::string_view upper_case) {
  return std::equal(token.begin(), token.end(), upper_case.begin(), upper_case.end(),
                    [](char a, char b) { return upper(a) == b; });
}

class WktReader {
 public:
  WktReader(std::string_view text, const ReadOptions& options, Context& context)
      : cursor_(text, options.name),
        numbers_(context.limits(), options.exact_decimals, text.size()),
        shapes_(context, text.size()) {}

  PlaneShapes read();

 private:
  using Body = void (WktReader::*)();
  struct Kind {
    std::string_view name;
    Body body;
  };
  static const std::array<Kind, 7> kKinds;

  bool find_token();
  std::string_view take(std::string_view expected);
  bool take_if(std::string_view upper_case);
  const Kind& take_kind();
  void take_dimension();
  template <class Item>
  void read_list(Item read_item);

  void read_geometry();
  void read_point();
  void read_line();
  void read_polygon();
  void read_ring();
  void read_points();
  void read_lines();
  void read_polygons();
  void read_collection();

  void read_position();
  std::uint32_t read_positions();
  void require_good(const std::string& flaw) const;

  TextCursor cursor_;
  NumberReader numbers_;
  ShapeCollector shapes_;
  std::string_view next_;       // The token looked at and not yet taken; empty if there is none.
  const char* last_ = nullptr;  // The token taken last.
  int extra_numbers_ = 0;       // Numbers of a position besides x and y.
  int nested_ = 0;
  ReadNumber x_, y_, dropped_;
};

const std::array<WktReader::Kind, 7> WktReader::kKinds{{
    {"POINT", &WktReader::read_point},
    {"LINESTRING", &WktReader::read_line},
    {"POLYGON", &WktReader::read_polygon},
    {"MULTIPOINT", &WktReader::read_points},
    {"MULTILINESTRING", &WktReader::read_lines},
    {"MULTIPOLYGON", &WktReader::read_polygons},
    {"GEOMETRYCOLLECTION", &WktReader::read_collection},
}};

/// Returns a bound on the number of positions: each ends with a comma or parenthesis, and "0 0,"
/// are four bytes.
std::size_t most_positions_of_wkt(std::string_view text) {
  const auto ends =
      std::count_if(text.begin(), text.end(), [](char c) { return c == ',' || c == ')'; });
  return std::min(static_cast<std::size_t>(ends), text.size() / 4);
}

PlaneShapes WktReader::read() {
  if (!cursor_.next_line()) {
    cursor_.fail(ErrorCode::CountMismatch,
                 "the file has no content; expected a geometry such as POINT (1 2)");
  }
  shapes_.expect(cursor_, most_positions_of_wkt(cursor_.rest()));
  while (find_token()) read_geometry();
  return shapes_.take();
}

/// Looks at the next token, on whatever line; returns false at the end of the text.
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

bool WktReader::take_if(std::string_view upper_case) {
  if (!find_token() || !is_word(next_, upper_case)) return false;
  take(upper_case);
  return true;
}

const WktReader::Kind& WktReader::take_kind() {
  const std::string_view token = take("a geometry");
  for (const Kind& kind : kKinds) {
    if (is_word(token, kind.name)) return kind;
  }
  cursor_.fail_token(token,
                     "POINT, LINESTRING, POLYGON, MULTIPOINT, MULTILINESTRING, MULTIPOLYGON or "
                     "GEOMETRYCOLLECTION");
}

/// Takes "Z", "M", "ZM" or nothing.
void WktReader::take_dimension() {
  extra_numbers_ = take_if("ZM") ? 2 : take_if("Z") || take_if("M") ? 1 : 0;
}

void WktReader::read_geometry() {
  const Kind& kind = take_kind();
  if (nested_ > kMostNested) {
    cursor_.fail(ErrorCode::Syntax, "collections nested more than 64 deep", last_);
  }
  take_dimension();
  (this->*kind.body)();
}

/// Reads EMPTY, or a list "(" items ")" with commas between the items.
template <class Item>
void WktReader::read_list(Item read_item) {
  if (take_if("EMPTY")) return;
  const std::string_view open = take("'(' or EMPTY");
  if (open != "(") cursor_.fail_token(open, "'(' or EMPTY");
  for (;;) {
    read_item();
    const std::string_view token = take("',' or ')'");
    if (token == ")") return;
    if (token != ",") cursor_.fail_token(token, "',' or ')'");
  }
}

void WktReader::read_position() {
  const auto read_number = [this](ReadNumber& number) {
    const std::string_view token = take("a number");
    numbers_.read(cursor_, token, number);
  };
  read_number(x_);
  read_number(y_);
  for (int i = 0; i < extra_numbers_; ++i) read_number(dropped_);
  shapes_.add_position(cursor_, x_, y_);
}

/// Reads a list of positions and returns the first.
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

void WktReader::read_ring() {
  const std::uint32_t first = read_positions();
  if (first == shapes_.position_count()) return;
  require_good(shapes_.add_ring(first, shapes_.position_count()));
}

void WktReader::read_polygon() {
  read_list([this] { read_ring(); });
  shapes_.end_polygon();
}

/// Reads points with or without parentheses of their own: both forms occur.
void WktReader::read_points() {
  read_list([this] {
    const bool is_bare = find_token() && next_ != "(" && !is_word(next_, "EMPTY");
    if (!is_bare) return read_point();
    read_position();
    shapes_.add_points(shapes_.position_count() - 1, shapes_.position_count());
  });
}

void WktReader::read_lines() {
  read_list([this] { read_line(); });
}

void WktReader::read_polygons() {
  read_list([this] { read_polygon(); });
}

void WktReader::read_collection() {
  ++nested_;
  read_list([this] { read_geometry(); });
  --nested_;
}

}  // namespace

PlaneShapes read_wkt(std::string_view text, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  return WktReader(text, options, context).read();
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
