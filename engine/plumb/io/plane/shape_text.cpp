#include "plumb/io/plane/shape_text.h"

#include <algorithm>
#include <utility>

namespace plumb {

std::string ShapeCollector::add_ring(std::uint32_t first, std::uint32_t last) {
  constexpr std::uint32_t kFewestCorners = 3;
  const bool is_closed =
      last - first > 1 && compare_xy(shapes_.points, first, last - 1) == Sign::Zero;
  const std::uint32_t end = is_closed ? last - 1 : last;
  if (end - first < kFewestCorners) {
    return "a ring of " + std::to_string(last - first) +
           (last - first == 1 ? " position" : " positions") +
           "; at least 4 are needed, the last equal to the first";
  }
  if (!is_closed) ++unclosed_;
  for (std::uint32_t i = first; i < end; ++i) shapes_.ring_corners.push_back(i);
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

void ShapeCollector::pass_over(std::string_view what) {
  if (std::ranges::find(passed_over_, what) == passed_over_.end()) passed_over_.emplace_back(what);
}

PlaneFile ShapeCollector::take() {
  std::string note;
  for (const std::string& what : passed_over_) {
    note.append(note.empty() ? "passed over: " : ", ").append(what);
  }
  if (!note.empty()) notes_.insert(notes_.begin(), std::move(note));
  if (unclosed_ > 0) {
    notes_.push_back(std::string(kClosedByEdge) + " (" + std::to_string(unclosed_) + ')');
  }
  return {std::move(shapes_), std::move(continued_), std::move(without_polygons_),
          std::move(notes_)};
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
