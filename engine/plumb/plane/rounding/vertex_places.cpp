// Nearest doubles, local grids and hot pixels.
//
// Hot pixels: an edge is routed through the centres of all hot pixels that it meets, as in J. D.
// Hobby, Practical segment intersection with finite precision output, Computational Geometry 13
// (1999). Hot pixels are sorted by columns. For each column between the ends of an edge, the part
// of the edge above the column is computed in doubles with a margin; the pixels within the margin
// are tested with exact numbers. A margin that is too small could only leave out a pixel, and then
// the next arrangement finds the crossing.
//
// Tested by tests/plane/plane_rounding_test.cpp; docs/design/rounding.md has the proofs.

#include "plumb/plane/rounding/vertex_places.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/segment2.h"

namespace plumb {
namespace {

constexpr std::size_t kVerticesPerCheckpoint = 1024;

void watch(std::size_t done, std::size_t total, Context& context) {
  if (done % kVerticesPerCheckpoint == 0) context.checkpoint("round", done, total);
}

double nearest_finite(const Rational& value) {
  const double nearest = nearest_double(value);
  if (std::isfinite(nearest)) return nearest;
  throw Error(ErrorCode::NumberOutOfRange,
              "a coordinate lies beyond the largest double; .nef2 can hold it");
}

Point2 nearest_point(const RationalPoint2& p) { return {nearest_finite(p.x), nearest_finite(p.y)}; }

double up(const Rational& value) { return round_to_double(value, Rounding::Up).value; }

double distance_up(const RationalPoint2& p, Point2 q) {
  return std::max(up(abs(p.x - exact_rational(q.x))), up(abs(p.y - exact_rational(q.y))));
}

Rational floor_of(const Rational& value) {
  const Integer n = numerator(value), d = denominator(value);
  Integer quotient = n / d;
  if (n % d < 0) quotient = quotient - 1;
  return Rational(std::move(quotient));
}

/// Returns the nearest multiple of a step. If two are equally near, returns the greater one.
Rational nearest_multiple(const Rational& value, const Rational& step) {
  return floor_of(value / step + Rational(1) / 2) * step;
}

/// Returns the nearest point of the grid of `level`, or the nearest doubles if the point lies too
/// far from the origin.
Point2 coarse_place(const RationalPoint2& p, int level) {
  const Point2 nearest = nearest_point(p);
  const double step = local_step(nearest, level);
  if (!std::isfinite(step) || step == 0) return nearest;
  const Rational exact_step = exact_rational(step);
  const double x = nearest_double(nearest_multiple(p.x, exact_step));
  const double y = nearest_double(nearest_multiple(p.y, exact_step));
  return std::isfinite(x) && std::isfinite(y) ? Point2{x, y} : nearest;
}

/// The part of the parameters from 0 to 1 for which a <= start + t * change < b.
struct Slab {
  Rational low = 0, high = 1;
  bool low_is_in = true, high_is_in = true;

  void raise(const Rational& to, bool is_in) {
    if (to > low || (to == low && !is_in)) low_is_in = is_in;
    if (to > low) low = to;
  }
  void lower(const Rational& to, bool is_in) {
    if (to < high || (to == high && !is_in)) high_is_in = is_in;
    if (to < high) high = to;
  }
  bool is_empty() const { return low > high || (low == high && !(low_is_in && high_is_in)); }
  void close() { low = 1, high = 0; }

