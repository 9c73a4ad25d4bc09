#include "generate/plane_families.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/segment2.h"

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

/// Whether the edges of a ring meet at common corners only.
bool is_simple_at(const std::vector<RationalPoint2>& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const RationalSegment2 a{ring[j], ring[j + 1]};
      const RationalSegment2 b{ring[i], ring[(i + 1) % n]};
      const bool are_neighbours = j + 1 == i || (j == 0 && i + 1 == n);
      const SegmentRelation expected =
          are_neighbours ? SegmentRelation::ShareEndpoint : SegmentRelation::Disjoint;
      if (relation(a, b) != expected) return false;
    }
  }
  return true;
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

PlanePolygon lattice_polygon(Dice& dice, std::size_t corners, std::uint32_t size) {
  const auto point = [&] {
    const double x = dice.below(size);
    const double y = dice.below(size);
    return RationalPoint2{x, y};
  };
  std::vector<RationalPoint2> ring{{0, 0}, {size, 0}, {0, size}};
  for (int tries = 0; ring.size() < corners && tries < 400; ++tries) {
    std::vector<RationalPoint2> longer = ring;
    const std::size_t at = 1 + dice.below(ring.size());
    const RationalPoint2 p = point();
    if (std::ranges::find(ring, p) != ring.end()) continue;
    longer.insert(longer.begin() + static_cast<std::ptrdiff_t>(at), p);
    if (is_simple_at(longer)) ring = std::move(longer);
  }
  PlanePolygon points;
  for (const RationalPoint2& p : ring) {
    points.push_back({p.x.convert_to<double>(), p.y.convert_to<double>()});
  }
  return points;
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
