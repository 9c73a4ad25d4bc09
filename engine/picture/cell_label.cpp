#include "plumb/picture/cell_label.h"

#include <cmath>

#include "plumb/picture/rings.h"

namespace plumb {
namespace {

// Heights to try, as parts of the polygon's height: the middle first.
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

/// Where a horizontal line crosses the edges, from left to right.
std::vector<double> crossings(const Rings& rings, double y) {
  std::vector<double> xs;
  for_edges(rings, [&xs, y](Point2 a, Point2 b) {
    if ((a.y < y) != (b.y < y)) xs.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
  });
  std::sort(xs.begin(), xs.end());
  return xs;
}

/// The part of the edge within the box's rows lies beside the box.
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
