// Reading of well-known binary.
//
// Each geometry has a head (byte order, code, SRID) and lists with counts before them; geometries
// within geometries have heads of their own, which is the only recursion, limited in depth. A table
// says which kinds a kind may hold. Hexadecimal text is decoded token by token and read by the same
// reader. Format: OGC 06-103r4, Simple feature access, part 1 (2011), section on well-known binary;
// EWKB as PostGIS documents it.
// Tested by tests/io/wkb_test.cpp.
#include "plumb/io/plane/wkb.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include "plumb/io/plane/shape_text.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::size_t kHeadBytes = 5;  // The byte order and the code.
constexpr std::size_t kPositionBytes = 2 * sizeof(double);

/// Codes of geometries.
enum Code : std::uint32_t {
  kPoint = 1,
  kLine = 2,
  kPolygon = 3,
  kMultiPoint = 4,
  kMultiLine = 5,
  kMultiPolygon = 6,
  kCollection = 7,
  kMultiCurve = 11,
  kMultiSurface = 12,
  kPolyhedralSurface = 15,
  kTin = 16,
  kTriangle = 17,
  kLastCode = kTriangle,
};

constexpr std::uint32_t bit(Code code) { return 1U << code; }
constexpr std::uint32_t kAnything = 0xffff'ffff;

/// Returns the set of codes that members of a geometry may have, or 0 if it has no members.
constexpr std::uint32_t members_of(std::uint32_t code) {
  switch (code) {
    case kMultiPoint:
      return bit(kPoint);
    case kMultiLine:
    case kMultiCurve:
      return bit(kLine);
    case kMultiPolygon:
    case kMultiSurface:
    case kPolyhedralSurface:
    case kTin:
      return bit(kPolygon) | bit(kTriangle);
    case kCollection:
      return kAnything;
    default:
      return 0;
  }
}

/// Whether geometries of that code are read. All other geometries are curves.
constexpr bool is_read(std::uint32_t code) {
  constexpr std::uint32_t kSimple = bit(kPoint) | bit(kLine) | bit(kPolygon) | bit(kTriangle);
  return ((kSimple >> code) & 1U) != 0 || members_of(code) != 0;
}

/// The head of a geometry.
struct Head {
  std::uint32_t code;
  bool has_height;
  bool has_measure;
  bool has_srid;
};

/// Splits a code into its parts. EWKB sets bits, and ISO adds thousands.
std::optional<Head> head_of(std::uint32_t value) {
  constexpr std::uint32_t kHeight = 0x8000'0000, kMeasure = 0x4000'0000, kSrid = 0x2000'0000;
  constexpr std::uint32_t kThousand = 1000, kMostThousands = 3;
  const std::uint32_t number = value & ~(kHeight | kMeasure | kSrid);
  const std::uint32_t thousands = number / kThousand, code = number % kThousand;
  if (code == 0 || code > kLastCode || thousands > kMostThousands) return {};
  return Head{code, (value & kHeight) != 0 || thousands == 1 || thousands == 3,
              (value & kMeasure) != 0 || thousands >= 2, (value & kSrid) != 0};
}

class WkbReader {
 public:
  /// Reads the geometries of `bytes` into `shapes`.
  WkbReader(std::string_view bytes, const std::string& name, ShapeCollector& shapes)
      : in_(bytes, 0, std::endian::little, name), shapes_(shapes) {}

  void read() {
    do {
      read_geometry(kAnything);
    } while (in_.bytes_left() > 0);
    if (has_srid_) shapes_.pass_over(kReferenceSystems);
    if (drops_heights_) shapes_.pass_over(kHeights);
    if (drops_measures_) shapes_.pass_over(kMeasures);
  }

 private:
  void require_bytes(std::size_t bytes) const;
  std::uint32_t read_count(std::size_t bytes_each);
  void read_head();
  void read_geometry(std::uint32_t allowed);
  void read_body();
  void read_members();
  void read_point();
  void read_line();
  void read_polygon();
  Point2 read_numbers();
  void check_height(double height);
  void add_position(Point2 p, std::size_t start);
  std::uint32_t read_positions();
  std::size_t position_bytes() const {
    return kPositionBytes + (head_.has_height ? sizeof(double) : 0) +
           (head_.has_measure ? sizeof(double) : 0);
  }
  void require_good(const std::string& flaw) const {
    if (!flaw.empty()) in_.fail(ErrorCode::BadShape, flaw);
  }

