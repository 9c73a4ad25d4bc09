#include "oracle/shape_oracle.h"

#include <algorithm>

namespace plumb::testing {
namespace {

std::vector<ExactPoint> all_points(const PlaneShapes& shapes) {
  std::vector<ExactPoint> points;
  for (std::uint32_t i = 0; i < shapes.points.size(); ++i) {
    points.push_back(exact_of(shapes.points.exact(i)));
  }
  return points;
}

/// (b - a) x (p - a)
BigRational turn(const ExactPoint& a, const ExactPoint& b, const ExactPoint& p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

bool is_on_segment(const ExactPoint& a, const ExactPoint& b, const ExactPoint& p) {
  const bool is_in_box = std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
                         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
  return is_in_box && turn(a, b, p) == 0;
}

/// Does the ray from p to the right cross a -> b? Ends count as above the ray's line.
bool crosses_ray(const ExactPoint& a, const ExactPoint& b, const ExactPoint& p) {
  const bool goes_up = a.y < p.y && b.y >= p.y;
  const bool goes_down = b.y < p.y && a.y >= p.y;
  if (goes_up) return turn(a, b, p) > 0;
  return goes_down && turn(b, a, p) > 0;
}

}  // namespace

ShapeTwin::ShapeTwin(const PlaneShapes& shapes) {
  const std::vector<ExactPoint> points = all_points(shapes);
  const auto chain_of = [&](std::span<const std::uint32_t> corners) {
    Chain chain;
    for (const std::uint32_t corner : corners) chain.push_back(points[corner]);
    return chain;
  };
  for (std::size_t p = 0; p < shapes.polygon_count(); ++p) {
    std::vector<Chain>& rings = polygons_.emplace_back();
    for (std::uint32_t r = shapes.polygon_begin[p]; r < shapes.polygon_begin[p + 1]; ++r) {
      Chain ring = chain_of(shapes.ring(r));
      ring.push_back(ring.front());
      rings.push_back(std::move(ring));
    }
  }
  for (std::size_t l = 0; l < shapes.line_count(); ++l) lines_.push_back(chain_of(shapes.line(l)));
  for (const std::uint32_t point : shapes.single_points) lines_.push_back({points[point]});
}

bool ShapeTwin::is_on(const Chain& chain, const ExactPoint& p) {
  if (chain.size() == 1) return chain.front() == p;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    if (is_on_segment(chain[i - 1], chain[i], p)) return true;
  }
  return false;
}

bool ShapeTwin::is_odd(const std::vector<Chain>& rings, const ExactPoint& p) {
  bool odd = false;
  for (const Chain& ring : rings) {
    for (std::size_t i = 1; i < ring.size(); ++i) odd ^= crosses_ray(ring[i - 1], ring[i], p);
  }
  return odd;
}

ShapePlace ShapeTwin::place(const ExactPoint& p) const {
  bool is_on_ring = false;
  for (const auto& rings : polygons_) {
    const auto is_on_it = [&](const Chain& ring) { return is_on(ring, p); };
    if (std::any_of(rings.begin(), rings.end(), is_on_it)) {
      is_on_ring = true;
    } else if (is_odd(rings, p)) {
      return ShapePlace::Inside;
    }
  }
  const auto is_on_it = [&](const Chain& line) { return is_on(line, p); };
  if (std::any_of(lines_.begin(), lines_.end(), is_on_it)) return ShapePlace::Inside;
  return is_on_ring ? ShapePlace::OnRing : ShapePlace::Outside;
}

std::vector<ExactPoint> telling_points(const PlaneShapes& shapes, std::size_t count) {
  const std::vector<ExactPoint> all = all_points(shapes);
  std::vector<ExactPoint> points;
  for (std::size_t i = 0; i < all.size() && points.size() + 3 <= count; ++i) {
    const ExactPoint& a = all[i];
    const ExactPoint& b = all[(i + 1) % all.size()];
    const ExactPoint& c = all[(i + 2) % all.size()];
    points.push_back(a);
    points.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2});
    points.push_back({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3});
  }
  return points;
}

}  // namespace plumb::testing
