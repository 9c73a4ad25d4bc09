// Simplified sets: topology, distance by brute force, and what must stay.
#include "plumb/plane/plane_simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "generate/plane_families.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/plane/plane_points.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Stroke {
  Point2 from;
  Point2 to;
};

std::vector<Stroke> edges_of(const Nef2& set) {
  const PlaneComplex& complex = set.complex();
  const auto at = [&](VertexId v) { return approx(complex.points, complex.vertex_point[v]); };
  std::vector<Stroke> edges;
  for (std::size_t e = 0; e < complex.edge_count(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    edges.push_back({at(complex.dcel.origin(h)), at(complex.dcel.target(h))});
  }
  return edges;
}

Nef2 point_at(Point2 p) {
  return Nef2::point(RationalPoint2{exact_rational(p.x), exact_rational(p.y)});
}

double distance(Point2 p, const Stroke& s) {
  const double x = s.to.x - s.from.x, y = s.to.y - s.from.y;
  const double t = ((p.x - s.from.x) * x + (p.y - s.from.y) * y) / (x * x + y * y);
  const double on = std::clamp(t, 0.0, 1.0);
  return std::hypot(p.x - s.from.x - on * x, p.y - s.from.y - on * y);
}

/// The greatest distance of points of the edges of a set from the edges of another one, at eleven
/// points of each edge.
double farthest(const Nef2& set, const Nef2& other) {
  const std::vector<Stroke> to = edges_of(other);
  double farthest = 0;
  for (const Stroke& s : edges_of(set)) {
    for (int i = 0; i <= 10; ++i) {
      const double t = i / 10.0;
      const Point2 p{s.from.x + t * (s.to.x - s.from.x), s.from.y + t * (s.to.y - s.from.y)};
      double nearest = kInfinity;
      for (const Stroke& other_stroke : to) nearest = std::min(nearest, distance(p, other_stroke));
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}

/// A star with holes, islands, lines and points in and around it.
Nef2 random_scene(std::uint64_t seed) {
  Dice dice(seed);
  const auto moved = [&](Nef2 set, double scale, double dx, double dy) {
    AffineMap2 map;
    map.xx = map.yy = Rational(static_cast<long>(scale * 64)) / 64;
    map.x0 = Rational(static_cast<long>(dx * 64)) / 64;
    map.y0 = Rational(static_cast<long>(dy * 64)) / 64;
    return set.transformed(map);
  };
  const auto star = [&](std::size_t corners) {
    return Nef2::polygon(star_polygon(corners, dice.below(1000)));
  };
  Nef2 set = star(40 + dice.below(40));
  for (int i = 0; i < 3; ++i) {
    const double x = (dice.below(200) - 100.0) / 80, y = (dice.below(200) - 100.0) / 80;
    set = set ^ moved(star(12 + dice.below(20)), 0.3, x, y);
  }
  for (int i = 0; i < 2; ++i) {
    std::vector<Point2> line;
    for (int k = 0; k < 12; ++k) {
      line.push_back({k / 4.0 - 1.5, (dice.below(100) - 50.0) / 100 + i});
    }
    set = set + Nef2::polyline(line);
  }
  for (int i = 0; i < 6; ++i) {
    set = set + point_at({(dice.below(200) - 100.0) / 50, (dice.below(200) - 100.0) / 50});
  }
  return set.closure();
}

TEST(PlaneSimplify, keeps_topology_and_distance) {
  std::size_t removed = 0, blocked = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const Nef2 before = round_to_doubles(random_scene(seed)).set;
    for (const double within : {0.0, 0.01, 0.1, kInfinity}) {
      const SimplifiedSet after = simplify_borders(before, {kInfinity, 0, within});
      EXPECT_TRUE(after.set.is_closed());
      EXPECT_FALSE(round_to_doubles(after.set).report.is_changed());
      const PlaneCounts a = before.counts(), b = after.set.counts();
      EXPECT_EQ(a.faces, b.faces);
      // Euler: as faces and components stay, so does the difference of vertices and edges.
      EXPECT_EQ(a.vertices - a.edges, b.vertices - b.edges);
      EXPECT_EQ(b.vertices, after.corners_after);
      EXPECT_LE(after.borders_moved, within);
      EXPECT_LE(farthest(after.set, before), after.borders_moved + 1e-12);
      EXPECT_LE(farthest(before, after.set), after.borders_moved + 1e-12);
      const SimplifiedSet again = simplify_borders(after.set, {kInfinity, 0, 0});
      EXPECT_TRUE(again.set == after.set);
      if (within == 0) {
        EXPECT_TRUE(after.set == before);
      }
      removed += after.corners_before - after.corners_after;
      blocked += after.blocked;
    }
  }
  EXPECT_GT(removed, 1000U);
  EXPECT_GT(blocked, 100U);
}

TEST(PlaneSimplify, keeps_a_point_beside_a_line_and_the_ends_of_lines) {
  const std::vector<Point2> bent{{0, 0}, {2, 3}, {4, 0}, {6, 3}, {8, 0}};
  const Nef2 set = Nef2::polyline(bent) + point_at({2, 1});
  const SimplifiedSet after = simplify_borders(set, {kInfinity, 0});
  const std::vector<Point2> expected{{0, 0}, {2, 3}, {8, 0}};
  EXPECT_TRUE(after.set == (Nef2::polyline(expected) + point_at({2, 1})));
  EXPECT_EQ(after.blocked, 1U);
}

TEST(PlaneSimplify, stops_at_each_of_its_bounds) {
  // A square with dents of depth 1/2 and area 1/4.
  const std::vector<Point2> dented{{0, 0}, {1.5, 0}, {2, 0.5}, {2.5, 0}, {4, 0}, {4, 4}, {0, 4}};
  const Nef2 set = Nef2::polygon(dented);
  const Nef2 square = Nef2::polygon(std::vector<Point2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  EXPECT_TRUE(simplify_borders(set, {0.25, 0}).set == square);
  EXPECT_TRUE(simplify_borders(set, {0.2, 0}).set == set);
  EXPECT_TRUE(simplify_borders(set, {0.25, 0, 0.51}).set == square);
  EXPECT_TRUE(simplify_borders(set, {0.25, 0, 0.49}).set == set);
  EXPECT_TRUE(simplify_borders(set, {0.25, 1}).set == set);
}

TEST(PlaneSimplify, takes_sets_without_edges) {
  EXPECT_TRUE(simplify_borders(Nef2::empty(), {kInfinity, 0}).set.is_empty());
  const Nef2 point = point_at({1, 2});
  EXPECT_TRUE(simplify_borders(point, {kInfinity, 0}).set == point);
}

TEST(PlaneSimplify, refuses_what_it_cannot_do) {
  const auto code_of = [](const Nef2& set, const LayerSimplifyOptions& options) {
    try {
      static_cast<void>(simplify_borders(set, options));
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::Syntax;
  };
  const Nef2 square = Nef2::polygon(std::vector<Point2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_EQ(code_of(Nef2::whole(), {1, 0}), ErrorCode::BadArgument);
  EXPECT_EQ(code_of(square, {-1, 0}), ErrorCode::BadArgument);
  EXPECT_EQ(code_of(square, {1, 0, -1}), ErrorCode::BadArgument);
  EXPECT_EQ(code_of(square, {1, 0, std::nan("")}), ErrorCode::BadArgument);
}

}  // namespace
}  // namespace plumb::testing
