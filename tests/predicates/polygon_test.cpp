// The area of polygons beside a sum of triangles over rationals, where the filter decides and where
// it cannot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "plumb/predicates/plane/plane_points.h"

namespace plumb::polygon_test {
namespace {

std::vector<std::uint32_t> all_of(const PointTable2& points) {
  std::vector<std::uint32_t> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0U);
  return corners;
}

/// Twice the area: of the triangles that the first corner makes with each side.
Rational fan_area(const PointTable2& points, const std::vector<std::uint32_t>& corners) {
  const RationalPoint2 o = points.exact(corners[0]);
  Rational sum = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const RationalPoint2 p = points.exact(corners[i]), q = points.exact(corners[i + 1]);
    sum += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
  }
  return sum;
}

void expect_area(const PointTable2& points) {
  std::vector<std::uint32_t> corners = all_of(points);
  const Rational area = fan_area(points, corners);
  const Sign sign = sign_of(area.sign());
  EXPECT_EQ(twice_polygon_area(points, corners), area);
  EXPECT_EQ(polygon_area_sign(points, corners), sign);
  std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  EXPECT_EQ(polygon_area_sign(points, corners), sign);
  std::reverse(corners.begin(), corners.end());
  EXPECT_EQ(polygon_area_sign(points, corners), -sign);
  EXPECT_EQ(twice_polygon_area(points, corners), -area);
}

/// Corners of a box of that extent around a place, in any order: of most of them sides cross.
class Polygons {
 public:
  Polygons(std::uint64_t seed, double x, double y, double extent)
      : random_(seed), x_(x), y_(y), extent_(extent) {}

  Point2 corner() {
    std::uniform_real_distribution<double> along(-extent_, extent_);
    const double x = x_ + along(random_);
    return {x, y_ + along(random_)};
  }

 private:
  std::mt19937_64 random_;
  double x_, y_, extent_;
};

TEST(PolygonArea, IsThatOfTheRationalsNearAndFar) {
  for (const double place : {0.0, 1.0, 1e9, 1e15}) {
    for (const double extent : {1e-300, 0.25, 1.0, 1e6, 1e200, 1e300}) {
      for (std::uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE(std::to_string(place) + ", " + std::to_string(extent));
        Polygons polygons(seed, seed % 2 != 0 ? place : -place, seed % 3 != 0 ? place : 0, extent);
        PointTable2 points;
        for (std::uint64_t i = 0; i < 3 + seed; ++i) points.push_back(polygons.corner());
        expect_area(points);
      }
    }
  }
}

TEST(PolygonArea, OfFractionsIsExact) {
  PointTable2 points;
  for (const int k : {1, 2, 3, 5, 7}) points.push_back(Rational(k, 3), Rational(k * k, 7));
  expect_area(points);
  points.push_back(Point2{0.25, 9});
  expect_area(points);
}

// The area is one unit in the last place of a product, or nothing.
TEST(PolygonArea, ThatRoundsToNothingHasItsSign) {
  const double more = std::nextafter(3.0, 4.0);
  for (const double y : {more, 3.0, std::nextafter(3.0, 0.0)}) {
    PointTable2 points;
    for (const Point2 p : {Point2{0, 0}, {1, 1}, {3, y}}) points.push_back(p);
    const Sign sign = polygon_area_sign(points, all_of(points));
    EXPECT_EQ(sign, sign_of(Rational(y).compare(Rational(3))));
    expect_area(points);
  }
}

// Corners rounded from one line: products are rounded by more than is left of them.
TEST(PolygonArea, OfCornersNearALineHasItsSign) {
  Polygons polygons(5, 1, 1, 0.5);
  for (int round = 0; round < 500; ++round) {
    const Point2 a = polygons.corner(), b = polygons.corner();
    PointTable2 points;
    points.push_back(a);
    for (const double t : {0.3, 0.9, 2.0, 0.7}) {
      points.push_back(Point2{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
    expect_area(points);
  }
}

TEST(PolygonArea, OfAFewCornersOrASymmetricBowTieIsNothing) {
  PointTable2 points;
  for (const Point2 p : {Point2{0, 0}, {1, 1}, {1, 0}, {0, 1}}) points.push_back(p);
  EXPECT_EQ(polygon_area_sign(points, all_of(points)), Sign::Zero);
  EXPECT_EQ(twice_polygon_area(points, all_of(points)), 0);
  const std::vector<std::uint32_t> there_and_back{0, 1};
  EXPECT_EQ(polygon_area_sign(points, there_and_back), Sign::Zero);
  EXPECT_EQ(polygon_area_sign(points, {}), Sign::Zero);
}

}  // namespace
}  // namespace plumb::polygon_test
