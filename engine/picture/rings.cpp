#include "plumb/picture/rings.h"

namespace plumb {
namespace {

constexpr double kCell = 2;  // picture units

}  // namespace

Rectangle box_of(const std::vector<Point2>& ring) {
  Rectangle box = Rectangle::around(ring[0], 0, 0);
  for (const Point2& p : ring) box.include(p);
  return box;
}

std::vector<Point2> points_of(std::span<const VertexId> ring, std::span<const Point2> of_vertex) {
  std::vector<Point2> points;
  points.reserve(ring.size());
  for (const VertexId v : ring) points.push_back(of_vertex[v.value()]);
  return points;
}

std::vector<Point2> placed(const View& view, const std::vector<Point2>& ring) {
  std::vector<Point2> places;
  places.reserve(ring.size());
  for (const Point2& p : ring) places.push_back(view.place(p));
  return places;
}

void append_ring(const std::vector<Point2>& ring, PathData& path) {
  path.move_to(ring[0]);
  for (std::size_t i = 1; i < ring.size(); ++i) path.line_to(ring[i]);
  path.close();
}

TinyFaces::TinyFaces(const Rectangle& frame)
    : frame_(frame),
      columns_(static_cast<std::size_t>(frame.width() / kCell) + 1),
      marked_(columns_ * (static_cast<std::size_t>(frame.height() / kCell) + 1)) {}

void TinyFaces::mark(Point2 p) {
  if (!frame_.contains(p)) return;
  const auto x = static_cast<std::size_t>((p.x - frame_.left) / kCell);
  const auto y = static_cast<std::size_t>((p.y - frame_.top) / kCell);
  marked_[y * columns_ + x] = true;
  is_empty_ = false;
}

void TinyFaces::write(std::ostream& out) const {
  if (is_empty_) return;
  out << "<path class=\"tiny\" d=\"";
  for (std::size_t i = 0; i < marked_.size(); ++i) {
    if (!marked_[i]) continue;
    const std::size_t begin = i;
    while ((i + 1) % columns_ != 0 && marked_[i + 1]) ++i;
    write_run(begin, i + 1 - begin, out);
  }
  out << "\"/>\n";
}

void TinyFaces::write_run(std::size_t begin, std::size_t length, std::ostream& out) const {
  const double x = frame_.left + static_cast<double>(begin % columns_) * kCell;
  const std::size_t row = begin / columns_;
  const double y = frame_.top + static_cast<double>(row) * kCell;
  out << 'M' << svg_number(x) << ' ' << svg_number(y) << 'h'
      << svg_number(static_cast<double>(length) * kCell) << "v2h-"
      << svg_number(static_cast<double>(length) * kCell) << 'z';
}

}  // namespace plumb
