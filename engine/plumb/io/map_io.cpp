// Reading and writing of the `map` format: counts, points, and faces as cycles of vertices numbered
// from 1.
//
// Counts are compared with the bytes that follow before memory is reserved. A face is accepted only
// if it has at least three corners, no vertex twice in a row, and corners that are not all on one
// line. The last condition is decided by exact orientation signs, up to the first turn. Whether the
// faces form a planar subdivision is not decided here but by the check of maps (plane/map_check.h).
//
// Polygons of WKT and GeoJSON have their own positions each; equal positions are found by sorting.
// They become a map ring by ring, and outer boundaries are left to the check.
// Format: docs/formats.md, section map.
// Tested by tests/io/map_io_test.cpp.
#include "plumb/io/map_io.h"

#include <algorithm>
#include <cstdint>
#include <ostream>

#include "plumb/io/plane/geojson.h"
#include "plumb/io/plane/wkb.h"
#include "plumb/io/plane/wkt.h"
#include "plumb/io/text/files.h"
#include "plumb/io/text/foreign_files.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/io/text/text_output.h"
#include "plumb/plane/sweep/point_ranks.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/plane/plane_points.h"
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
      : in_(text, options, context, "the map", ResultNumbers::Fractions) {}

  Map read() {
    read_counts();
    read_vertices();
    read_faces();
    if (in_.cursor().next_line()) {
      fail(ErrorCode::CountMismatch, "there is more after the last face; line " +
                                         std::to_string(counts_line_) + " announces " +
                                         std::to_string(faces_) + " faces");
    }
    map_.corners.shrink_to_fit();  // There is no line that states the number of corners.
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
    // While the list grows, the old list exists, too.
    in_.charge(3 * kStep * sizeof(std::uint32_t));
    charged_corners_ += kStep;
  }
  map_.corners.push_back(vertex);
}

}  // namespace

Map read_map(std::string_view text, const ReadOptions& options, Context& context) {
  const RoundToNearest rounding;
  return naming_foreign_files(text, "map", options.name,
                              [&] { return MapReader(text, options, context).read(); });
}

Map read_map_file(const std::string& path, ReadOptions options, Context& context) {
  options.name = input_name(path);
  const std::string text = read_input(path, context);
  Map map = read_map(text, options, context);
  context.release_memory(text.size());
  return map;
}

namespace {

/// Makes a map of the rings of polygons.
class CoverageBuilder {
 public:
  CoverageBuilder(const PlaneShapes& shapes, Context& context)
      : shapes_(shapes), memory_(context), vertex_(shapes.points.size(), kUnused) {
    memory_.add(kBytesPerPosition * shapes.points.size(), "a coverage of polygons");
    ranks_ = rank_points(shapes.points, std::vector<char>(shapes.points.size(), 1));
  }

  Map build() {
    for (std::size_t p = 0; p < shapes_.polygon_count(); ++p) {
      if (add_ring(shapes_.polygon_begin[p], Sign::Positive)) continue;
      throw Error(ErrorCode::DegenerateFace,
                  "polygon " + std::to_string(p + 1) + " has fewer than three different corners");
    }
    for (std::size_t p = 0; p < shapes_.polygon_count(); ++p) {
      for (std::uint32_t r = shapes_.polygon_begin[p] + 1; r < shapes_.polygon_begin[p + 1]; ++r) {
        add_ring(r, Sign::Negative);
      }
    }
    return std::move(map_);
  }

 private:
  static constexpr std::uint32_t kUnused = PointRanks::kUnused;
  static constexpr std::uint64_t kBytesPerPosition = 64;

  std::uint32_t vertex_at(std::uint32_t position);
  bool add_ring(std::uint32_t ring, Sign orientation);

  const PlaneShapes& shapes_;
  MemoryCharge memory_;
  PointRanks ranks_;
  std::vector<std::uint32_t> vertex_;  // For each rank of a position, the vertex.
  Map map_;
};

std::uint32_t CoverageBuilder::vertex_at(std::uint32_t position) {
  std::uint32_t& vertex = vertex_[ranks_.rank[position]];
  if (vertex != kUnused) return vertex;
  vertex = static_cast<std::uint32_t>(map_.points.size());
  if (shapes_.points.is_double(position)) {
    map_.points.push_back(shapes_.points.approx(position));
  } else {
    const RationalPoint2 p = shapes_.points.exact(position);
    map_.points.push_back(p.x, p.y);
  }
  return vertex;
}

/// Adds a ring, and reverses it if it has the wrong direction. Returns whether it has three
/// corners.
bool CoverageBuilder::add_ring(std::uint32_t ring, Sign orientation) {
  std::vector<std::uint32_t> cycle;
  for (const std::uint32_t position : shapes_.ring(ring)) {
    const std::uint32_t vertex = vertex_at(position);
    if (cycle.empty() || cycle.back() != vertex) cycle.push_back(vertex);
  }
  while (cycle.size() > 1 && cycle.back() == cycle.front()) cycle.pop_back();
  if (cycle.size() < 3) return false;
  const Sign area = polygon_area_sign(map_.points, cycle);
  if (area != Sign::Zero && area != orientation) std::reverse(cycle.begin() + 1, cycle.end());
  map_.add_cycle(cycle);
  return true;
}

/// Returns the format of a file of polygons, or nothing if the file is a map.
std::optional<PlaneFormat> polygon_format(const std::string& path, std::string_view text) {
  const std::optional<PlaneFormat> named = plane_format_of(path);
  if (named) return *named == PlaneFormat::Nef2 ? std::nullopt : named;
  const PlaneFormat guessed = guess_plane_format(text);
  if (guessed == PlaneFormat::Nef2) return std::nullopt;
  return guessed == PlaneFormat::Wkt && !begins_like_wkt(text) ? std::nullopt
                                                               : std::optional(guessed);
}

PlaneFile read_polygons(std::string_view text, PlaneFormat format, const ReadOptions& options,
                        Context& context) {
  if (format == PlaneFormat::GeoJson) return read_geojson(text, options, context);
  if (format == PlaneFormat::Wkb) return read_wkb(text, options, context);
  return read_wkt(text, options, context);
}

}  // namespace

Map map_of_polygons(const PlaneShapes& shapes, Context& context) {
  return CoverageBuilder(shapes, context).build();
}

MapFile read_map_or_polygons(const std::string& path, ReadOptions options, Context& context) {
  const std::string text = read_input(path, context);
  MapFile file = read_map_or_polygons(text, path, std::move(options), context);
  context.release_memory(text.size());
  return file;
}

MapFile read_map_or_polygons(std::string_view text, const std::string& path, ReadOptions options,
                             Context& context) {
  options.name = input_name(path);
  MapFile file;
  if (const auto format = polygon_format(path, text)) {
    PlaneFile read = naming_foreign_files(text, "WKT WKB GeoJSON", options.name, [&] {
      return read_polygons(text, *format, options, context);
    });
    const PlaneShapes& shapes = read.shapes;
    file.notes = std::move(read.notes);
    file.is_polygons = true;
    file.dropped = shapes.line_count() + shapes.single_points.size();
    file.map = map_of_polygons(shapes, context);
  } else {
    file.map = read_map(text, options, context);
  }
  return file;
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
