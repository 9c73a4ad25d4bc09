#include "plumb/io/plane/shape_text.h"

#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::uint32_t kStep = 4096;  // Positions between two checks of the context.
constexpr std::uint64_t kMostPositions = 0xffff'fffe - kStep;
// A position lies in the table, and as a corner in vectors that grow by doubling; while one grows,
// old and new exist.
constexpr std::uint64_t kCornerBytes = 3 * sizeof(std::uint32_t);

}  // namespace

void ShapeCollector::expect(const TextCursor& cursor, std::size_t positions) {
  charge(cursor, positions * sizeof(Point2));
  shapes_.points.reserve(positions);
}

/// Charges memory. A limit is reported at the place where it was met, like every other error.
void ShapeCollector::charge(const TextCursor& cursor, std::uint64_t bytes) {
  try {
    context_.charge_memory(bytes, "the shapes");
  } catch (const Error& error) {
    cursor.fail(error.code(), error.message());
  }
}

void ShapeCollector::add_position(const TextCursor& cursor, const ReadNumber& x,
                                  const ReadNumber& y) {
  if (position_count() == charged_positions_) {
    if (charged_positions_ > kMostPositions) {
      cursor.fail(ErrorCode::ResourceLimit, "more than 2^32 positions");
    }
    context_.checkpoint("read", cursor.bytes_read(), total_bytes_);
    charge(cursor, kStep * kCornerBytes);
    charged_positions_ += kStep;
  }
  if (const std::size_t bytes = exact_bytes(x, y)) charge(cursor, bytes);
  push_point(shapes_.points, x, y);
}

std::string ShapeCollector::add_ring(std::uint32_t first, std::uint32_t last) {
  constexpr std::uint32_t kFewest = 4;
  if (last - first < kFewest) {
    return "a ring of " + std::to_string(last - first) +
           " positions; at least 4 are needed, the last equal to the first";
  }
  if (compare_xy(shapes_.points, first, last - 1) != Sign::Zero) {
    return "the ring does not end with the position that it starts with";
  }
  for (std::uint32_t i = first; i + 1 < last; ++i) shapes_.ring_corners.push_back(i);
  shapes_.end_ring();
  return {};
}

std::string ShapeCollector::add_line(std::uint32_t first, std::uint32_t last) {
  if (last - first < 2) return "a line of one position; at least 2 are needed";
  for (std::uint32_t i = first; i < last; ++i) shapes_.line_corners.push_back(i);
  shapes_.end_line();
  return {};
}

void ShapeCollector::add_points(std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t i = first; i < last; ++i) shapes_.single_points.push_back(i);
}

void ShapeCollector::end_polygon() {
  if (shapes_.polygon_begin.back() != shapes_.ring_count()) shapes_.end_polygon();
}

void ShapeWriter::write() {
  const int kinds = (shapes_.polygon_count() > 0 ? 1 : 0) + (shapes_.line_count() > 0 ? 1 : 0) +
                    (shapes_.single_points.empty() ? 0 : 1);
  if (kinds != 1) begin_collection(kinds == 0);
  write_geometries();
  if (kinds != 1) end_collection(kinds == 0);
  out_ << '\n';
  out_.flush();
}

void ShapeWriter::write_geometries() {
  write_geometry("Polygon", shapes_.polygon_count(), [this](std::size_t p) { write_polygon(p); });
  write_geometry("LineString", shapes_.line_count(), [this](std::size_t l) {
    const auto line = shapes_.line(l);
    write_list(0, line.size(), [&](std::size_t i) { write_position(point(line[i])); });
  });
  write_geometry("Point", shapes_.single_points.size(),
                 [this](std::size_t i) { write_point(point(shapes_.single_points[i])); });
}

template <class Item>
void ShapeWriter::write_geometry(std::string_view name, std::size_t count, Item item) {
  if (count == 0) return;
  if (!is_first_) out_ << lists_.separator;
  is_first_ = false;
  begin_geometry(name, count > 1);
  if (count == 1) {
    item(0);
  } else {
    write_list(0, count, item);
  }
  end_geometry();
}

/// Writes the rings of a polygon, each with its first position again at the end.
void ShapeWriter::write_polygon(std::size_t p) {
  write_list(shapes_.polygon_begin[p], shapes_.polygon_begin[p + 1], [this](std::size_t r) {
    const auto ring = shapes_.ring(r);
    write_list(0, ring.size() + 1,
               [&](std::size_t i) { write_position(point(ring[i == ring.size() ? 0 : i])); });
  });
}

}  // namespace plumb
