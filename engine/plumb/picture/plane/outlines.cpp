// Outlines for pictures of the plane.
//
// Chains are walked first from vertices where they end, then around rings, so every edge is visited
// once and dashes run through vertices of degree two. A label's box is searched on a few horizontal
// lines through the polygon: on each, the spans inside are known from the sorted crossings, and a
// box is accepted if no edge passes through it. Faces too small to be seen only mark cells of a
// grid, which are written as runs: their number is bounded by the picture, not by the map. All of
// it is in doubles and affects pictures only.
// Tested by tests/picture/overlay_svg_test.cpp and tests/picture/nef2_svg_test.cpp.
#include "plumb/picture/plane/outlines.h"

#include <cmath>

namespace plumb {
namespace {

constexpr double kCell = 2;  // In picture units.

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

namespace {

class ChainWalker {
 public:
  ChainWalker(const PlaneComplex& complex, std::span<const std::uint8_t> kind, std::uint8_t wanted)
      : complex_(complex), degree_(complex.vertex_count()), is_left_(complex.edge_count()) {
    for (std::size_t e = 0; e < is_left_.size(); ++e) {
      if (kind[e] != wanted) continue;
      is_left_[e] = true;
      ++left_;
      const HalfedgeId h = first_half(EdgeId(e));
      ++degree_[complex.dcel.origin(h)];
      ++degree_[complex.dcel.target(h)];
    }
  }

  std::size_t left() const { return left_; }
  bool is_left(EdgeId e) const { return is_left_[e]; }
  bool begins_chain(HalfedgeId h) const { return degree_[complex_.dcel.origin(h)] != 2; }

  /// Appends the chain that begins with h. A closed chain is walked around once.
  void append(HalfedgeId h, std::span<const Point2> at, PathData& path) {
    path.move_to(at[complex_.dcel.origin(h).value()]);
    while (h.is_valid()) {
      is_left_[edge_of(h)] = false;
      --left_;
      path.line_to(at[complex_.dcel.target(h).value()]);
      h = following(h);
    }
  }

 private:
  HalfedgeId following(HalfedgeId h) const {
    const VertexId v = complex_.dcel.target(h);
    if (degree_[v] != 2) return {};
    for (const HalfedgeId g : complex_.dcel.around(v)) {
      if (!complex_.is_frame(g) && is_left(edge_of(g))) return g;
    }
    return {};
  }

  const PlaneComplex& complex_;
  IdVector<VertexId, std::uint32_t> degree_;  ///< Edges of the kind at each vertex.
  IdVector<EdgeId, bool> is_left_;
  std::size_t left_ = 0;
};

}  // namespace

std::size_t append_chains(const PlaneComplex& complex, std::span<const std::uint8_t> kind,
                          std::uint8_t wanted, std::span<const Point2> at, std::size_t max_points,
                          PathData& path) {
  ChainWalker walker(complex, kind, wanted);
  for (const bool is_open : {true, false}) {  // Chains with ends are walked first, then rings.
    for (std::size_t e = 0; e < complex.edge_count(); ++e) {
      for (const HalfedgeId h : {first_half(EdgeId(e)), twin(first_half(EdgeId(e)))}) {
        if (path.points() >= max_points) return walker.left();
        if (!walker.is_left(EdgeId(e)) || (is_open && !walker.begins_chain(h))) continue;
        walker.append(h, at, path);
      }
    }
  }
  return 0;
}

double total_length(const PlaneComplex& complex, std::span<const std::uint8_t> kind,
                    std::uint8_t wanted, std::span<const Point2> at) {
  double sum = 0;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    if (kind[e] != wanted) continue;
    const HalfedgeId h = first_half(EdgeId(e));
    const Point2 a = at[complex.dcel.origin(h).value()], b = at[complex.dcel.target(h).value()];
    sum += std::hypot(a.x - b.x, a.y - b.y);
  }
  return sum;
}

namespace {

// The heights to try, as parts of the height of the polygon. The middle is tried first.
constexpr double kHeights[] = {.5, .4, .6, .3, .7, .2, .8};

using Rings = std::vector<std::vector<Point2>>;

/// Calls see(a, b) for every edge.
template <class See>
void for_edges(const Rings& rings, const See& see) {
  for (const std::vector<Point2>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      see(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    }
  }
}

/// Returns where a horizontal line crosses the edges, from left to right.
std::vector<double> crossings(const Rings& rings, double y) {
  std::vector<double> xs;
  for_edges(rings, [&xs, y](Point2 a, Point2 b) {
    if ((a.y < y) != (b.y < y)) xs.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
  });
  std::sort(xs.begin(), xs.end());
  return xs;
}

/// Whether the part of the edge in the rows of the box lies beside the box.
bool is_beside(const Rectangle& box, Point2 a, Point2 b) {
  if (std::max(a.y, b.y) <= box.top || std::min(a.y, b.y) >= box.bottom) return true;
  const auto x_at = [a, b](double y) {
    if (a.y == b.y) return a.x;
    return a.x + (b.x - a.x) * std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0);
  };
  double low = std::min(x_at(box.top), x_at(box.bottom));
  double high = std::max(x_at(box.top), x_at(box.bottom));
  if (a.y == b.y) {
    low = std::min(a.x, b.x);
    high = std::max(a.x, b.x);
  }
  return high <= box.left || low >= box.right;
}

bool is_free(const Rings& rings, const Rectangle& box) {
  bool is_free = true;
  for_edges(rings, [&](Point2 a, Point2 b) { is_free = is_free && is_beside(box, a, b); });
  return is_free;
}

}  // namespace

std::optional<Rectangle> room_inside(const Rings& rings, double width, double height) {
  if (rings.empty()) return std::nullopt;
  Rectangle all = box_of(rings[0]);
  for_edges(rings, [&all](Point2 a, Point2) { all.include(a); });
  if (all.width() < width || all.height() < height) return std::nullopt;
  for (const double part : kHeights) {
    const double y = all.top + part * all.height();
    const std::vector<double> xs = crossings(rings, y);
    std::size_t widest = xs.size();
    for (std::size_t i = 0; i + 1 < xs.size(); i += 2) {
      if (widest == xs.size() || xs[i + 1] - xs[i] > xs[widest + 1] - xs[widest]) widest = i;
    }
    if (widest == xs.size() || xs[widest + 1] - xs[widest] < width) continue;
    const Rectangle box =
        Rectangle::around({(xs[widest] + xs[widest + 1]) / 2, y}, width / 2, height / 2);
    if (is_free(rings, box)) return box;
  }
  return std::nullopt;
}

}  // namespace plumb