  void clip(const Rational& start, const Rational& change, const Rational& a, const Rational& b) {
    if (change.is_zero()) {
      if (start < a || start >= b) close();
    } else if (change.sign() > 0) {
      raise((a - start) / change, true);
      lower((b - start) / change, false);
    } else {
      raise((b - start) / change, false);
      lower((a - start) / change, true);
    }
  }
};

}  // namespace

// The number is made from bits, because with flush-to-zero a computed difference of doubles may be
// lost.
double ulp_of(double value) {
  constexpr int kNormal = 52;  // The least exponent of a unit that is not subnormal, plus 1074.
  const int shift = detail::raw(value).biased - 1;  // The unit is 2^(shift - 1074).
  const auto bits = shift < kNormal ? std::uint64_t{1} << static_cast<unsigned>(shift)
                                    : static_cast<std::uint64_t>(shift - kNormal + 1) << 52U;
  return std::bit_cast<double>(bits);
}

double local_step(Point2 p, int level) {
  return std::ldexp(ulp_of(std::max(std::fabs(p.x), std::fabs(p.y))), level - 1);
}

bool meets_square(Point2 from, Point2 to, Point2 centre, double half) {
  const Rational h = exact_rational(half);
  Rational low = 0, high = 1;
  const auto clip = [&](double start, double end, double middle) {
    const Rational at = exact_rational(start), change = exact_rational(end) - at;
    const Rational a = exact_rational(middle) - h - at, b = a + 2 * h;
    if (change.is_zero()) return a.sign() <= 0 && b.sign() >= 0;
    low = std::max(low, (change.sign() > 0 ? a : b) / change);
    high = std::min(high, (change.sign() > 0 ? b : a) / change);
    return low <= high;
  };
  return clip(from.x, to.x, centre.x) && clip(from.y, to.y, centre.y);
}

double largest_coordinate(std::span<const Point2> points) {
  double largest = 0;
  for (const Point2& p : points) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
  return largest;
}

std::vector<VertexPlace> nearest_places(const PlaneComplex& complex, Context& context) {
  const PlanePointsView points(complex.points);
  std::vector<VertexPlace> places;
  places.reserve(complex.vertex_count());
  for (const std::uint32_t p : complex.vertex_point) {
    watch(places.size(), complex.vertex_count(), context);
    if (points.is_input(p) && points.inputs().is_double(p)) {
      places.push_back({points.inputs().approx(p)});
      continue;
    }
    const Point2 at = nearest_point(exact(points, p));
    // Half a unit in the last place, rounded up if no double is half as large.
    const double unit = ulp_of(std::max(std::fabs(at.x), std::fabs(at.y)));
    places.push_back({at, std::max(unit / 2, std::numeric_limits<double>::denorm_min()), true});
  }
  return places;
}

std::vector<VertexPlace> places_of_crossings(const PlaneComplex& complex, int level,
                                             Context& context) {
  const PlanePointsView points(complex.points);
  std::vector<VertexPlace> places;
  places.reserve(complex.vertex_count());
  for (const std::uint32_t p : complex.vertex_point) {
    watch(places.size(), complex.vertex_count(), context);
    if (points.is_input(p)) {
      places.push_back({points.inputs().approx(p)});
      continue;
    }
    const RationalPoint2 at = exact(points, p);
    const Point2 place = level == 0 ? nearest_point(at) : coarse_place(at, level);
    places.push_back({place, distance_up(at, place), true});
  }
  return places;
}

// ---------------------------------------------------------------- hot pixels

HotPixels::HotPixels(const PlaneComplex& complex, const Rational& step, Context& context)
    : step_(step), half_(step / 2), step_above_(up(step)) {
  const PlanePointsView points(complex.points);
  vertices_.reserve(complex.vertex_count());
  for (const std::uint32_t p : complex.vertex_point) vertices_.push_back(exact(points, p));
  centres_.reserve(vertices_.size());
  places_.reserve(vertices_.size());
  double unit = 0;
  for (const RationalPoint2& p : vertices_) {
    watch(centres_.size(), vertices_.size(), context);
    centres_.push_back(centre_of(p));
    places_.push_back(place_of_centre(centres_.back()));
    const Point2 at = places_.back();
    if (exact_rational(at.x) == centres_.back().x && exact_rational(at.y) == centres_.back().y) {
      continue;
    }
    unit = std::max(unit, ulp_of(std::max(std::fabs(at.x), std::fabs(at.y))));
  }
  move_ = up(half_ + exact_rational(unit) / 2);
  group_by_place();
}

RationalPoint2 HotPixels::centre_of(const RationalPoint2& p) const {
  return {nearest_multiple(p.x, step_), nearest_multiple(p.y, step_)};
}

Point2 HotPixels::place_of_centre(const RationalPoint2& centre) { return nearest_point(centre); }

/// Sorts the pixels of the vertices by place, and replaces pixels with the same place by one.
void HotPixels::group_by_place() {
  std::vector<std::uint32_t> order(vertices_.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [this](std::uint32_t i, std::uint32_t j) {
    return compare_xy(places_[i], places_[j]) == Sign::Negative;
  });
  pixel_of_.resize(order.size());
  std::vector<RationalPoint2> centres;
  std::vector<Point2> places;
  for (const std::uint32_t v : order) {
    if (places.empty() || compare_xy(places.back(), places_[v]) != Sign::Zero) {
      if (places.empty() || !is_equal(places.back().x, places_[v].x)) {
        column_begin_.push_back(static_cast<std::uint32_t>(places.size()));
      }
      places.push_back(places_[v]);
      centres.push_back(std::move(centres_[v]));
    }
    pixel_of_[VertexId(v)] = static_cast<std::uint32_t>(places.size() - 1);
  }
  column_begin_.push_back(static_cast<std::uint32_t>(places.size()));
  places_ = std::move(places);
  centres_ = std::move(centres);
}

void HotPixels::route(VertexId v, VertexId w, std::vector<std::uint32_t>& pixels) const {
  const std::uint32_t first = pixel_of_[v], last = pixel_of_[w];
  pixels.push_back(first);
  if (first == last) return;
  std::vector<Passage> passages;
  const auto column_of = [this](std::uint32_t pixel) {
    return static_cast<std::size_t>(
        std::upper_bound(column_begin_.begin(), column_begin_.end(), pixel) -
        column_begin_.begin() - 1);
  };
  const std::size_t from = column_of(std::min(first, last)), to = column_of(std::max(first, last));
  for (std::size_t column = from; column <= to; ++column) visit_column(column, v, w, passages);
  std::sort(passages.begin(), passages.end(), [](const Passage& p, const Passage& q) {
    return p.enters != q.enters ? p.enters < q.enters : p.leaves < q.leaves;
  });
  for (const Passage& passage : passages) pixels.push_back(passage.pixel);
  pixels.push_back(last);
}

/// Tests the pixels of a column that lie near the edge from v to w.
void HotPixels::visit_column(std::size_t column, VertexId v, VertexId w,
                             std::vector<Passage>& passages) const {
  const std::uint32_t first = pixel_of_[v], last = pixel_of_[w];
  const Point2 a = places_[first], b = places_[last];
  const auto begin = places_.begin() + column_begin_[column];
  const auto end = places_.begin() + column_begin_[column + 1];
  double low = std::min(a.y, b.y), high = std::max(a.y, b.y);
  // Computes the ordinates of the edge in the column. The error of the parameter of an abscissa
  // is at most `slack`. If this bound is useless, all ordinates of the edge count.
  const double scale = std::max({std::fabs(a.x), std::fabs(b.x), std::fabs(begin->x)});
  const double width = b.x - a.x, height = b.y - a.y;
  const double slack = (8 * 0x1p-52 * scale + 2 * step_above_) / std::fabs(width);
  if (std::isfinite(width) && std::isfinite(height) && slack < 1) {
    const double t = (begin->x - a.x) / width;
    const double middle = a.y + t * height, margin = slack * std::fabs(height);
    low = std::max(low, middle - margin);
    high = std::min(high, middle + margin);
  }
  const double margin = 2 * step_above_ + 8 * 0x1p-52 * std::max(std::fabs(a.y), std::fabs(b.y));
  const auto is_below = [](const Point2& p, double y) { return p.y < y; };
  for (auto p = std::lower_bound(begin, end, low - margin, is_below);
       p != end && p->y <= high + margin; ++p) {
    const auto pixel = static_cast<std::uint32_t>(p - places_.begin());
    Passage passage;
    if (pixel != first && pixel != last && passes(v, w, pixel, passage)) {
      passages.push_back(std::move(passage));
    }
  }
}

bool HotPixels::passes(VertexId v, VertexId w, std::uint32_t pixel, Passage& passage) const {
  const RationalPoint2& from = vertices_[v.value()];
  const RationalPoint2& to = vertices_[w.value()];
  const RationalPoint2& centre = centres_[pixel];
  Slab slab;
  slab.clip(from.x, to.x - from.x, centre.x - half_, centre.x + half_);
  if (slab.is_empty()) return false;
  slab.clip(from.y, to.y - from.y, centre.y - half_, centre.y + half_);
  if (slab.is_empty()) return false;
  passage = {std::move(slab.low), std::move(slab.high), pixel};
  return true;
}

}  // namespace plumb
