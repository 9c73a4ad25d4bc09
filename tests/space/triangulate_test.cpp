// Triangles of regions: they cover each point of the region once, and leave no vertex on a side.
#include "plumb/space/planar/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/segment2.h"
#include "plumb/space/complex/space_tables.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::triangulate_test {
namespace {

struct Region {
  std::vector<Point2> points;
  std::vector<IndexEdge> edges;  ///< the region is to their left
};

/// The region laid into a plane of space and looked at from above.
class Laid {
 public:
  explicit Laid(const Region& region, bool is_constructed = false) : flat(tables.points) {
    flat.reset({2, false});
    for (const Point2& p : region.points) {
      const Point3 at{p.x, p.y, p.x + 2 * p.y};
      if (is_constructed) {
        const Rational third = Rational(1) / 3;
        flat.push_back(add_point(tables, {at.x + third, at.y + third, at.z}));
      } else {
        flat.push_back(SpacePoint(tables.planes.add_point(at)));
      }
    }
  }

  SpaceTables tables;
  FlatPoints flat;
};

Region polygon(const std::vector<Point2>& points) {
  Region region{points, {}};
  const auto n = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t i = 0; i < n; ++i) region.edges.push_back({i, (i + 1) % n});
  return region;
}

/// All triangles turn left and their sides cancel to the given edges: by Stokes they cover the
/// region once.
void expect_cover(const Region& region, const FlatPoints& flat,
                  const std::vector<IndexTriangle>& triangles) {
  std::map<IndexEdge, int> sides;
  const auto add = [&](std::uint32_t a, std::uint32_t b, int times) {
    sides[{std::min(a, b), std::max(a, b)}] += a < b ? times : -times;
  };
  for (const IndexTriangle& t : triangles) {
    ASSERT_EQ(flat.orient(t[0], t[1], t[2]), Sign::Positive);
    for (std::size_t i = 0; i < 3; ++i) add(t[i], t[(i + 1) % 3], 1);
  }
  for (const IndexEdge& e : region.edges) add(e[0], e[1], -1);
  for (const auto& [side, sum] : sides) EXPECT_EQ(sum, 0) << side[0] << " " << side[1];
}

std::vector<IndexTriangle> cut(const Region& region, bool is_constructed = false) {
  const Laid laid(region, is_constructed);
  std::vector<IndexTriangle> triangles;
  EXPECT_TRUE(triangulate(laid.flat, region.edges, triangles));
  expect_cover(region, laid.flat, triangles);
  std::vector<IndexTriangle> delaunay = triangles;
  make_delaunay(laid.flat, region.edges, delaunay);
  expect_cover(region, laid.flat, delaunay);
  return triangles;
}

/// Cells of a grid: holes, islands, corners that touch. Points with no edges are in the region or
/// outside.
Region random_cells(Dice& dice, int size) {
  Region region;
  // Empty ones around it.
  const std::size_t side = static_cast<std::size_t>(size) + 3;
  std::vector<std::vector<bool>> cell(side, std::vector<bool>(side));
  const std::int64_t share = dice.between(2, 9);
  for (std::size_t x = 1; x + 2 < side; ++x) {
    for (std::size_t y = 1; y + 2 < side; ++y) cell[x][y] = dice.between(0, 9) < share;
  }
  const auto n = static_cast<std::uint32_t>(side);
  const auto corner = [n](std::uint32_t x, std::uint32_t y) { return x * n + y; };
  for (std::uint32_t x = 0; x < n; ++x) {
    for (std::uint32_t y = 0; y < n; ++y) {
      region.points.push_back({static_cast<double>(x), static_cast<double>(y)});
      if (x + 1 == n || y + 1 == n) continue;
      const bool here = cell[x][y];
      if (y > 0 && here != cell[x][y - 1]) {
        region.edges.push_back({corner(x, y), corner(x + 1, y)});
        if (!here) std::swap(region.edges.back()[0], region.edges.back()[1]);
      }
      if (x > 0 && here != cell[x - 1][y]) {
        region.edges.push_back({corner(x, y + 1), corner(x, y)});
        if (!here) std::swap(region.edges.back()[0], region.edges.back()[1]);
      }
    }
  }
  return region;
}

