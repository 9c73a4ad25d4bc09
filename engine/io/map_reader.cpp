#include "plumb/io/map_reader.h"

#include <algorithm>
#include <cfenv>
#include <charconv>
#include <cstdint>
#include <limits>
#include <system_error>

#include "plumb/base/error.h"
#include "plumb/io/input.h"
#include "plumb/io/number_reader.h"
#include "plumb/io/text_cursor.h"
#include "plumb/predicates/point_table2.h"

namespace plumb {
namespace {

constexpr std::uint32_t kMostIds = std::numeric_limits<std::uint32_t>::max() - 1;
constexpr std::size_t kLinesPerCheckpoint = 4096;
// The shortest lines: "0 0" and "1 2 3", each with its line break (the last may lack it).
constexpr std::size_t kVertexBytes = 4;
constexpr std::size_t kFaceBytes = 6;

/// Decimal text is rounded to nearest, whatever mode the caller is in.
class RoundToNearest {
 public:
  RoundToNearest() : before_(std::fegetround()) { std::fesetround(FE_TONEAREST); }
  ~RoundToNearest() { std::fesetround(before_); }
  RoundToNearest(const RoundToNearest&) = delete;
  RoundToNearest& operator=(const RoundToNearest&) = delete;

 private:
  int before_;
};

/// Are all corners of `face` on one line of the plane? Exact; stops at the first turn.
bool is_on_one_line(const PointTable2& points, std::span<const std::uint32_t> face) {
  const std::uint32_t a = face[0];
  if (orient2d(points, a, face[1], face[2]) != Sign::Zero) return false;
  const auto b = std::find_if(face.begin() + 1, face.end(), [&](std::uint32_t v) {
    return compare_xy(points, a, v) != Sign::Zero;
  });
  return std::none_of(b, face.end(),
                      [&](std::uint32_t c) { return orient2d(points, a, *b, c) != Sign::Zero; });
}

class MapReader {
 public:
  MapReader(std::string_view text, const ReadOptions& options, Context& context)
      : cursor_(text, options.name),
        numbers_(context.limits(), options.exact_decimals, text.size()),
        context_(context),
        total_bytes_(text.size()) {}

  Map read() {
    read_counts();
    read_vertices();
    read_faces();
    if (cursor_.next_line()) {
      cursor_.fail(ErrorCode::CountMismatch, "there is more after the last face; line " +
                                                 std::to_string(counts_line_) + " announces " +
                                                 std::to_string(faces_) + " faces");
    }
    return std::move(map_);
  }

 private:
  void charge(std::size_t bytes);
  void read_counts();
  std::uint32_t read_count(std::string_view what);
  void read_vertices();
  void read_vertex();
  void push_exact(const Rational& x, const Rational& y);
  void read_faces();
  void read_face();
  std::uint32_t read_id();
  std::uint32_t read_long_id(std::string_view token) const;
  [[noreturn]] void fail_id(std::string_view token) const;
  void check_face(const char* start) const;
  void add_corner(std::uint32_t vertex);
  void next_content_line(std::string_view what, std::uint32_t index, std::uint32_t count);
  std::string face_name() const { return "face " + std::to_string(map_.cycle_begin.size()); }

