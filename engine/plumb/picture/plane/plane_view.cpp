// Windows of the plane for pictures.
//
// Map coordinates may be as large as 1e300 or as small as 5e-324; Plane centres and scales them by
// a power of two, split in two factors because one could overflow, so that everything afterwards is
// of ordinary size. Polygons are clipped to a view by Sutherland and Hodgman's algorithm (I. E.
// Sutherland, G. W. Hodgman, Reentrant polygon clipping, Communications of the ACM 17, 1974).
//
// PlaneWindow has rational borders, because an unbounded set is cut off by an exact intersection
// with the window. Borders are rounded outwards to short numbers, which keeps that cut cheap.
// Doubles are used for window coordinates if the window is not too small for its distance from the
// origin, else rationals.
// Tested by tests/picture/plane_view_test.cpp.
#include "plumb/picture/plane/plane_view.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

// In picture units. A margin of this width around the frame is drawn, too.
constexpr double kMargin = 6;
constexpr std::size_t kSamples = 100000;
constexpr double kLeastWindow = 1e-200;  // The limit keeps scales finite.

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

/// Returns a ring after one step of the clipping by Sutherland and Hodgman.
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
  int above = 0;  // |x| < 2^above.
  std::frexp(largest, &above);
  const int exponent = -1 - above;  // Then |x| < 1/2, and differences are below 1.
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

namespace {

constexpr double kLeastAspect = 0.45;
constexpr double kMostAspect = 1.15;
// The least ratio of the half width to the distance from the origin.
constexpr double kComfort = 0x1p-25;
// In window coordinates. Points that are nearer are compared exactly.
constexpr double kNearBorder = 1e-6;
constexpr double kTicks = 6;  // The approximate number of steps.

/// The least box around points.
struct ExactBox {
  bool is_empty = true;
  Rational left, bottom, right, top;

  void include(const RationalPoint2& p) {
    if (is_empty || p.x < left) left = p.x;
    if (is_empty || p.x > right) right = p.x;
    if (is_empty || p.y < bottom) bottom = p.y;
    if (is_empty || p.y > top) top = p.y;
    is_empty = false;
  }
};

bool is_plain_input(const PlanePoints& points, std::uint32_t i) {
  return i < points.inputs.size() && points.inputs.is_double(i);
}

/// Extends the box by all vertices. Doubles are compared directly, and other numbers as fractions.
void include_vertices(const PlaneComplex& complex, ExactBox& box) {
  Rectangle plain;
  bool has_plain = false;
  for (const std::uint32_t i : complex.vertex_point) {
    if (!is_plain_input(complex.points, i)) {
      box.include(exact(complex.points, i));
      continue;
    }
    const Point2 p = complex.points.inputs.approx(i);
    if (!has_plain) plain = Rectangle::around(p, 0, 0);
    has_plain = true;
    plain.include(p);
  }
  if (!has_plain) return;
  box.include({Rational(plain.left), Rational(plain.top)});
  box.include({Rational(plain.right), Rational(plain.bottom)});
}

/// Returns the point of the line a -> b nearest to p.
RationalPoint2 foot(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& p) {
  const Rational dx = b.x - a.x, dy = b.y - a.y;
  const Rational t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy);
  return {a.x + t * dx, a.y + t * dy};
}

/// Extends the box by lines without vertices. These lines are parallel, so a point of each on a
/// common perpendicular is enough to show all of them.
void include_lines(const PlaneComplex& complex, ExactBox& box) {
  RationalPoint2 beside{0, 0};
  if (!complex.vertex_point.empty()) beside = exact(complex.points, complex.vertex_point[0]);
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    const bool is_line = complex.is_at_infinity(complex.dcel.origin(h)) &&
                         complex.is_at_infinity(complex.dcel.target(h));
    if (!is_line) continue;
    const PlaneLine line = complex.line[e];
    const RationalPoint2 p =
        foot(complex.points.inputs.exact(line.a), complex.points.inputs.exact(line.b), beside);
    if (box.is_empty) beside = p;
    box.include(p);
  }
}

/// Returns a double between r - space and r, or r itself if the next double below r is none. Short
/// numbers make the cut cheap.
Rational short_below(const Rational& r, const Rational& space) {
  const double d = std::nextafter(nearest_double(r), -INFINITY);
  if (!std::isfinite(d)) return r;
  const Rational rounded(d);
  return rounded <= r && rounded >= r - space ? rounded : r;
}
Rational short_above(const Rational& r, const Rational& space) { return -short_below(-r, space); }

double magnitude(const Rational& r) { return std::fabs(nearest_double(r)); }

}  // namespace

