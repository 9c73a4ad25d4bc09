#include "plumb/picture/view.h"

#include <cmath>
#include <limits>

namespace plumb {
namespace {

constexpr double kMargin = 6;  // picture units around the frame that are drawn too
constexpr std::size_t kSamples = 100000;
constexpr double kLeastWindow = 1e-200;  // keeps scales finite

double clamped(double value) { return std::isnan(value) ? 0 : std::clamp(value, -2.0, 2.0); }

/// The half-plane sign * coordinate <= bound, for clipping.
struct Side {
  bool is_x;
  double sign, bound;
  double excess(Point2 p) const { return sign * (is_x ? p.x : p.y) - bound; }
};

Point2 between(Point2 a, Point2 b, double t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}

std::vector<Side> sides(const Rectangle& r) {
  return {{true, -1, -r.left}, {true, 1, r.right}, {false, -1, -r.top}, {false, 1, r.bottom}};
}

/// One round of Sutherland and Hodgman.
std::vector<Point2> cut(const std::vector<Point2>& ring, const Side& side) {
  std::vector<Point2> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2 a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const double ea = side.excess(a), eb = side.excess(b);
    if (ea <= 0) kept.push_back(a);
    if ((ea <= 0) != (eb <= 0)) kept.push_back(between(a, b, ea / (ea - eb)));
  }
  return kept;
}

}  // namespace

Rectangle core_of(const std::vector<Point2>& points) {
  std::vector<double> xs, ys;
  for (const Point2& p : points) {
    xs.push_back(p.x);
    ys.push_back(p.y);
  }
  if (xs.empty()) return {};
  std::sort(xs.begin(), xs.end());
  std::sort(ys.begin(), ys.end());
  const std::size_t low = xs.size() / 40, high = xs.size() - 1 - low;
  return {xs[low], ys[low], xs[high], ys[high]};
}

Rectangle without_far_parts(const Rectangle& core, const Rectangle& all) {
  const Rectangle window =
      Rectangle::around(core.centre(), core.width() * .53, core.height() * .53);
  return window.width() * window.height() < all.width() * all.height() / 2 ? window : all;
}

Plane::Plane(const Map& map) : map_(map) {
  find_scale();
  find_extent();
}

void Plane::find_scale() {
  double largest = 0;
  for (const std::uint32_t v : map_.corners) {
    const Point2 p = map_.points.approx(v);
    largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  if (largest == 0) return;
  int above = 0;  // |x| < 2^above
  std::frexp(largest, &above);
  const int exponent = -1 - above;  // then |x| < 1/2, and differences below 1
  factor_1_ = std::ldexp(1.0, exponent / 2);
  factor_2_ = std::ldexp(1.0, exponent - exponent / 2);
}

void Plane::find_extent() {
  bool is_first = true;
  for (const std::uint32_t v : map_.corners) {
    const Point2 p = at(v);
    if (is_first) extent_ = Rectangle::around(p, 0, 0);
    is_first = false;
    extent_.include(p);
  }
  centre_ = extent_.centre();
  extent_ = Rectangle::around({}, extent_.width() / 2, extent_.height() / 2);
}

Rectangle Plane::core() const {
  std::vector<Point2> samples;
  const std::size_t step = map_.corners.size() / kSamples + 1;
  for (std::size_t i = 0; i < map_.corners.size(); i += step) {
    samples.push_back(at(map_.corners[i]));
  }
  return core_of(samples);
}

Point2 Plane::at(Point2 p) const {
  return {clamped(p.x * factor_1_ * factor_2_ - centre_.x),
          clamped(p.y * factor_1_ * factor_2_ - centre_.y)};
}

std::vector<Point2> Plane::ring(std::size_t cycle) const {
  std::vector<Point2> ring;
  for (const std::uint32_t v : map_.cycle(cycle)) ring.push_back(at(v));
  return ring;
}

View::View(const Rectangle& frame, const Rectangle& window)
    : frame_(frame), centre_(window.centre()) {
  const double width = std::max(window.width(), kLeastWindow);
  const double height = std::max(window.height(), kLeastWindow);
  scale_ = std::min(frame.width() / width, frame.height() / height);
  window_ = Rectangle::around(centre_, (frame.width() / 2 + kMargin) / scale_,
                              (frame.height() / 2 + kMargin) / scale_);
}

std::vector<Point2> View::clipped(std::vector<Point2> ring) const {
  for (const Side& side : sides(window_)) ring = cut(ring, side);
  return ring;
}

std::optional<std::pair<Point2, Point2>> View::clipped(Point2 a, Point2 b) const {
  for (const Side& side : sides(window_)) {
    const double ea = side.excess(a), eb = side.excess(b);
    if (ea > 0 && eb > 0) return std::nullopt;
    if (ea > 0) a = between(a, b, ea / (ea - eb));
    if (eb > 0) b = between(a, b, ea / (ea - eb));
  }
  return std::pair(a, b);
}

}  // namespace plumb
