// Regions cut by the lines of their own sides, and pieces as sets: convex, disjoint, together the
// set, and no more than the bound allows.
#include "plumb/convex/region/region_cuts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "plumb/testing/dice.h"

namespace plumb::region_cuts_test {

using Points = std::vector<Point2>;

Nef2 polygon(const Points& points, Boundary boundary = Boundary::Closed) {
  return Nef2::polygon(points, boundary);
}
Nef2 box(double x, double y, double to_x, double to_y) {
  return polygon({{x, y}, {to_x, y}, {to_x, to_y}, {x, to_y}});
}
Nef2 line(double a, double b, double c, double d) { return Nef2::line({{a, b}, {c, d}}); }
Nef2 segment(Point2 a, Point2 b) { return Nef2::polyline(Points{a, b}); }

/// Triangles and points taken from a box, on a small lattice.
Nef2 random_set(testing::Dice& dice) {
  const auto point = [&] {
    const auto x = static_cast<double>(dice.below(7)), y = static_cast<double>(dice.below(7));
    return Point2{x, y};
  };
  Nef2 set = box(0, 0, 6, 6);
  for (int i = 0; i < 3; ++i) {
    const Point2 a = point(), b = point(), c = point();
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (area == 0) {
      if (a != b) set -= segment(a, b);
    } else {
      const Points corners = area > 0 ? Points{a, b, c} : Points{a, c, b};
      set -= polygon(corners, dice.below(2) == 0 ? Boundary::Open : Boundary::Closed);
    }
  }
  return set;
}

/// Bounded and unbounded, with slits, removed points and holes.
std::vector<Nef2> sets() {
  std::vector<Nef2> all = {
      Nef2::whole() - Nef2::point({1, 2}),
      Nef2::whole() - box(0, 0, 4, 4),
      Nef2::whole() - segment({0, 0}, {3, 1}),
      Nef2::half_plane({{0, 0}, {1, 3}}, Boundary::Open) - Nef2::point({-5, 0}),
      Nef2::whole() - line(0, 0, 1, 0) - line(0, 1, 1, 1) - line(0, 0, 0, 1),
      box(0, 0, 4, 4) - segment({1, 1}, {2, 3}) - Nef2::point({3, 3}),
      box(0, 0, 9, 9) - box(1, 1, 2, 2) - box(4, 1, 5, 2) - box(3, 3, 6, 8),
      box(0, 0, 4, 4) - polygon({{0, 0}, {2, 1}, {1, 2}}, Boundary::Open)};
  testing::Dice dice(1);
  for (int i = 0; i < 12; ++i) all.push_back(random_set(dice));
  return all;
}

std::vector<PlaneRegion> regions_of(const Nef2& set) {
  RegionMaker maker(set.complex());
  std::vector<PlaneRegion> regions;
  for (std::uint32_t f = 0; f < set.complex().face_count(); ++f) {
    if (set.complex().mark(FaceId(f))) regions.push_back(maker.region(FaceId(f)));
  }
  return regions;
}

std::size_t reflex_halves(const PlaneRegion& r) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < r.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    count += r.is_inside(h) && r.is_reflex(h) ? 1 : 0;
  }
  return count;
}

TEST(RegionCuts, LeaveNoReflexCornerAndFewPieces) {
  for (const Nef2& set : sets()) {
    for (PlaneRegion& r : regions_of(set)) {
      const std::size_t reflex = r.count_reflex_corners();
      const auto rings = static_cast<std::size_t>(
          std::ranges::count_if(r.loops, [](const Corner& c) { return c.is_halfedge(); }));
      cut_by_sides(r, unlimited_context());
      EXPECT_EQ(reflex_halves(r), 0U);
      EXPECT_LE(r.count_loops(), reflex + 2 - rings);
      const auto left = static_cast<std::size_t>(std::ranges::count(r.is_cut, 1));
      const PlaneRegion before = r;
      drop_superfluous(r);
      EXPECT_EQ(r.next, before.next);
      EXPECT_GE(left + 1, r.count_loops());
    }
  }
}

/// Sides where the set has them: a cut makes no line, but for points that were removed.
TEST(RegionCuts, RunAlongLinesOfTheSet) {
  for (const Nef2& set : sets()) {
    for (PlaneRegion& r : regions_of(set)) {
      const std::vector<PlaneLine> lines = r.line;
      const std::uint32_t level = r.first_level_point;
      cut_by_sides(r, unlimited_context());
      for (const PlaneLine& l : r.line) {
        EXPECT_TRUE(l.b >= level || std::ranges::find(lines, l) != lines.end());
      }
    }
  }
}

/// Every cut is needed by a corner: without it one is reflex.
TEST(RegionCuts, NoneIsSuperfluous) {
  for (const Nef2& set : sets()) {
    for (PlaneRegion& r : regions_of(set)) {
      cut_by_sides(r, unlimited_context());
      for (std::uint32_t e = 0; e < r.is_cut.size(); ++e) {
        const HalfedgeId h = first_half(EdgeId(e));
        if (r.is_cut[e] == 0 || !r.is_inside(h)) continue;
        PlaneRegion without = r;
        without.remove_edge(h);
        EXPECT_GT(reflex_halves(without), 0U);
      }
    }
  }
}

