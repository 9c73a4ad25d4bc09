// What the readers of WKT and GeoJSON have in common: collects shapes, charged to a context.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "plumb/base/context.h"
#include "plumb/io/number_reader.h"
#include "plumb/io/plane_shapes.h"
#include "plumb/io/text_cursor.h"

namespace plumb {

class ShapeCollector {
 public:
  ShapeCollector(Context& context, std::size_t total_bytes)
      : context_(context), total_bytes_(total_bytes) {}

  /// Room for so many positions, charged at once: for counts that the file bears out. `cursor`: where a limit is told.
  void expect(const TextCursor& cursor, std::size_t positions);

  /// Positions read so far: the index of the next one.
  std::uint32_t position_count() const { return static_cast<std::uint32_t>(shapes_.points.size()); }
  /// A position read up to the place of `cursor`, where a limit is told.
  void add_position(const TextCursor& cursor, const ReadNumber& x, const ReadNumber& y);

  // Each of these takes the positions [first, last). Returned is what is wrong with them, if
  // anything; they are not added then.
  /// A closed ring of the polygon that end_polygon() ends.
  std::string add_ring(std::uint32_t first, std::uint32_t last);
  std::string add_line(std::uint32_t first, std::uint32_t last);
  void add_points(std::uint32_t first, std::uint32_t last);
  /// Does nothing without a ring.
  void end_polygon();

  PlaneShapes take() { return std::move(shapes_); }

 private:
  void charge(const TextCursor& cursor, std::uint64_t bytes);

  Context& context_;
  std::size_t total_bytes_;
  std::uint64_t charged_positions_ = 0;
  PlaneShapes shapes_;
};

}  // namespace plumb
