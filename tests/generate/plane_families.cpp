#include "generate/plane_families.h"

#include <array>
#include <cmath>

#include "plumb/testing/dice.h"

namespace plumb::testing {
namespace {

/// In [0, 1), a multiple of 2^-52.
double unit(Dice& dice) {
  return static_cast<double>(dice.between(0, (std::int64_t{1} << 52) - 1)) * 0x1p-52;
}

/// A direction by a rational point of the unit circle: t in [-1, 1] covers half of it. Only sums,
/// products and quotients, which round alike everywhere.
Point2 direction(double t) {
  const double w = 1 + t * t;
  return {(1 - t * t) / w, 2 * t / w};
}

/// The direction after `turns` in [0, 4) quarter circles, evenly enough.
Point2 around(double turns) {
  const int quarter = static_cast<int>(turns);
  const Point2 d = direction(turns - quarter);
  switch (quarter) {
    case 0:
      return d;
    case 1:
      return {-d.y, d.x};
    case 2:
      return {-d.x, -d.y};
    default:
      return {d.y, -d.x};
  }
}

}  // namespace

// k = n^2 l^2 / pi for random directions: l^2 = 1.3 pi / n.
std::vector<PlaneSegment> short_segments(std::size_t n, std::uint64_t seed) {
  Dice dice(seed);
  const double length = std::sqrt(4.084 / static_cast<double>(n));
  std::vector<PlaneSegment> segments;
  segments.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 p{unit(dice), unit(dice)};
    const Point2 d = around(4 * unit(dice));
    segments.push_back({p, {p.x + length * d.x, p.y + length * d.y}});
  }
  return segments;
}

std::vector<PlaneSegment> long_segments(std::size_t n, std::uint64_t seed) {
  Dice dice(seed);
  std::vector<PlaneSegment> segments;
  segments.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 p{unit(dice), unit(dice)};
    segments.push_back({p, {unit(dice), unit(dice)}});
  }
  return segments;
}

PlanePolygon star_polygon(std::size_t n, std::uint64_t seed) {
  Dice dice(seed);
  PlanePolygon polygon;
  polygon.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double turns = 4 * (static_cast<double>(i) + 0.9 * unit(dice)) / static_cast<double>(n);
    const Point2 d = around(turns);
    const double r = 0.5 + 0.5 * unit(dice);
    polygon.push_back({r * d.x, r * d.y});
  }
  return polygon;
}

// The area of an 8-gon of radius r is about 2.6 r^2.
std::vector<PlanePolygon> octagons(std::size_t n, std::uint64_t seed) {
  Dice dice(seed);
  const double side = 0x1p29;
  const double radius = side * std::sqrt(1.5 / (2.6 * static_cast<double>(n)));
  std::vector<PlanePolygon> polygons;
  polygons.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point2 c{0x1p28 + side * unit(dice), 0x1p28 + side * unit(dice)};
    const double r = radius * (0.75 + 0.5 * unit(dice));
    PlanePolygon polygon;
    for (int k = 0; k < 8; ++k) {
      const Point2 d = around(0.5 * k + 0.3 * unit(dice));
      polygon.push_back({std::floor(c.x + r * d.x), std::floor(c.y + r * d.y)});
    }
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

}  // namespace plumb::testing