// Every point of the grid is a corner where the region is, so all triangles are as small as they
// can be (Pick).
TEST(Triangulate, CellsOfAGrid) {
  Dice dice(1);
  for (int round = 0; round < 150; ++round) {
    const Region region = random_cells(dice, 1 + round % 9);
    for (const IndexTriangle& t : cut(region, round % 5 == 0)) {
      const Point2 &a = region.points[t[0]], &b = region.points[t[1]], &c = region.points[t[2]];
      EXPECT_EQ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x), 1);
    }
  }
}

// Slits inside, from the border, forked, upright; sides of triangles lie along both of their
// halves.
TEST(Triangulate, Slits) {
  Region region = polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}});
  region.points.insert(region.points.end(),
                       {{2, 1}, {2, 5}, {4, 5}, {1, 7}, {6, 2}, {8, 3}, {7, 6}});
  for (const IndexEdge& e : {IndexEdge{0, 4}, {4, 5}, {5, 6}, {5, 7}, {8, 9}}) {
    region.edges.push_back(e);
    region.edges.push_back({e[1], e[0]});
  }
  const auto triangles = cut(region);
  for (const IndexEdge& e : region.edges) {
    const auto has_side = [&e](const IndexTriangle& t) {
      return (t[0] == e[0] && t[1] == e[1]) || (t[1] == e[0] && t[2] == e[1]) ||
             (t[2] == e[0] && t[0] == e[1]);
    };
    EXPECT_EQ(std::ranges::count_if(triangles, has_side), 1);
  }
}

// Sheared and turned, so that no edge is along an axis and rounding makes points nearly collinear.
TEST(Triangulate, TurnedCells) {
  Dice dice(2);
  for (int round = 0; round < 40; ++round) {
    Region region = random_cells(dice, 1 + round % 9);
    for (Point2& p : region.points) p = {p.x * 17 - p.y * 5, p.x * 3 + p.y * 13};
    cut(region);
  }
}

TEST(Triangulate, StarsAndCombs) {
  Dice dice(3);
  for (int round = 0; round < 60; ++round) {
    std::vector<Point2> star;
    const int n = 3 + round;
    for (int i = 0; i < n; ++i) {
      const double angle = 6.283185307179586 * i / n;
      const double radius = static_cast<double>(dice.between(2000, 10000));
      star.push_back({std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))});
    }
    const auto triangles = cut(polygon(star));
    EXPECT_EQ(triangles.size(), star.size() - 2);
  }
  std::vector<Point2> comb = {{0, -1}};
  constexpr int kTeeth = 20000;
  for (int i = 0; i < kTeeth; ++i) {
    comb.push_back({i + 1.0, -1.0});
  }
  for (int i = kTeeth; i-- > 0;) {
    comb.push_back({i + 0.75, 0});
    comb.push_back({i + 0.5, 1000.0 + i % 7});
  }
  EXPECT_EQ(cut(polygon(comb)).size(), comb.size() - 2);
}

TEST(Triangulate, WhatIsNoRegion) {
  Region twice = polygon({{0, 0}, {3, 0}, {0, 3}});
  twice.points.insert(twice.points.end(), {{1, 1}, {1.5, 1}, {1, 1.5}});
  for (const IndexEdge& e : {IndexEdge{3, 4}, {4, 5}, {5, 3}}) twice.edges.push_back(e);
  Region clockwise = polygon({{0, 0}, {0, 3}, {3, 0}});
  for (const Region& region : {twice, clockwise}) {
    const Laid laid(region);
    std::vector<IndexTriangle> triangles(1);
    EXPECT_FALSE(triangulate(laid.flat, region.edges, triangles));
    EXPECT_EQ(triangles.size(), 1U);
  }
}