  TextCursor cursor_;
  NumberReader numbers_;
  Context& context_;
  std::size_t total_bytes_;
  std::size_t counts_line_ = 0;
  std::uint32_t vertices_ = 0;
  std::uint32_t faces_ = 0;
  std::uint64_t charged_corners_ = 0;
  ReadNumber x_;
  ReadNumber y_;
  Map map_;
};

/// Memory limits are told with the place that they were met at, like every other error.
void MapReader::charge(std::size_t bytes) {
  try {
    context_.charge_memory(bytes, "the map");
  } catch (const Error& error) {
    cursor_.fail(error.code(), error.message());
  }
}

void MapReader::read_counts() {
  if (!cursor_.next_line()) {
    cursor_.fail(ErrorCode::CountMismatch,
                 "the file has no content; expected the numbers of vertices and faces");
  }
  counts_line_ = cursor_.line();
  const char* const start = cursor_.position();
  vertices_ = read_count("the number of vertices");
  faces_ = read_count("the number of faces");
  if (!cursor_.at_line_end()) {
    cursor_.fail_token(cursor_.token(), "two numbers on this line: vertices and faces");
  }
  const std::uint64_t need =
      std::uint64_t{vertices_} * kVertexBytes + std::uint64_t{faces_} * kFaceBytes;
  if (need > std::uint64_t{cursor_.bytes_left()} + 1) {
    cursor_.fail(ErrorCode::CountMismatch,
                 std::to_string(vertices_) + " vertices and " + std::to_string(faces_) +
                     " faces are announced, but the file is too short for them",
                 start);
  }
  charge(vertices_ * sizeof(Point2) + faces_ * sizeof(std::uint32_t));
  map_.points.reserve(vertices_);
  map_.cycle_begin.reserve(std::size_t{faces_} + 1);
}

std::uint32_t MapReader::read_count(std::string_view what) {
  if (cursor_.at_line_end()) {
    cursor_.fail(ErrorCode::Syntax,
                 "expected " + std::string(what) + ", found the end of the line");
  }
  const std::string_view token = cursor_.token();
  std::uint64_t value = 0;
  const auto [end, code] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size()) {
    cursor_.fail_token(token, std::string(what) + " (0 or more, digits only)");
  }
  if (code != std::errc() || value > kMostIds) {
    cursor_.fail(ErrorCode::CountMismatch,
                 quoted(token) + ": at most " + std::to_string(kMostIds) + " are possible",
                 token.data());
  }
  return static_cast<std::uint32_t>(value);
}

/// To the next line with content, or an error that says what is missing.
void MapReader::next_content_line(std::string_view what, std::uint32_t index, std::uint32_t count) {
  if (index % kLinesPerCheckpoint == 0) {
    context_.checkpoint("read", cursor_.bytes_read(), total_bytes_);
  }
  if (cursor_.next_line()) return;
  cursor_.fail(ErrorCode::CountMismatch, "the file ends where " + std::string(what) + " " +
                                             std::to_string(index + 1) + " of " +
                                             std::to_string(count) + " is expected");
}

void MapReader::read_vertices() {
  for (std::uint32_t i = 0; i < vertices_; ++i) {
    next_content_line("vertex", i, vertices_);
    read_vertex();
  }
}

void MapReader::read_vertex() {
  for (ReadNumber* number : {&x_, &y_}) {
    if (cursor_.at_line_end()) {
      cursor_.fail(ErrorCode::Syntax, "vertex " + std::to_string(map_.points.size() + 1) +
                                          " needs two numbers, x and y");
    }
    std::uint32_t small = 0;
    if (cursor_.short_number(small)) {
      number->set(small);
    } else {
      numbers_.read(cursor_, cursor_.token(), *number);
    }
  }
  if (!cursor_.at_line_end()) {
    cursor_.fail_token(cursor_.token(), "the end of the line after the two numbers of vertex " +
                                            std::to_string(map_.points.size() + 1));
  }
  if (x_.is_double() && y_.is_double()) {
    map_.points.push_back({x_.as_double(), y_.as_double()});
  } else {
    push_exact(x_.exact(), y_.exact());
  }
}

/// The table stores x, y over a common denominator: three integers, each at most as long as a
/// numerator and the other's denominator together.
void MapReader::push_exact(const Rational& x, const Rational& y) {
  const auto limbs = [](const Rational& q) {
    return mpz_size(mpq_numref(q.backend().data())) + mpz_size(mpq_denref(q.backend().data()));
  };
  constexpr std::size_t kEntryBytes = 32;
  charge(kEntryBytes + 2 * sizeof(mp_limb_t) * (limbs(x) + limbs(y)));
  map_.points.push_back(x, y);
}

void MapReader::read_faces() {
  for (std::uint32_t i = 0; i < faces_; ++i) {
    next_content_line("face", i, faces_);
    read_face();
  }
}

void MapReader::read_face() {
  const char* const start = cursor_.position();
  const std::size_t first = map_.cycle_begin.back();
  const char* last = start;
  while (!cursor_.at_line_end()) {
    last = cursor_.position();
    const std::uint32_t vertex = read_id();
    if (map_.corners.size() > first && map_.corners.back() == vertex) {
      cursor_.fail(ErrorCode::DegenerateFace,
                   face_name() + " names vertex " + std::to_string(vertex + 1) + " twice in a row",
                   last);
    }
    add_corner(vertex);
  }
  const std::size_t size = map_.corners.size() - first;
  if (size >= 2 && map_.corners[first] == map_.corners.back()) {
    cursor_.fail(ErrorCode::DegenerateFace,
                 face_name() + " ends with the vertex it starts with; cycles close by themselves",
                 last);
  }
  check_face(start);
  map_.cycle_begin.push_back(static_cast<std::uint32_t>(map_.corners.size()));
}

void MapReader::check_face(const char* start) const {
  const std::span<const std::uint32_t> face(map_.corners.data() + map_.cycle_begin.back(),
                                            map_.corners.data() + map_.corners.size());
  if (face.size() < 3) {
    cursor_.fail(ErrorCode::DegenerateFace,
                 face_name() + " has " + std::to_string(face.size()) +
                     (face.size() == 1 ? " vertex" : " vertices") + "; at least 3 are needed",
                 start);
  }
  if (is_on_one_line(map_.points, face)) {
    cursor_.fail(ErrorCode::DegenerateFace, "all vertices of " + face_name() + " lie on one line",
                 start);
  }
}

void MapReader::add_corner(std::uint32_t vertex) {
  constexpr std::uint64_t kStep = 1U << 16U;
  if (map_.corners.size() == charged_corners_) {
    if (charged_corners_ > kMostIds - kStep) {
      cursor_.fail(ErrorCode::ResourceLimit, "more than 2^32 corners");
    }
    charge(kStep * sizeof(std::uint32_t));
    charged_corners_ += kStep;
  }
  map_.corners.push_back(vertex);
}

/// A 1-based id in the text, 0-based here.
std::uint32_t MapReader::read_id() {
  const char* const start = cursor_.position();
  std::uint32_t id = 0;
  if (!cursor_.short_number(id)) id = read_long_id(cursor_.token());
  if (id == 0 || id > vertices_) fail_id({start, cursor_.position()});
  return id - 1;
}

/// Ids of any length; those beyond every range become 0, which is beyond it too.
std::uint32_t MapReader::read_long_id(std::string_view token) const {
  const std::string_view digits = token.substr(token.starts_with('-') ? 1 : 0);
  std::uint32_t id = 0;
  const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), id);
  if (end != digits.data() + digits.size()) cursor_.fail_token(token, "a vertex id");
  return code == std::errc() && digits.size() == token.size() ? id : 0;
}

void MapReader::fail_id(std::string_view token) const {
  cursor_.fail(ErrorCode::BadIndex,
               face_name() + " names vertex " + quoted(token) + "; ids run from 1 to " +
                   std::to_string(vertices_),
               token.data());
}

}  // namespace

Map read_map(std::string_view text, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  return MapReader(text, options, context).read();
}

Map read_map_file(const std::string& path, ReadOptions options, Context& context) {
  options.name = input_name(path);
  const std::string text = read_input(path, context);
  Map map = read_map(text, options, context);
  context.release_memory(text.size());
  return map;
}

}  // namespace plumb
