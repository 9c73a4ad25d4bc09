// Counters of rungs: with PLUMB_COUNT_RUNGS a question is counted once, where it was decided;
// otherwise nowhere.
#include "plumb/predicates/input/rung_counters.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <string>
#include <thread>

#include "plumb/predicates/plane/plane_points.h"
#include "plumb/predicates/plane/query2.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/predicates/space/query_point3.h"

namespace plumb::rung_counters_test {
namespace {

#ifdef PLUMB_COUNT_RUNGS
constexpr std::uint64_t kCounted = 1;
#else
constexpr std::uint64_t kCounted = 0;
#endif

/// Points 0 to 3 span two diagonals of a square; 4 and 5 a line through their crossing; 6 is a
/// third of 1 in x, 7 right of all. 8 and 9: the same, and one further up.
PlanePoints square() {
  PlanePoints points;
  for (const Point2 p : {Point2{0, 0}, {1, 1}, {0, 1}, {1, 0}, {0.5, 0}, {0.5, 1}}) {
    points.inputs.push_back(p);
  }
  points.inputs.push_back(Rational(1, 3), Rational(0));
  points.inputs.push_back({2, 2});
  points.inputs.push_back(Rational(1, 3), Rational(0));
  points.inputs.push_back(Rational(1, 3), Rational(1));
  return points;
}

/// The planes of a tetrahedron, and a point off all of them.
struct Planes {
  PlaneTable table;
  InputPointId origin = table.add_point({0, 0, 0});
  InputPointId right = table.add_point({1, 0, 0});
  InputPointId back = table.add_point({0, 1, 0});
  InputPointId peak = table.add_point({0, 0, 1});
  InputPointId far = table.add_point({1, 1, 1});
  PlaneId floor = table.intern(origin, right, back).plane();
  PlaneId left = table.intern(origin, back, peak).plane();
  PlaneId front = table.intern(origin, peak, right).plane();
  PlaneId slope = table.intern(right, back, peak).plane();
  PlaneId diagonal = table.intern(origin, right, far).plane();
  PlaneId middle = table.intern(1.0, -1.0, 0.0, 0.0).plane();
  PlaneId wall = table.intern(Pencil{left, front, 2, 3}).plane();
};

struct Question {
  std::string name;
  Predicate predicate;
  Rung rung;
  std::function<void()> ask;
};

void expect_counted_once(const Question& q) {
  reset_rung_counts();
  q.ask();
  const RungCounts counts = rung_counts();
  std::uint64_t all = 0;
  for (const auto& of_predicate : counts) {
    all += std::accumulate(of_predicate.begin(), of_predicate.end(), std::uint64_t{0});
  }
  EXPECT_EQ(counts[static_cast<std::size_t>(q.predicate)][static_cast<std::size_t>(q.rung)],
            kCounted)
      << q.name;
  EXPECT_EQ(all, kCounted) << q.name;
}

TEST(RungCounters, CountQuestionsOfThePlaneOnce) {
  using enum Predicate;
  const PlanePoints points = square();
  const PointTable2& t = points.inputs;
  const Crossing2 centre = make_crossing(t, 0, 1, 2, 3), again = make_crossing(t, 0, 1, 4, 5);
  const Crossing2 corner = make_crossing(t, 0, 1, 1, 3);
  const QueryPoint2 query(Point2{0.25, 0.5}), third(RationalPoint2{Rational(1, 3), 0});
  const QueryRay2 ray({0, Rational(1, 3)}, {1, Rational(1, 3)});
  const Question questions[] = {
      {"a turn", Orient2d, Rung::Filter, [&] { orient2d(t, 0, 3, 2); }},
      {"no turn", Orient2d, Rung::Small, [&] { orient2d(t.approx(0), t.approx(1), t.approx(7)); }},
      {"a turn at a fraction", Orient2d, Rung::Filter, [&] { orient2d(t, 6, 3, 2); }},
      {"no turn at a fraction", Orient2d, Rung::Big, [&] { orient2d(t, 0, 3, 6); }},
      {"a turn of fractions", Orient2d, Rung::Big,
       [&] { orient2d(t.exact(0), t.exact(1), t.exact(2)); }},
      {"directions with a fraction", CrossSign, Rung::Filter, [&] { cross_sign(t, 0, 6, 0, 2); }},
      {"parallel ones", CrossSign, Rung::Big, [&] { cross_sign(t, 0, 6, 0, 3); }},
      {"order by x", ComparePoints2, Rung::Filter, [&] { compare_xy(t, 0, 1); }},
      {"order by y", ComparePoints2, Rung::Exact, [&] { compare_xy(t, 0, 2); }},
      {"order of fractions", ComparePoints2, Rung::Big, [&] { compare_xy(t, 6, 9); }},
      {"a crossing and a point", CompareCrossings2, Rung::Filter,
       [&] { compare_xy(t, centre, 7); }},
      {"a crossing below a point", CompareCrossings2, Rung::Exact,
       [&] { compare_xy(t, centre, 5); }},
      {"a crossing and a fraction", CompareCrossings2, Rung::Big,
       [&] { compare_xy(t, make_crossing(t, 6, 9, 0, 1), 6); }},
      {"two crossings", CompareCrossings2, Rung::Filter, [&] { compare_xy(t, centre, corner); }},
      {"one crossing of three lines", CompareCrossings2, Rung::Exact,
       [&] { compare_xy(t, centre, again); }},
      {"one crossing", CompareCrossings2, Rung::Identity, [&] { compare_xy(t, centre, centre); }},
      {"side of a crossing", SideOfCrossing2, Rung::Filter, [&] { orient2d(t, 0, 2, centre); }},
      {"on its own line", SideOfCrossing2, Rung::Identity, [&] { orient2d(t, 0, 1, centre); }},
      {"on a third line", SideOfCrossing2, Rung::Exact, [&] { orient2d(t, 4, 5, centre); }},
      {"on the line of fractions", SideOfCrossing2, Rung::Big,
       [&] { orient2d(t, 8, 9, make_crossing(t, 6, 9, 0, 1)); }},
      {"a query", PointQuery2, Rung::Filter, [&] { compare_xy(points, 1, query); }},
      {"a query that is a fraction", PointQuery2, Rung::Big, [&] { compare_xy(points, 6, third); }},
      {"side of a ray", RayQuery2, Rung::Filter, [&] { side(points, ray, 7); }},
      {"on a ray", RayQuery2, Rung::Big,
       [&] {
         side(points, QueryRay2({0, 0}, {1, 0}), 6);
       }},
      {"steeper than a ray", RayQuery2, Rung::Filter, [&] { turn(points, 4, 5, ray); }},
      {"parallel to a ray", RayQuery2, Rung::Big,
       [&] {
         turn(points, 0, 3, QueryRay2({0, 1}, {1, 0}));
       }},
      {"a crossing on a ray, by x", RayQuery2, Rung::Filter,
       [&] { compare_crossing_x(points, ray, 4, 5, 7); }},
      {"above a point", RayQuery2, Rung::Big, [&] { compare_crossing_x(points, ray, 4, 5, 4); }},
      {"a crossing on a ray", RayQuery2, Rung::Filter,
       [&] { compare_crossing_xy(points, ray, 4, 5, 7); }},
      {"above a point, by y", RayQuery2, Rung::Big,
       [&] { compare_crossing_xy(points, ray, 4, 5, 4); }},
  };
  for (const Question& q : questions) expect_counted_once(q);
}

TEST(RungCounters, DoNotCountAPointAndItself) {
  const PlanePoints points = square();
  reset_rung_counts();
  for (std::uint32_t i = 0; i < 10; ++i) {
    EXPECT_EQ(compare_x(points, i, i), Sign::Zero);
    EXPECT_EQ(compare_xy(points, i, i), Sign::Zero);
  }
  EXPECT_EQ(rung_counts(), RungCounts{});
}

TEST(RungCounters, CountQuestionsOfSpaceOnce) {
  using enum Predicate;
  const Planes p;
  Point3Table points(p.table);
  const SpacePoint corner = points.add(p.floor, p.left, p.front);
  const SpacePoint third = points.add(p.origin, p.far, p.slope);
  const SpacePoint peak(p.peak), far(p.far);
  const QueryPoint3 query(RationalPoint3{Rational(1, 3), 0, 0});
  const Question questions[] = {
      {"normals", PlaneMinor, Rung::Filter, [&] { minor_sign(p.table, p.left, p.front, 2); }},
      {"a plane twice", PlaneDet3, Rung::Identity,
       [&] { det3_sign(p.table, p.left, p.left, p.front); }},
      {"the last one twice", PlaneDet3, Rung::Identity,
       [&] { det3_sign(p.table, p.left, p.front, p.front); }},
      {"the first one last", PlaneDet3, Rung::Identity,
       [&] { det3_sign(p.table, p.left, p.front, p.left); }},
      {"four planes", PlaneDet4, Rung::Filter,
       [&] { det4_sign(p.table, p.floor, p.left, p.front, p.slope); }},
      {"side", SideOfPlane, Rung::Filter, [&] { side(points, far, p.slope); }},
      {"on a plane of its own", SideOfPlane, Rung::Identity, [&] { side(points, peak, p.slope); }},
      {"on a plane of its line", SideOfPlane, Rung::Small, [&] { side(points, third, p.middle); }},
      {"on a plane of others", SideOfPlane, Rung::Small, [&] { side(points, corner, p.diagonal); }},
      {"order", CompareAxis, Rung::Filter, [&] { compare_axis(points, peak, far, 0); }},
      {"the same height", CompareAxis, Rung::Identity, [&] { compare_axis(points, peak, far, 2); }},
      {"points apart", CompareAxis, Rung::Filter, [&] { equal(points, peak, far); }},
      {"a line in its own plane", HoldsLine, Rung::Identity,
       [&] { holds_line(p.table, p.left, p.left, p.front); }},
      {"a line in its other plane", HoldsLine, Rung::Identity,
       [&] { holds_line(p.table, p.front, p.left, p.front); }},
      {"a line in a wall through it", HoldsLine, Rung::Identity,
       [&] { holds_line(p.table, p.wall, p.left, p.front); }},
      {"a line across", HoldsLine, Rung::Filter,
       [&] { holds_line(p.table, p.floor, p.left, p.front); }},
      {"side of a query", SideOfPlane, Rung::Filter, [&] { side(points, query, p.slope); }},
      {"a query on a plane", SideOfPlane, Rung::Big, [&] { side(points, query, p.floor); }},
      {"order of a query", CompareAxis, Rung::Filter, [&] { compare_axis(points, far, query, 0); }},
  };
  for (const Question& q : questions) expect_counted_once(q);
}

// Degenerate, and too wide for all rungs but the last: on the line, or the plane, x = y.
TEST(RungCounters, CountQuestionsOfWideDoublesOnce) {
  using enum Predicate;
  const Point2 a{1, 1}, b{0x1p400, 0x1p400}, c{0x1p-400, 0x1p-400}, d{3, 3};
  const Point3 o{1, 1, 0}, x{0x1p200, 0x1p200, 1}, y{0x1p-200, 0x1p-200, 2}, z{3, 3, 5}, w{7, 7, 1};
  const Question questions[] = {
      {"a turn", Orient2d, Rung::Big, [&] { orient2d(a, b, c); }},
      {"directions", CrossSign, Rung::Big, [&] { cross_sign(a, b, a, c); }},
      {"a circle", Incircle, Rung::Big, [&] { incircle(a, b, c, d); }},
      {"a side", Orient3d, Rung::Big, [&] { orient3d(o, x, y, z); }},
      {"a sphere", Insphere, Rung::Big, [&] { insphere(o, x, y, z, w); }},
  };
  for (const Question& q : questions) expect_counted_once(q);
}

TEST(RungCounters, CountQuestionsOfFractionsOnce) {
  using enum Predicate;
  const RationalPoint2 a{0, 0}, b{1, 0}, c{0, Rational(1, 3)};
  const RationalPoint3 o{0, 0, 0}, x{1, 0, 0}, y{0, 1, 0}, z{0, 0, Rational(1, 3)};
  const Question questions[] = {
      {"a turn", Orient2d, Rung::Big, [&] { orient2d(a, b, c); }},
      {"directions", CrossSign, Rung::Big, [&] { cross_sign(a, b, a, c); }},
      {"a side", Orient3d, Rung::Big, [&] { orient3d(o, x, y, z); }},
      {"a circle", Incircle, Rung::Big, [&] { incircle(a, b, c, c); }},
      {"a sphere", Insphere, Rung::Big, [&] { insphere(o, x, y, z, z); }},
  };
  for (const Question& q : questions) expect_counted_once(q);
}

TEST(RungCounters, AreThoseOfTheirThread) {
  reset_rung_counts();
  std::thread([] { orient2d(Point2{0, 0}, Point2{1, 0}, Point2{0, 1}); }).join();
  EXPECT_EQ(rung_counts(), RungCounts{});
}

TEST(RungCounters, HaveNames) {
  EXPECT_STREQ(kPredicateNames[static_cast<std::size_t>(Predicate::RayQuery2)], "ray query");
  EXPECT_STREQ(kPredicateNames[static_cast<std::size_t>(Predicate::PlaneMinor)], "plane minor");
  EXPECT_STREQ(kRungNames[static_cast<std::size_t>(Rung::Identity)], "identity");
}

}  // namespace
}  // namespace plumb::rung_counters_test