TEST(RegionCuts, PiecesAreConvexDisjointAndTogetherTheFaces) {
  for (const Nef2& set : sets()) {
    std::vector<Nef2> pieces;
    for (PlaneRegion& r : regions_of(set)) {
      const std::size_t before = pieces.size();
      cut_by_sides(r, unlimited_context());
      add_pieces(r, pieces, unlimited_context());
      EXPECT_EQ(pieces.size(), before + r.count_loops());
    }
    Nef2 sum = Nef2::empty();
    for (const Nef2& piece : pieces) {
      EXPECT_TRUE((sum * piece).is_empty());
      EXPECT_FALSE(piece.audit());
      sum += piece;
      // Convex: no reflex corner of its own.
      const std::vector<PlaneRegion> own = regions_of(piece);
      ASSERT_EQ(own.size(), 1U);
      EXPECT_EQ(own.front().count_reflex_corners(), 0U);
    }
    // What borders no face is not of a piece.
    EXPECT_TRUE(sum == set * set.interior().closure());
  }
}

/// A triangle side by side, each with or without its sides and corners.
TEST(RegionCuts, APieceOwnsTheSidesAndPointsItIsGiven) {
  PlanePoints points;
  for (const Point2 p : {Point2{0, 0}, {9, 9}, {4, 0}, {0, 4}}) points.inputs.push_back(p);
  const std::array<std::array<std::uint32_t, 2>, 3> sides = {{{0, 2}, {3, 2}, {0, 3}}};
  const std::array<Sign, 3> inside = {Sign::Positive, Sign::Negative, Sign::Negative};
  PieceMaker maker(points);
  for (unsigned mask = 0; mask < 64; ++mask) {
    for (unsigned i = 0; i < 3; ++i) {
      const auto [a, b] = sides[i];
      maker.add_side({a, b, a, b}, inside[i], (mask >> i & 1U) != 0);
      if ((mask >> (3 + i) & 1U) != 0) maker.add_point(a);
    }
    const Nef2 piece = maker.build(unlimited_context());
    EXPECT_FALSE(piece.audit());
    EXPECT_TRUE(piece.contains(Point2{1, 1}));
    EXPECT_FALSE(piece.contains(Point2{3, 3}));
    EXPECT_EQ(piece.area(), Rational(8));
    const std::array<Point2, 3> middle = {{{2, 0}, {2, 2}, {0, 2}}};
    for (unsigned i = 0; i < 3; ++i) {
      EXPECT_EQ(piece.contains(middle[i]), (mask >> i & 1U) != 0);
    }
    EXPECT_EQ(piece.contains(Point2{0, 0}), (mask >> 3 & 1U) != 0 || (mask >> 5 & 1U) != 0);
    EXPECT_EQ(piece.contains(Point2{0, 4}), (mask >> 4 & 1U) != 0);
  }
}

/// Half-planes, lines and the plane, with a crossing for an end.
TEST(RegionCuts, PiecesMayReachInfinity) {
  PlanePoints points;
  for (const Point2 p : {Point2{0, 0}, {1, 1}, {0, 2}, {2, 0}, {0, 5}}) points.inputs.push_back(p);
  points.crossings.push_back(make_crossing(points.inputs, 0, 1, 2, 3));
  constexpr std::uint32_t kFar = SweepCurve::kUnbounded;
  PieceMaker maker(points);
  EXPECT_TRUE(maker.build(unlimited_context()).is_whole());
  for (const auto& [a, b] : {std::pair(0U, 1U), {2U, 3U}, {0U, 4U}}) {
    for (const Sign s : {Sign::Positive, Sign::Negative}) {
      maker.add_side({kFar, kFar, a, b}, s, false);
      const Line2 along{points.inputs.exact(s == Sign::Positive ? a : b),
                        points.inputs.exact(s == Sign::Positive ? b : a)};
      EXPECT_TRUE(maker.build(unlimited_context()) == Nef2::half_plane(along, Boundary::Open));
    }
  }
  // Above both lines, with the corner.
  maker.add_side({5, kFar, 0, 1}, Sign::Positive, false);
  maker.add_side({kFar, 5, 2, 3}, Sign::Positive, false);
  maker.add_point(5);
  const Nef2 wedge = Nef2::half_plane({{0, 0}, {1, 1}}, Boundary::Open) *
                     Nef2::half_plane({{0, 2}, {2, 0}}, Boundary::Open);
  EXPECT_TRUE(maker.build(unlimited_context()) == wedge + Nef2::point({1, 1}));
  maker.add_side({kFar, 5, 0, 1}, Sign::Zero, true);
  EXPECT_TRUE(maker.build(unlimited_context()) ==
              Nef2::ray({{1, 1}, {0, 0}}, Boundary::Closed) - Nef2::point({1, 1}));
}

}  // namespace plumb::region_cuts_test
