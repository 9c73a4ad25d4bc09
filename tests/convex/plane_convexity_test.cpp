// Convexity of sets of the plane: known answers, and against hulls of their vertices.
#include "plumb/convex/plane_convexity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>
#include <vector>

#include "generate/plane_families.h"
#include "plumb/convex/plane_partition.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::plane_convexity_test {
namespace {

using Points = std::vector<Point2>;

Nef2 box(double x, double y, double to_x, double to_y, Boundary boundary = Boundary::Closed) {
  return Nef2::polygon(Points{{x, y}, {to_x, y}, {to_x, to_y}, {x, to_y}}, boundary);
}
Nef2 segment(Point2 a, Point2 b) { return Nef2::polyline(Points{a, b}); }
Nef2 point(Rational x, Rational y) { return Nef2::point({std::move(x), std::move(y)}); }
Nef2 line(Point2 a, Point2 b) { return Nef2::line({{a.x, a.y}, {b.x, b.y}}); }

PlaneConvexity convexity(const Nef2& set) {
  Context context;
  return convexity_of_set(set, context);
}

// ---------------------------------------------------------------- the oracle

/// Is a set that lies on a line an interval?
bool is_interval(const Nef2& set) {
  const Nef2 closed = set.closure();
  const PlaneComplex& c = closed.complex();
  if (c.edge_count() == 0) return c.vertex_count() <= 1;
  if (c.edge_count() > 1 || c.vertex_count() > 2) return false;
  const Nef2 inside = closed.with_marks(
      {std::vector<std::uint8_t>(c.vertex_count(), 0), c.marks.edge, c.marks.face});
  return inside.is_subset_of(set);
}

Rational cross(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Of points in lexicographic order, counter-clockwise, without points on sides.
std::vector<RationalPoint2> hull_of(const std::vector<RationalPoint2>& points) {
  std::vector<RationalPoint2> hull;
  for (const bool is_upper : {false, true}) {
    const std::size_t base = hull.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const RationalPoint2& p = points[is_upper ? points.size() - 1 - i : i];
      while (hull.size() >= base + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
  }
  return hull;
}

/// Of a bounded set: it fills the hull of its vertices, and meets each side of that in an interval.
bool is_convex_by_hull(const Nef2& set) {
  const PlaneComplex& c = set.complex();
  std::vector<RationalPoint2> points;
  for (const std::uint32_t i : c.vertex_point) points.push_back(exact(c.points, i));
  if (points.size() < 2) return true;
  const std::vector<RationalPoint2> hull = hull_of(points);
  if (hull.size() < 3) return is_interval(set);
  Nef2 inside = Nef2::whole();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Line2 along{hull[i], hull[(i + 1) % hull.size()]};
    inside *= Nef2::half_plane(along, Boundary::Open);
    if (!is_interval(set * Nef2::line(along))) return false;
  }
  return inside.is_subset_of(set);
}

/// An unbounded set within a box around all crossings of its lines.
bool is_convex_by_oracle(const Nef2& set) {
  const double far = 1e6;
  return is_convex_by_hull(set.is_bounded() ? set : set * box(-far, -far, far, far));
}

// ---------------------------------------------------------------- known answers

TEST(PlaneConvexity, OfEverySet) {
  const Nef2 square = box(0, 0, 4, 4);
  const Nef2 upper = Nef2::half_plane({{0, 0}, {1, 0}}, Boundary::Open);
  const Nef2 strip = upper * Nef2::half_plane({{1, 3}, {0, 3}}, Boundary::Closed);
  const Nef2 axis = line({0, 0}, {1, 0});
  struct Case {
    const char* name;
    Nef2 set;
    bool is_convex;
    std::uint64_t reflex, parts;
    std::size_t faces = 0;
  };
  const std::vector<Case> cases{
      {"empty", Nef2::empty(), true, 0, 0},
      {"plane", Nef2::whole(), true, 0, 1},
      {"point", point(1, 2), true, 0, 1},
      {"two points", point(1, 2) + point(2, 2), false, 0, 2},
      {"segment", segment({0, 0}, {3, 1}), true, 0, 1},
      {"open segment", segment({0, 0}, {3, 1}) - point(0, 0) - point(3, 1), true, 0, 1},
      {"segment without a point", segment({0, 0}, {4, 0}) - point(1, 0), false, 0, 2},
      {"bent line", Nef2::polyline(Points{{0, 0}, {1, 0}, {1, 1}}), false, 0, 1},
      {"line", axis, true, 0, 1},
      {"ray", Nef2::ray({{0, 0}, {1, 2}}, Boundary::Open), true, 0, 1},
      {"line and a point", axis + point(0, 1), false, 0, 2},
      {"segment in one line with a point", segment({0, 0}, {1, 0}) + point(2, 0), false, 0, 2},
      {"half-plane", upper, true, 0, 1},
      {"with a ray of its border", upper + Nef2::ray({{0, 0}, {1, 0}}, Boundary::Closed), true, 0,
       1},
      {"with two", upper + (axis - segment({0, 0}, {1, 0})), false, 0, 1},
      {"strip", strip, true, 0, 1},
      {"two strips", strip + (axis + upper).complement(), false, 0, 2},
      {"touching", strip + upper.complement(), true, 0, 1},
      {"square", square, true, 0, 1},
      {"open square", square.interior(), true, 0, 1},
      {"without a corner", square - point(0, 0), true, 0, 1},
      {"without a point of a side", square - point(1, 0), false, 0, 1},
      {"without a side", square - segment({0, 0}, {4, 0}), true, 0, 1},
      {"open, with two parts of a side",
       square.interior() + segment({0, 0}, {1, 0}) + segment({2, 0}, {3, 0}), false, 0, 1},
      {"open, with two corners", square.interior() + point(0, 0) + point(4, 0), false, 0, 1},
      {"open, with opposite corners", square.interior() + point(0, 0) + point(4, 4), true, 0, 1},
      {"with a whisker", square + segment({4, 4}, {5, 5}), false, 0, 1},
      {"and a point beside", square + point(9, 9), false, 0, 2},
      {"with a hole", square - box(1, 1, 2, 2), false, 4, 1, 1},
      {"without an inner point", square - point(1, 1), false, 1, 1, 1},
      {"with a slit", square - segment({1, 1}, {2, 2}), false, 2, 1, 1},
      {"cut through", square - line({1, 0}, {1, 1}), false, 0, 2},
      {"an L", square - box(2, 2, 5, 5), false, 1, 1, 1},
      {"two squares", square + box(5, 0, 6, 1), false, 0, 2},
      {"two that touch", square + box(4, 4, 5, 5), false, 0, 1},
      {"open ones that share a corner", (square + box(4, 4, 5, 5)).interior(), false, 0, 2},
      {"outside", !square, false, 4, 1, 1},
      {"plane without a point", !point(0, 0), false, 1, 1, 1},
      {"outside, and a part inside", !square + box(1, 1, 2, 2), false, 4, 2, 1},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const PlaneConvexity found = convexity(c.set);
    EXPECT_EQ(found.is_convex, c.is_convex);
    EXPECT_EQ(found.is_convex, is_convex_by_oracle(c.set));
    EXPECT_EQ(found.reflex_corners, c.reflex);
    EXPECT_EQ(found.parts, c.parts);
    EXPECT_EQ(found.faces.size(), c.faces);
  }
}

// ---------------------------------------------------------------- random sets

/// A convex polygon with marks of any kind on its boundary, points on sides too.
Nef2 half_open_polygon(Dice& dice) {
  Nef2 set = box(0, 0, 4, 4, Boundary::Open);
  const std::size_t corners = dice.below(3);
  for (std::size_t i = 0; i < corners; ++i) {
    const double at = static_cast<double>(dice.below(3) + 1);
    set -= Nef2::half_plane({{at, 0}, {0, at}}, Boundary::Closed);
  }
  const Nef2 sides = set.boundary();
  for (std::size_t i = dice.below(4); i > 0; --i) {
    const double low = static_cast<double>(dice.below(4));
    const double high = low + static_cast<double>(dice.below(3));
    const bool is_closed = dice.below(2) == 0;
    const Nef2 part =
        sides * box(low, -1, high + 1, 5, is_closed ? Boundary::Closed : Boundary::Open);
    set = dice.below(3) == 0 ? set - part : set + part;
  }
  return set;
}

/// Lattice polygons and points, added and taken away.
Nef2 any_set(Dice& dice) {
  Nef2 set;
  for (std::size_t i = 1 + dice.below(4); i > 0; --i) {
    Points points;
    for (std::size_t k = 1 + dice.below(4); k > 0; --k) {
      const double x = static_cast<double>(dice.below(4));
      points.push_back({x, static_cast<double>(dice.below(4))});
    }
    const Boundary boundary = dice.below(2) == 0 ? Boundary::Closed : Boundary::Open;
    const Nef2 next = Nef2::polygon(points, boundary);
    set = dice.below(3) == 0 ? set - next : set + next;
  }
  return dice.below(4) == 0 ? !set : set;
}

TEST(PlaneConvexity, IsThatOfTheHull) {
  std::size_t convex = 0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Nef2 set = seed % 2 == 0 ? half_open_polygon(dice) : any_set(dice);
    const PlaneConvexity found = convexity(set);
    ASSERT_EQ(found.is_convex, is_convex_by_oracle(set));
    convex += found.is_convex ? 1 : 0;
    Context context;
    ASSERT_EQ(found.reflex_corners, decompose(set, {}, context).reflex_corners);
    ASSERT_EQ(found.faces.empty(), found.reflex_corners == 0);
    for (const FailingRegion& failing : found.faces) {
      EXPECT_TRUE(set.complex().mark(failing.face));
      EXPECT_TRUE(set.has_on_boundary(failing.corner));
    }
  }
  EXPECT_GT(convex, 100U);
  EXPECT_LT(convex, 500U);
}

TEST(PlaneConvexity, LooksAtTheContext) {
  const Nef2 set = Nef2::polygon(star_polygon(2000, 3));
  Context small({.max_memory_bytes = 1000});
  EXPECT_THROW(convexity_of_set(set, small), Error);
  std::stop_source stop;
  stop.request_stop();
  Context stopped({}, stop.get_token());
  EXPECT_THROW(convexity_of_set(set, stopped), Error);
}

}  // namespace
}  // namespace plumb::testing::plane_convexity_test
