// Reading and writing of the `map` format: counts, points, and faces as cycles of vertices numbered
// from 1.
//
// Counts are compared with the bytes that follow before memory is reserved. A face is accepted only
// if it has at least three corners, no vertex twice in a row, and corners that are not all on one
// line; the last is decided by exact orientation signs, which stop at the first turn. Whether the
// faces form a planar subdivision is not decided here but by the check of maps (plane/map_check.h).
// Format: docs/formats.md, section map.
// Tested by tests/io/map_io_test.cpp.
#include "plumb/io/map_io.h"

#include <algorithm>
#include <cstdint>
#include <ostream>

#include "plumb/io/text/files.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point_table2.h"

namespace plumb {
namespace {

// The shortest lines: "0 0" and "1 2 3", each with its line break.
constexpr std::size_t kVertexBytes = 4;
constexpr std::size_t kFaceBytes = 6;

/// Whether all corners of `face` are on one line of the plane. Exact; stops at the first turn.
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
      : in_(text, options, context, "the map") {}

  Map read() {
    read_counts();
    read_vertices();
    read_faces();
    if (in_.cursor().next_line()) {
      fail(ErrorCode::CountMismatch, "there is more after the last face; line " +
                                         std::to_string(counts_line_) + " announces " +
                                         std::to_string(faces_) + " faces");
    }
    map_.corners.shrink_to_fit();  // No line says how many corners there will be.
    return std::move(map_);
  }

 private:
  void read_counts();
  void read_vertices();
  void read_faces();
  void read_face();
  void check_face(const char* start) const;
  void add_corner(std::uint32_t vertex);
  [[noreturn]] void fail(ErrorCode code, std::string message, const char* where = nullptr) const {
    in_.cursor().fail(code, std::move(message), where);
  }

  RecordReader in_;
  std::size_t counts_line_ = 0;
  std::uint32_t vertices_ = 0;
  std::uint32_t faces_ = 0;
  std::uint64_t charged_corners_ = 0;
  Map map_;
};

void MapReader::read_counts() {
  TextCursor& cursor = in_.cursor();
  if (!cursor.next_line()) {
    fail(ErrorCode::CountMismatch,
         "the file has no content; expected the numbers of vertices and faces");
  }
  counts_line_ = cursor.line();
  const char* const start = cursor.position();
  vertices_ = in_.read_count("the number of vertices");
  faces_ = in_.read_count("the number of faces");
  in_.end_line("two numbers on this line: vertices and faces");
  in_.require_bytes(
      std::uint64_t{vertices_} * kVertexBytes + std::uint64_t{faces_} * kFaceBytes,
      std::to_string(vertices_) + " vertices and " + std::to_string(faces_) + " faces", start);
  in_.charge(vertices_ * sizeof(Point2) + faces_ * sizeof(std::uint32_t));
  map_.points.reserve(vertices_);
  map_.cycle_begin.reserve(std::size_t{faces_} + 1);
}

void MapReader::read_vertices() {
  for (std::uint32_t i = 0; i < vertices_; ++i) {
    in_.next_record("vertex", i, vertices_);
    in_.read_point(map_.points);
  }
}

void MapReader::read_faces() {
  for (std::uint32_t i = 0; i < faces_; ++i) {
    in_.next_record("face", i, faces_);
    read_face();
  }
}

void MapReader::read_face() {
  TextCursor& cursor = in_.cursor();
  const char* const start = cursor.position();
  const std::size_t first = map_.cycle_begin.back();
  const char* last = start;
  while (!cursor.at_line_end()) {
    last = cursor.position();
    const std::uint32_t vertex = in_.read_id("vertex", vertices_) - 1;
    if (map_.corners.size() > first && map_.corners.back() == vertex) {
      fail(ErrorCode::DegenerateFace,
           in_.record_name() + " names vertex " + std::to_string(vertex + 1) + " twice in a row",
           last);
    }
    add_corner(vertex);
  }
  const std::size_t size = map_.corners.size() - first;
  if (size >= 2 && map_.corners[first] == map_.corners.back()) {
    fail(ErrorCode::DegenerateFace,
         in_.record_name() + " ends with the vertex it starts with; cycles close by themselves",
         last);
  }
  check_face(start);
  map_.cycle_begin.push_back(static_cast<std::uint32_t>(map_.corners.size()));
}

void MapReader::check_face(const char* start) const {
  const std::span<const std::uint32_t> face(map_.corners.data() + map_.cycle_begin.back(),
                                            map_.corners.data() + map_.corners.size());
  if (face.size() < 3) {
    fail(ErrorCode::DegenerateFace,
         in_.record_name() + " has " + std::to_string(face.size()) +
             (face.size() == 1 ? " vertex" : " vertices") + "; at least 3 are needed",
         start);
  }
  if (is_on_one_line(map_.points, face)) {
    fail(ErrorCode::DegenerateFace, "all vertices of " + in_.record_name() + " lie on one line",
         start);
  }
}

void MapReader::add_corner(std::uint32_t vertex) {
  constexpr std::uint64_t kStep = 1U << 14U;
  if (map_.corners.size() == charged_corners_) {
    if (charged_corners_ > RecordReader::kMostIds - kStep) {
      fail(ErrorCode::ResourceLimit, "more than 2^32 corners");
    }
    // While the list grows, the old one exists, too.
    in_.charge(3 * kStep * sizeof(std::uint32_t));
    charged_corners_ += kStep;
  }
  map_.corners.push_back(vertex);
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

namespace {

void write_cycle(TextOutput& out, std::span<const std::uint32_t> cycle) {
  char separator = '\0';
  for (const std::uint32_t vertex : cycle) {
    if (separator != '\0') out << separator;
    out << vertex + 1;
    separator = ' ';
  }
  out << '\n';
}

}  // namespace

void write_map(std::ostream& stream, const Map& map) {
  TextOutput out(stream);
  out << std::uint64_t{map.vertex_count()} << ' ' << std::uint64_t{map.cycle_count()} << '\n';
  for (std::uint32_t v = 0; v < map.vertex_count(); ++v) {
    write_point(out, map.points, v);
    out << '\n';
  }
  for (std::size_t c = 0; c < map.cycle_count(); ++c) write_cycle(out, map.cycle(c));
  out.flush();
}

}  // namespace plumb
