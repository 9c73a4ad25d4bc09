// What the readers and writers of WKT and GeoJSON have in common.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include "plumb/base/context.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/io/text/record_reader.h"
#include "plumb/io/text/text_output.h"

namespace plumb {

/// Collects shapes, charged to a context.
class ShapeCollector {
 public:
  ShapeCollector(Context& context, std::size_t total_bytes)
      : context_(context), total_bytes_(total_bytes) {}

  /// Reserves memory for so many positions, charged at once. Requires counts that the file
  /// supports. A limit is reported at `cursor`.
  void expect(const TextCursor& cursor, std::size_t positions);

  /// Returns the number of positions read so far, which is the index of the next one.
  std::uint32_t position_count() const { return static_cast<std::uint32_t>(shapes_.points.size()); }
  /// Adds a position that was read up to `cursor`, where a limit is reported.
  void add_position(const TextCursor& cursor, const ReadNumber& x, const ReadNumber& y);

  // Each of these takes the positions [first, last) and returns what is wrong with them, in which
  // case they are not added; else an empty string.
  /// Adds a closed ring to the polygon that end_polygon() ends.
  std::string add_ring(std::uint32_t first, std::uint32_t last);
  std::string add_line(std::uint32_t first, std::uint32_t last);
  void add_points(std::uint32_t first, std::uint32_t last);
  /// Ends a polygon; does nothing without a ring.
  void end_polygon();

  PlaneShapes take() { return std::move(shapes_); }

 private:
  void charge(const TextCursor& cursor, std::uint64_t bytes);

  Context& context_;
  std::size_t total_bytes_;
  std::uint64_t charged_positions_ = 0;
  PlaneShapes shapes_;
};

// What the writers of WKT and GeoJSON have in common: both write shapes as nested lists.

/// Writes shapes; the formats differ in brackets, separators and names.
class ShapeWriter {
 public:
  virtual ~ShapeWriter() = default;
  ShapeWriter(const ShapeWriter&) = delete;
  ShapeWriter& operator=(const ShapeWriter&) = delete;

  /// Writes one line: a geometry of the only kind of shape there is, or a collection of geometries.
  void write();

 protected:
  struct Lists {
    char open;
    std::string_view separator;
    char close;
  };
  ShapeWriter(std::ostream& out, const PlaneShapes& shapes, Lists lists, Context& context)
      : out_(out, context), shapes_(shapes), lists_(lists) {}

  /// Called around the geometries if their number is not one.
  virtual void begin_collection(bool is_empty) = 0;
  virtual void end_collection(bool is_empty) = 0;
  /// Called around the coordinates of `count` > 0 shapes called "Polygon", "LineString" or "Point".
  virtual void begin_geometry(std::string_view name, bool is_multiple) = 0;
  virtual void end_geometry() = 0;
  /// Writes the coordinates of a geometry of one point.
  virtual void write_point(Point2 p) = 0;
  /// Writes a member of a list of positions.
  virtual void write_position(Point2 p) = 0;

  template <class Item>
  void write_list(std::size_t first, std::size_t last, Item item) {
    out_ << lists_.open;
    for (std::size_t i = first; i < last; ++i) {
      if (i != first) out_ << lists_.separator;
      item(i);
    }
    out_ << lists_.close;
  }

  TextOutput out_;

 private:
  void write_geometries();
  template <class Item>
  void write_geometry(std::string_view name, std::size_t count, Item item);
  void write_polygon(std::size_t p);
  Point2 point(std::uint32_t i) const { return shapes_.points.approx(i); }

  const PlaneShapes& shapes_;
  Lists lists_;
  bool is_first_ = true;
};

}  // namespace plumb
