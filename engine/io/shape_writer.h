// What the writers of WKT and GeoJSON have in common: both spell shapes as nested lists.
#pragma once

#include <cstdint>
#include <ostream>
#include <string_view>

#include "plumb/io/plane_shapes.h"
#include "plumb/io/text_output.h"

namespace plumb {

class ShapeWriter {
 public:
  virtual ~ShapeWriter() = default;
  ShapeWriter(const ShapeWriter&) = delete;
  ShapeWriter& operator=(const ShapeWriter&) = delete;

  /// One line: a geometry of the only kind of shape there is, or a collection of such.
  void write();

 protected:
  struct Lists {
    char open;
    std::string_view separator;
    char close;
  };
  ShapeWriter(std::ostream& out, const PlaneShapes& shapes, Lists lists, Context& context)
      : out_(out, context), shapes_(shapes), lists_(lists) {}

  /// Around the geometries, when their number is not one.
  virtual void begin_collection(bool is_empty) = 0;
  virtual void end_collection(bool is_empty) = 0;
  /// Around the coordinates of `count` > 0 shapes called "Polygon", "LineString" or "Point".
  virtual void begin_geometry(std::string_view name, bool is_multiple) = 0;
  virtual void end_geometry() = 0;
  /// The coordinates of a geometry of one point.
  virtual void write_point(Point2 p) = 0;
  /// A member of a list of positions.
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