// Points in convex position have no constraint but their hull: circles must be empty.
TEST(Triangulate, CirclesAreEmpty) {
  Dice dice(4);
  for (int round = 0; round < 30; ++round) {
    std::vector<Point2> parabola;
    std::int64_t x = 0;
    for (int i = 0; i < 4 + round; ++i) {
      x += dice.between(1, 9);
      parabola.push_back({static_cast<double>(x), static_cast<double>(x * x)});
    }
    const Region region = polygon(parabola);
    const Laid laid(region);
    std::vector<IndexTriangle> triangles;
    ASSERT_TRUE(triangulate(laid.flat, region.edges, triangles));
    make_delaunay(laid.flat, region.edges, triangles);
    for (const IndexTriangle& t : triangles) {
      for (std::uint32_t i = 0; i < laid.flat.size(); ++i) {
        EXPECT_NE(laid.flat.incircle(t[0], t[1], t[2], i), Sign::Positive);
      }
    }
  }
}

// Of points on a circle the lowest index is joined to all others, wherever it is.
TEST(Triangulate, TiesGoToTheLowestIndex) {
  const std::vector<Point2> circle = {{5, 0},  {4, 3},  {3, 4},   {0, 5},
                                      {-3, 4}, {-5, 0}, {-3, -4}, {3, -4}};
  for (std::size_t first = 0; first < circle.size(); ++first) {
    std::vector<Point2> turned = circle;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first), turned.end());
    const Region region = polygon(turned);
    const Laid laid(region);
    std::vector<IndexTriangle> triangles;
    ASSERT_TRUE(triangulate(laid.flat, region.edges, triangles));
    make_delaunay(laid.flat, region.edges, triangles);
    for (const IndexTriangle& t : triangles) EXPECT_EQ(std::ranges::min(t), 0U);
  }
}

/// Input points and points of three planes, of small numbers and nearly parallel planes, against
/// rationals: with their boxes and with the nearest doubles.
TEST(FlatPoints, TurnAndComeAsRationalsSay) {
  Dice dice(5);
  std::array<int, 3> seen{};
  for (int round = 0; round < 20; ++round) {
    SpaceTables tables;
    const auto small = [&] { return Rational(static_cast<int>(dice.below(7)) - 3); };
    const PlaneId base = tables.planes.intern(1.0, 2.0, -1.0, 0.0).plane();  // z = x + 2 y
    std::vector<SpacePoint> at;
    std::vector<PlaneId> cuts;
    for (int i = 0; i < 6; ++i) {
      const double x = static_cast<double>(dice.below(4)), y = static_cast<double>(dice.below(4));
      at.emplace_back(tables.planes.add_point({x, y, x + 2 * y}));
      const Rational tilt = i % 3 == 0 ? Rational(1) / (Integer(1) << 50U) : small();
      const Rational a = small() + tilt, b = small(), c = small();
      if (a == 0 && b == 0 && c == 0) continue;
      cuts.push_back(tables.planes.intern(a, b, c, small()).plane());
    }
    for (std::size_t i = 0; i < cuts.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const SpacePoint p = tables.points.add(base, cuts[i], cuts[j]);
        if (p.is_valid()) at.push_back(p);
      }
    }
    const FlatView view = FlatView::of_plane(tables.planes, base);
    FlatPoints flat(tables.points), near(tables.points);
    flat.reset(view);
    near.reset(view);
    std::vector<RationalPoint2> exactly;
    for (const SpacePoint p : at) {
      flat.push_back(p);
      near.push_back(p, rounded(tables.points, p));
      const RationalPoint3 e = exact(tables.points, p);
      const std::array<Rational, 3> c{e.x, e.y, e.z};
      exactly.push_back({c[view.coordinate(0)], c[view.coordinate(1)]});
    }
    for (std::uint32_t i = 0; i < flat.size(); ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        const Sign order = compare_xy(exactly[i], exactly[j]);
        ASSERT_EQ(flat.compare(i, j), order) << round << ": " << i << " " << j;
        ASSERT_EQ(near.compare(i, j), order) << round << ": " << i << " " << j;
        for (std::uint32_t k = 0; k < flat.size(); k += 1 + (i + j) % 3) {
          const Sign turn = orient2d(exactly[i], exactly[j], exactly[k]);
          ASSERT_EQ(flat.orient(i, j, k), turn) << round << ": " << i << " " << j << " " << k;
          ASSERT_EQ(near.orient(i, j, k), turn) << round << ": " << i << " " << j << " " << k;
          ++seen[static_cast<std::size_t>(static_cast<int>(turn) + 1)];
        }
      }
    }
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace plumb::testing::triangulate_test