PlaneWindow::PlaneWindow(const PlaneComplex& complex, double margin) {
  ExactBox box;
  include_vertices(complex, box);
  include_lines(complex, box);
  surround(box.left, box.bottom, box.right, box.top, margin);
}

/// If the box has no extent, extends it to size 1, or to a size that is visible beside its
/// coordinates.
void PlaneWindow::surround(const Rational& left, const Rational& bottom, const Rational& right,
                           const Rational& top, double margin) {
  Rational width = right - left, height = top - bottom;
  Rational size = std::max(width, height);
  const bool is_point = size == 0;
  if (is_point) {
    for (const Rational* r : {&left, &bottom}) size = std::max<Rational>(size, abs(*r) / 1048576);
    size = std::max<Rational>(size, 1);
  }
  const Rational space = is_point ? size : Rational(size * Rational(margin));
  width = std::max<Rational>(width + 2 * space, (height + 2 * space) / Rational(kMostAspect));
  height = std::max<Rational>(height + 2 * space, width * Rational(kLeastAspect));
  const Rational x = (left + right) / 2, y = (bottom + top) / 2;
  const Rational slack = size / 1024;
  left_ = short_below(x - width / 2, slack);
  right_ = short_above(x + width / 2, slack);
  bottom_ = short_below(y - height / 2, slack);
  top_ = short_above(y + height / 2, slack);
  centre_x_ = (left_ + right_) / 2;
  centre_y_ = (bottom_ + top_) / 2;
  half_ = (right_ - left_) / 2;
  half_height_ = nearest_double((top_ - bottom_) / (right_ - left_));
  plain_x_ = nearest_double(centre_x_);
  plain_y_ = nearest_double(centre_y_);
  plain_half_ = nearest_double(half_);
  const double far = std::max(magnitude(centre_x_), magnitude(centre_y_));
  is_plain_ =
      far < 1e300 && plain_half_ < 1e300 && plain_half_ > 1e-300 && plain_half_ > far * kComfort;
}

PointTable2 PlaneWindow::corners() const {
  PointTable2 corners;
  corners.push_back(left_, bottom_);
  corners.push_back(right_, bottom_);
  corners.push_back(right_, top_);
  corners.push_back(left_, top_);
  return corners;
}

Point2 PlaneWindow::at(const PlanePoints& points, std::uint32_t i) const {
  if (is_plain_ && is_plain_input(points, i)) {
    const Point2 p = points.inputs.approx(i);
    return {(p.x - plain_x_) / plain_half_, (p.y - plain_y_) / plain_half_};
  }
  const RationalPoint2 p = exact(points, i);
  return {nearest_double((p.x - centre_x_) / half_), nearest_double((p.y - centre_y_) / half_)};
}

unsigned PlaneWindow::borders(const PlanePoints& points, std::uint32_t i) const {
  const Point2 near = at(points, i);
  if (std::fabs(near.x) < 1 - kNearBorder && std::fabs(near.y) < half_height_ - kNearBorder) {
    return 0;
  }
  const RationalPoint2 p = exact(points, i);
  return (p.x == left_ ? 1U : 0U) | (p.x == right_ ? 2U : 0U) | (p.y == bottom_ ? 4U : 0U) |
         (p.y == top_ ? 8U : 0U);
}

std::vector<PlaneWindow::Tick> PlaneWindow::ticks(bool is_vertical) const {
  std::vector<Tick> ticks;
  const double centre = is_vertical ? plain_y_ : plain_x_;
  const double half = plain_half_ * (is_vertical ? half_height_ : 1);
  if (!is_plain_ || half < 1e-6 * std::fabs(centre) || half < 1e-9 || half > 1e12) return ticks;
  const double rough = 2 * half / kTicks;
  double step = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {2.0, 2.5, 2.0}) {  // The steps are 1, 2, 5, 10.
    if (step < rough) step *= factor;
  }
  for (double k = std::ceil((centre - half) / step); k * step < centre + half; ++k) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", k * step + 0.0);  // Negative zero becomes zero.
    ticks.push_back({(k * step - centre) / plain_half_, text});
  }
  return ticks;
}

Nef2 cut_at(const Nef2& set, const PlaneWindow& window, Context& context) {
  constexpr std::uint32_t kCorners[] = {0, 1, 2, 3};
  constexpr std::uint32_t kChain[] = {0, 4};
  const Nef2 box = Nef2::polygons(window.corners(), kCorners, kChain, WindingRule::NonZero,
                                  Boundary::Open, context);
  return boolean_op(set, box, kIntersection, context);
}

}  // namespace plumb
