#include "plumb/io/shape_writer.h"

namespace plumb {

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

/// Its rings, each with its first position again at the end.
void ShapeWriter::write_polygon(std::size_t p) {
  write_list(shapes_.polygon_begin[p], shapes_.polygon_begin[p + 1], [this](std::size_t r) {
    const auto ring = shapes_.ring(r);
    write_list(0, ring.size() + 1,
               [&](std::size_t i) { write_position(point(ring[i == ring.size() ? 0 : i])); });
  });
}

}  // namespace plumb