  BinaryInput in_;
  ShapeCollector& shapes_;
  Head head_{};  // The head of the geometry that is being read.
  int nested_ = 0;
  // Whether heights must be equal, because the position belongs to a surface.
  bool is_flat_ = false;
  std::optional<double> height_;  // The height of an earlier position of the surface.
  bool has_srid_ = false, drops_heights_ = false, drops_measures_ = false;
  ReadNumber x_, y_;
};

void WkbReader::require_bytes(std::size_t bytes) const {
  if (in_.bytes_left() < bytes) {
    in_.fail(ErrorCode::CountMismatch, "the bytes end within a geometry");
  }
}

/// Reads a number of items, each with at least the given number of bytes.
std::uint32_t WkbReader::read_count(std::size_t bytes_each) {
  require_bytes(sizeof(std::uint32_t));
  const std::size_t start = in_.position();
  const auto count = in_.take<std::uint32_t>();
  if (count > in_.bytes_left() / bytes_each) {
    in_.fail(ErrorCode::CountMismatch,
             std::to_string(count) + " items are announced, but there are too few bytes for them",
             start);
  }
  return count;
}

void WkbReader::read_head() {
  require_bytes(kHeadBytes);
  const std::size_t start = in_.position();
  const auto order = in_.take<std::uint8_t>();
  if (order > 1) {
    in_.fail(ErrorCode::Syntax,
             "expected a byte order, 0 or 1, found " + std::to_string(order) + ": is this WKB?",
             start);
  }
  in_.set_order(order == 0 ? std::endian::big : std::endian::little);
  const auto value = in_.take<std::uint32_t>();
  const std::optional<Head> head = head_of(value);
  if (!head) {
    in_.fail(ErrorCode::Syntax, "no geometry has the code " + std::to_string(value), start + 1);
  }
  head_ = *head;
  if (!head_.has_srid) return;
  require_bytes(sizeof(std::uint32_t));
  in_.skip(sizeof(std::uint32_t));
  has_srid_ = true;
}

void WkbReader::read_geometry(std::uint32_t allowed) {
  const std::size_t start = in_.position();
  if (nested_ > kMostNested) {
    in_.fail(ErrorCode::Syntax, "geometries nested more than 64 deep", start);
  }
  read_head();
  if (!is_read(head_.code)) {
    in_.fail(ErrorCode::Syntax,
             "code " + std::to_string(head_.code) + ": " + std::string(kNoCurves), start);
  }
  if ((allowed & (1U << head_.code)) == 0) {
    in_.fail(ErrorCode::Syntax,
             "a geometry of code " + std::to_string(head_.code) + " among others of another kind",
             start);
  }
  const std::size_t polygons = shapes_.polygon_count(), others = shapes_.without_polygons();
  read_body();
  if (allowed == kAnything) shapes_.end_geometry(in_, polygons, others);
}

/// Reads what follows a head.
void WkbReader::read_body() {
  switch (head_.code) {
    case kPoint:
      return read_point();
    case kLine:
      return read_line();
    case kPolygon:
    case kTriangle:
      return read_polygon();
    default:
      return read_members();
  }
}

void WkbReader::read_members() {
  const std::uint32_t code = head_.code;
  const bool is_surface = code == kTin || code == kPolyhedralSurface;
  if (is_surface) {
    is_flat_ = true;
    height_.reset();
  }
  const std::size_t first = shapes_.polygon_count();
  ++nested_;
  for (std::uint32_t left = read_count(kHeadBytes); left > 0; --left) {
    read_geometry(members_of(code));
  }
  --nested_;
  if (code == kMultiPolygon || code == kMultiSurface) shapes_.join_polygons(in_, first);
  if (is_surface) is_flat_ = false;
}

/// Reads a position. Numbers after x and y are dropped.
Point2 WkbReader::read_numbers() {
  require_bytes(position_bytes());
  const auto x = in_.take<double>();
  const auto y = in_.take<double>();
  if (head_.has_height) check_height(in_.take<double>());
  if (head_.has_measure) in_.skip(sizeof(double));
  drops_heights_ |= head_.has_height;
  drops_measures_ |= head_.has_measure;
  return {x, y};
}

/// Requires equal heights within a surface, because vertical faces would become lines in the plane.
void WkbReader::check_height(double height) {
  if (!is_flat_ || std::isnan(height)) return;
  if (height_.value_or(height) != height) {
    in_.fail(ErrorCode::BadShape, std::string(kSurfaceInSpace), in_.position() - sizeof(double));
  }
  height_ = height;
}

