// The sets to start from against the membership of points: signs of cross products, winding numbers
// by counting in integers, and the cells of a grid.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "plumb/plane/nef2.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/dice.h"

namespace plumb::shapes_test {

using Place = std::array<int, 2>;

int turn(const Place& a, const Place& b, const Place& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}
RationalPoint2 point(int x, int y) { return {x, y}; }
Line2 line(int ax, int ay, int bx, int by) { return {point(ax, ay), point(bx, by)}; }

template <class Function>
void expect_refused(ErrorCode code, const Function& function) {
  try {
    function();
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
  }
}

TEST(Shapes, HalfPlanesLinesAndRaysContainWhatSignsSay) {
  for (const Place b :
       {Place{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {2, 1}, {-1, 2}, {-2, -1}, {1, -2}}) {
    const Place a{1, 1}, to{a[0] + b[0], a[1] + b[1]};
    const Line2 l = line(a[0], a[1], to[0], to[1]);
    for (const Boundary boundary : {Boundary::Open, Boundary::Closed}) {
      const bool is_closed = boundary == Boundary::Closed;
      const Nef2 half = Nef2::half_plane(l, boundary), ray = Nef2::ray(l, boundary);
      const Nef2 other = Nef2::half_plane(l, point(a[0] + b[1], a[1] - b[0]), boundary);
      const Nef2 all = Nef2::line(l);
      for (int x = -3; x <= 5; ++x) {
        for (int y = -3; y <= 5; ++y) {
          const int side = turn(a, to, {x, y});
          const int along = (x - a[0]) * b[0] + (y - a[1]) * b[1];
          const RationalPoint2 p = point(x, y);
          EXPECT_EQ(half.contains(p), side > 0 || (is_closed && side == 0));
          EXPECT_EQ(other.contains(p), side < 0 || (is_closed && side == 0));
          EXPECT_EQ(all.contains(p), side == 0);
          EXPECT_EQ(ray.contains(p), side == 0 && (along > 0 || (is_closed && along == 0)));
        }
      }
      EXPECT_EQ(half.is_closed(), is_closed);
      EXPECT_EQ(half.is_open(), !is_closed);
      EXPECT_FALSE(half.audit().has_value() || ray.audit().has_value());
    }
  }
  for (int a = -2; a <= 2; ++a) {
    for (int b = -2; b <= 2; ++b) {
      if (a == 0 && b == 0) continue;
      const Nef2 half = Nef2::half_plane(Line2::from_coefficients(a, b, 3), Boundary::Open);
      for (int i = 0; i < 49; ++i) {
        const int x = i % 7 - 3, y = i / 7 - 3;
        EXPECT_EQ(half.contains(point(x, y)), a * x + b * y + 3 < 0);
      }
    }
  }
}

TEST(Shapes, HalfPlanesGivenInEveryWayAreEqual) {
  const Boundary open = Boundary::Open;
  const Nef2 left = Nef2::half_plane(line(3, 0, 3, 5), open);  // x < 3
  EXPECT_TRUE(left == Nef2::half_plane(line(3, -7, 3, 2), open));
  EXPECT_TRUE(left == Nef2::half_plane(line(3, 2, 3, 1), point(0, 0), open));
  EXPECT_TRUE(left == Nef2::half_plane(Line2::from_coefficients(1, 0, -3), open));
  EXPECT_TRUE(left == Nef2::half_plane(Line2::from_coefficients(7, 0, -21), open));
  EXPECT_TRUE(left == !Nef2::half_plane(Line2::from_coefficients(-1, 0, 3), Boundary::Closed));
  EXPECT_FALSE(left == Nef2::half_plane(Line2::from_coefficients(1, 0, -2), open));
}

/// Chains on even places of a grid. They cross each other and themselves, run twice along edges and
/// back on themselves; some have one point or two.
struct Chains {
  PointTable2 points;
  std::vector<Place> place;
  std::vector<std::uint32_t> corners, begin{0};

  explicit Chains(testing::Dice& dice) {
    for (std::uint32_t c = 1 + dice.below(3); c > 0; --c) {
      for (std::uint32_t i = dice.below(6); i > 0; --i) {
        corners.push_back(static_cast<std::uint32_t>(points.size()));
        const Place p{2 * static_cast<int>(dice.between(0, 4)),
                      2 * static_cast<int>(dice.between(0, 4))};
        place.push_back(p);
        points.push_back(Point2{static_cast<double>(p[0]), static_cast<double>(p[1])});
      }
      begin.push_back(static_cast<std::uint32_t>(corners.size()));
    }
  }
  /// All edges; closed chains return to their first point.
  std::vector<std::array<Place, 2>> edges(bool is_closed) const {
    std::vector<std::array<Place, 2>> all;
    for (std::size_t c = 0; c + 1 < begin.size(); ++c) {
      for (std::uint32_t i = begin[c]; i < begin[c + 1]; ++i) {
        const bool is_last = i + 1 == begin[c + 1];
        if (is_last && !is_closed && begin[c + 1] - begin[c] > 1) continue;
        all.push_back({place[i], place[is_last ? begin[c] : i + 1]});
      }
    }
    return all;
  }
};

bool is_on(const std::array<Place, 2>& edge, const Place& p) {
  return turn(edge[0], edge[1], p) == 0 && std::min(edge[0], edge[1]) <= p &&
         p <= std::max(edge[0], edge[1]);
}

TEST(Shapes, PolygonsContainWhatTheyWindAround) {
  testing::Dice dice(1);
  for (int round = 0; round < 120; ++round) {
    const Chains chains(dice);
    const auto edges = chains.edges(true);
    for (const WindingRule rule :
         {WindingRule::NonZero, WindingRule::EvenOdd, WindingRule::Positive}) {
      const auto make = [&](Boundary boundary) {
        return Nef2::polygons(chains.points, chains.corners, chains.begin, rule, boundary);
      };
      const Nef2 open = make(Boundary::Open), closed = make(Boundary::Closed);
      EXPECT_TRUE(open.is_open() && closed.is_closed() && open.is_subset_of(closed));
      for (int i = 0; i < 100; ++i) {
        const Place p{i % 10 - 1, i / 10 - 1};
        if (std::ranges::any_of(edges, [&](const auto& e) { return is_on(e, p); })) {
          EXPECT_FALSE(rule == WindingRule::NonZero && edges.size() < 3 &&
                       open.contains(point(p[0], p[1])));
          continue;
        }
        int winding = 0;  // edges that cross the ray to the right, upward minus downward
        for (const auto& [a, b] : edges) {
          if (a[1] <= p[1] && b[1] > p[1] && turn(a, b, p) > 0) ++winding;
          if (b[1] <= p[1] && a[1] > p[1] && turn(a, b, p) < 0) --winding;
        }
        const bool inside = rule == WindingRule::EvenOdd    ? winding % 2 != 0
                            : rule == WindingRule::Positive ? winding > 0
                                                            : winding != 0;
        EXPECT_EQ(open.contains(point(p[0], p[1])), inside);
        EXPECT_EQ(closed.contains(point(p[0], p[1])), inside);
      }
    }
  }
}

/// A chain there and back is a segment, a chain of one point a point, if the set is closed.
TEST(Shapes, PolygonsWithoutInsideAreSlitsAndPoints) {
  const std::vector<Point2> spike{{0, 0}, {4, 2}, {2, 1}}, dot{{3, 3}, {3, 3}};
  const std::vector<Point2> segment{{0, 0}, {4, 2}};
  EXPECT_TRUE(Nef2::polygon(spike) == Nef2::polyline(segment));
  EXPECT_TRUE(Nef2::polygon(dot) == Nef2::point(point(3, 3)));
  EXPECT_TRUE(Nef2::polyline(dot) == Nef2::point(point(3, 3)));
  for (const auto& chain : {spike, dot, std::vector<Point2>{}}) {
    EXPECT_TRUE(Nef2::polygon(chain, Boundary::Open).is_empty());
  }
  EXPECT_TRUE(Nef2::polygon({}).is_empty());
  EXPECT_TRUE(Nef2::polyline({}).is_empty());
}

TEST(Shapes, PolylinesAndPointsContainWhatLiesOnThem) {
  testing::Dice dice(2);
  for (int round = 0; round < 120; ++round) {
    const Chains chains(dice);
    const Nef2 lines = Nef2::polylines(chains.points, chains.corners, chains.begin);
    const Nef2 points = Nef2::points(chains.points);
    EXPECT_FALSE(lines.audit().has_value() || points.audit().has_value());
    const auto edges = chains.edges(false);
    for (int i = 0; i < 100; ++i) {
      const Place p{i % 10 - 1, i / 10 - 1};
      EXPECT_EQ(lines.contains(point(p[0], p[1])),
                std::ranges::any_of(edges, [&](const auto& e) { return is_on(e, p); }));
      EXPECT_EQ(points.contains(point(p[0], p[1])), std::ranges::count(chains.place, p) > 0);
    }
  }
}

/// Cells of a 3 x 3 grid, and all that is outside: closed sets have what touches any chosen one,
/// open ones what touches chosen ones alone.
TEST(Shapes, SubdivisionsContainChosenRegions) {
  Map map;
  for (int i = 0; i < 16; ++i) {
    map.points.push_back(
        Point2{static_cast<double>(2 * (i % 4)), static_cast<double>(2 * (i / 4))});
  }
  for (std::uint32_t i = 0; i < 11; ++i) {
    if (i % 4 == 3) continue;
    map.add_cycle(std::array<std::uint32_t, 4>{i, i + 1, i + 5, i + 4});
  }
  const MapReport report = check_map(map, {OuterRule::Infer});
  ASSERT_EQ(report.regions.size(), 10U);
  testing::Dice dice(3);
  for (int round = 0; round < 40; ++round) {
    std::vector<std::uint8_t> chosen(report.regions.size());
    for (std::uint8_t& one : chosen) one = static_cast<std::uint8_t>(dice.below(2));
    const Nef2 open = Nef2::subdivision(report, chosen, Boundary::Open);
    const Nef2 closed = Nef2::subdivision(report, chosen, Boundary::Closed);
    for (int x = -1; x <= 7; ++x) {
      for (int y = -1; y <= 7; ++y) {
        bool any = false, all = true;
        const auto touch = [&](std::size_t region) {
          any = any || chosen[region] != 0;
          all = all && chosen[region] != 0;
        };
        if (x <= 0 || y <= 0 || x >= 6 || y >= 6) touch(0);
        for (std::size_t r = 1; r < chosen.size(); ++r) {
          const Point2 low =
              report.map.points.approx(report.map.cycle(*report.regions[r].outer)[0]);
          if (low.x <= x && x <= low.x + 2 && low.y <= y && y <= low.y + 2) touch(r);
        }
        EXPECT_EQ(closed.contains(point(x, y)), any);
        EXPECT_EQ(open.contains(point(x, y)), all);
      }
    }
  }
  const std::vector<std::uint8_t> too_few(9);
  expect_refused(ErrorCode::BadArgument,
                 [&] { (void)Nef2::subdivision(report, too_few, Boundary::Open); });
}

TEST(Shapes, RefuseWhatIsNoShape) {
  const auto bad = [](const auto& function) { expect_refused(ErrorCode::BadArgument, function); };
  PointTable2 points;
  for (int i = 0; i < 3; ++i) points.push_back(Point2{static_cast<double>(i), 0});
  using Numbers = std::vector<std::uint32_t>;
  const auto refuse_chains = [&](const Numbers& corners, const Numbers& begin) {
    bad([&] {
      (void)Nef2::polygons(points, corners, begin, WindingRule::NonZero, Boundary::Open);
    });
    bad([&] { (void)Nef2::polylines(points, corners, begin); });
  };
  refuse_chains({0, 1, 2}, {});            // no end
  refuse_chains({0, 1, 2}, {1, 3});        // a corner before the first chain
  refuse_chains({0, 1, 2}, {0, 2});        // one after the last
  refuse_chains({0, 1, 2}, {0, 2, 1, 3});  // chains that run back
  refuse_chains({0, 1, 3}, {0, 3});        // no such point
  bad([] { (void)Nef2::half_plane(line(1, 1, 1, 1), Boundary::Open); });
  bad([] { (void)Nef2::half_plane(line(1, 1, 1, 1), point(0, 0), Boundary::Open); });
  bad([] { (void)Nef2::half_plane(line(0, 0, 1, 1), point(5, 5), Boundary::Open); });
  bad([] { (void)Nef2::line(line(1, 1, 1, 1)); });
  bad([] { (void)Line2::from_coefficients(0, 0, 1); });
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Point2 p : {Point2{0, infinity}, Point2{-infinity, 0}}) {
    const std::vector<Point2> chain{{0, 0}, p, {1, 0}};
    expect_refused(ErrorCode::NotFinite, [&] { (void)Nef2::polygon(chain); });
    expect_refused(ErrorCode::NotFinite, [&] { (void)Nef2::polyline(chain); });
  }
}

}  // namespace plumb::shapes_test