void WkbReader::add_position(Point2 p, std::size_t start) {
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
    in_.fail(ErrorCode::NumberOutOfRange, "a coordinate that is not finite", start);
  }
  x_.set(p.x);
  y_.set(p.y);
  shapes_.add_position(in_, x_, y_);
}

/// Reads a list of positions and returns the index of the first one.
std::uint32_t WkbReader::read_positions() {
  const std::uint32_t first = shapes_.position_count();
  for (std::uint32_t left = read_count(position_bytes()); left > 0; --left) {
    const std::size_t start = in_.position();
    add_position(read_numbers(), start);
  }
  return first;
}

/// Reads a point. The coordinates of an empty point are NaNs.
void WkbReader::read_point() {
  const std::size_t start = in_.position();
  const Point2 p = read_numbers();
  if (std::isnan(p.x) && std::isnan(p.y)) return;
  add_position(p, start);
  shapes_.add_points(shapes_.position_count() - 1, shapes_.position_count());
}

void WkbReader::read_line() {
  const std::uint32_t first = read_positions();
  if (first == shapes_.position_count()) return;
  require_good(shapes_.add_line(first, shapes_.position_count()));
}

void WkbReader::read_polygon() {
  for (std::uint32_t left = read_count(sizeof(std::uint32_t)); left > 0; --left) {
    const std::uint32_t first = read_positions();
    if (first == shapes_.position_count()) continue;
    require_good(shapes_.add_ring(first, shapes_.position_count()));
  }
  shapes_.end_polygon();
}

bool is_binary(std::string_view bytes) {
  return bytes.starts_with('\0') || bytes.starts_with('\1');
}

/// Returns the value of a hexadecimal digit, or -1 for another character.
int digit_value(char c) {
  if ('0' <= c && c <= '9') return c - '0';
  if ('a' <= c && c <= 'f') return c - 'a' + 10;
  if ('A' <= c && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// Removes the prefix that databases write before the digits.
std::string_view without_prefix(std::string_view token) {
  for (const std::string_view prefix : {"\\x", "0x", "0X"}) {
    if (take_prefix(token, prefix)) break;
  }
  return token;
}

/// Returns the bytes that hexadecimal digits represent, up to the first other character.
std::string decoded(std::string_view digits) {
  std::string bytes;
  bytes.reserve(digits.size() / 2);
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    const int high = digit_value(digits[i]), low = digit_value(digits[i + 1]);
    if (high < 0 || low < 0) break;
    bytes.push_back(static_cast<char>(16 * high + low));
  }
  return bytes;
}

/// Reads the geometries of a token of hexadecimal digits.
void read_token(const TextCursor& cursor, std::string_view token, const std::string& name,
                ShapeCollector& shapes, Context& context) {
  const std::string_view digits = without_prefix(token);
  MemoryCharge charge(context);
  with_place(cursor, [&] { charge.add(digits.size() / 2, "the bytes of WKB"); });
  const std::string bytes = decoded(digits);
  if (bytes.empty() || 2 * bytes.size() != digits.size()) {
    cursor.fail_token(token, "WKB: bytes, or pairs of hexadecimal digits");
  }
  try {
    WkbReader(bytes, name, shapes).read();
  } catch (const Error& error) {
    if (error.place().file.empty()) throw;
    cursor.fail(error.code(), error.message(), token.data());
  }
}

}  // namespace

PlaneFile read_wkb(std::string_view bytes, const ReadOptions& options, Context& context) {
  ShapeCollector shapes(context, bytes.size());
  TextCursor cursor(bytes, options.name, &context);
  const bool is_hexadecimal = !is_binary(bytes);
  shapes.expect(cursor, bytes.size() / kPositionBytes / (is_hexadecimal ? 2 : 1));
  if (!is_hexadecimal) {
    WkbReader(bytes, options.name, shapes).read();
    return shapes.take();
  }
  if (!cursor.next_line()) {
    cursor.fail(ErrorCode::CountMismatch, "the file has no content; expected WKB");
  }
  do {
    while (!cursor.at_line_end()) read_token(cursor, cursor.token(), options.name, shapes, context);
  } while (cursor.next_line());
  return shapes.take();
}

bool begins_like_wkb(std::string_view bytes) {
  std::string head(bytes.substr(0, kHeadBytes));
  if (!is_binary(bytes)) head = decoded(without_prefix(bytes.substr(0, 2 * kHeadBytes + 2)));
  if (head.size() < kHeadBytes || !is_binary(head)) return false;
  BinaryInput in(head, 1, head[0] == '\0' ? std::endian::big : std::endian::little, "");
  return head_of(in.take<std::uint32_t>()).has_value();
}

}  // namespace plumb
