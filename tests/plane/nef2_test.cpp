// Sets of the plane one by one: what each maker makes, unbounded sets in every order, and what a
// person would ask of them.
#include "plumb/plane/nef2.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "oracle/nef2_check.h"
#include "plumb/predicates/error.h"

namespace plumb::testing::nef2_test {
namespace {

Line2 line(int ax, int ay, int bx, int by) {
  return {RationalPoint2{ax, ay}, RationalPoint2{bx, by}};
}
RationalPoint2 point(int x, int y) { return {x, y}; }

struct Counts {
  std::size_t vertices, edges, faces;
  friend bool operator==(const Counts&, const Counts&) = default;
};
void PrintTo(const Counts& c, std::ostream* out) {
  *out << c.vertices << " vertices, " << c.edges << " edges, " << c.faces << " faces";
}
Counts counts(const Nef2& set) {
  const PlaneComplex& c = set.complex();
  return {c.vertex_count(), c.edge_count(), c.face_count()};
}

void expect_clean(const Nef2& set) {
  const auto flaw = set.audit();
  EXPECT_FALSE(flaw.has_value()) << flaw->invariant << " at " << flaw->place;
}

// ---------------------------------------------------------------- a table of sets

struct SetCase {
  std::string name;
  PlaneSetPointer set;
  Counts counts;
  std::vector<std::pair<int, int>> inside, outside;
};
void PrintTo(const SetCase& c, std::ostream* out) { *out << c.name; }

ExactPoint at(int x, int y) { return {x, y}; }

PlaneSetPointer half_plane(int ax, int ay, int bx, int by, Boundary boundary) {
  return set_of(SetHalfPlane{at(ax, ay), at(bx, by), boundary});
}
PlaneSetPointer polygon(std::vector<Chain> chains, WindingRule rule, Boundary boundary) {
  return set_of(SetPolygons{std::move(chains), rule, boundary});
}
PlaneSetPointer both(const PlaneSetPointer& a, const PlaneSetPointer& b) {
  return testing::apply(SetOperator::Intersection, a, b);
}
PlaneSetPointer either(const PlaneSetPointer& a, const PlaneSetPointer& b) {
  return testing::apply(SetOperator::Union, a, b);
}
PlaneSetPointer without(const PlaneSetPointer& a, const PlaneSetPointer& b) {
  return testing::apply(SetOperator::Difference, a, b);
}
PlaneSetPointer complement(const PlaneSetPointer& a) {
  return testing::apply(SetOperator::Complement, a);
}

const Chain kSquare{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
const Chain kReversed{{0, 4}, {4, 4}, {4, 0}, {0, 0}};
const Chain kInner{{1, 1}, {3, 1}, {3, 3}, {1, 3}};
const Chain kNext{{4, 0}, {8, 0}, {8, 4}, {4, 4}};
const Chain kBowTie{{0, 0}, {4, 4}, {4, 0}, {0, 4}};
constexpr auto kOpen = Boundary::Open;
constexpr auto kClosed = Boundary::Closed;
constexpr auto kNonZero = WindingRule::NonZero;
constexpr auto kEvenOdd = WindingRule::EvenOdd;
constexpr auto kPositive = WindingRule::Positive;

std::vector<SetCase> set_cases() {
  const auto left = half_plane(-1, 0, -1, 1, kClosed);   // x <= -1
  const auto low = half_plane(0, -1, -1, -1, kClosed);   // y <= -1
  const auto right = half_plane(-1, 1, -1, 0, kClosed);  // x >= -1
  const auto high = half_plane(-1, -1, 0, -1, kClosed);  // y >= -1
  const auto square = polygon({kSquare}, kNonZero, kClosed);
  return {
      {"empty", set_of(SetPoints{}), {0, 0, 1}, {}, {{0, 0}}},
      {"plane", complement(set_of(SetPoints{})), {0, 0, 1}, {{0, 0}}, {}},
      {"half_plane_closed", left, {0, 1, 2}, {{-1, 5}, {-2, 0}}, {{0, 0}}},
      {"half_plane_open", half_plane(-1, 0, -1, 1, kOpen), {0, 1, 2}, {{-2, 0}}, {{-1, 5}, {0, 0}}},
      {"wedge", both(left, low), {1, 2, 2}, {{-1, -1}, {-5, -1}}, {{0, -1}, {-1, 0}}},
      {"wedge_other_order", both(low, left), {1, 2, 2}, {{-1, -1}, {-5, -1}}, {{0, -1}, {-1, 0}}},
      {"line_left", both(left, right), {0, 1, 2}, {{-1, 9}}, {{0, 0}, {-2, 0}}},
      {"point_left",
       both(both(left, right), both(low, high)),
       {1, 0, 1},
       {{-1, -1}},
       {{-1, 0}, {0, -1}}},
      {"strip",
       both(right, half_plane(1, 0, 1, 1, kOpen)),
       {0, 2, 3},
       {{-1, 0}, {0, 7}},
       {{1, 0}, {2, 0}, {-2, 0}}},
      {"slit_plane", complement(both(left, right)), {0, 1, 2}, {{0, 0}, {-2, 0}}, {{-1, 3}}},
      {"nothing_left", both(left, half_plane(0, 1, 0, 0, kClosed)), {0, 0, 1}, {}, {{0, 0}}},
      {"everything", either(left, half_plane(-1, 1, -1, 0, kOpen)), {0, 0, 1}, {{-1, 0}}, {}},
      {"line", set_of(SetLine{at(0, 0), at(2, 1)}), {0, 1, 2}, {{4, 2}, {-2, -1}}, {{1, 0}}},
      {"ray_closed",
       set_of(SetRay{at(0, 0), at(0, -1), kClosed}),
       {1, 1, 1},
       {{0, 0}, {0, -9}},
       {{0, 1}, {1, 0}}},
      {"ray_open",
       set_of(SetRay{at(0, 0), at(1, 1), kOpen}),
       {1, 1, 1},
       {{2, 2}},
       {{0, 0}, {-1, -1}}},
      {"square_closed", square, {4, 4, 2}, {{0, 0}, {2, 0}, {2, 2}}, {{5, 0}}},
      {"square_open", polygon({kSquare}, kNonZero, kOpen), {4, 4, 2}, {{2, 2}}, {{0, 0}, {2, 0}}},
      {"square_clockwise",
       polygon({kReversed}, kNonZero, kClosed),
       {4, 4, 2},
       {{2, 2}, {0, 0}},
       {}},
      {"clockwise_is_not_positive",
       polygon({kReversed}, kPositive, kOpen),
       {0, 0, 1},
       {},
       {{2, 2}, {0, 0}}},
      {"corner_cut_off", without(square, both(left, low)), {4, 4, 2}, {{0, 0}}, {}},
      {"hole",
       polygon({kSquare, kInner}, kEvenOdd, kClosed),
       {8, 8, 3},
       {{1, 1}, {0, 2}},
       {{2, 2}}},
      {"hole_open", polygon({kSquare, kInner}, kEvenOdd, kOpen), {8, 8, 3}, {}, {{1, 1}, {2, 2}}},
      {"neighbours", polygon({kSquare, kNext}, kNonZero, kClosed), {4, 4, 2}, {{4, 2}, {4, 0}}, {}},
      {"open_neighbours",
       polygon({kSquare, kNext}, kNonZero, kOpen),
       {6, 7, 3},
       {{2, 2}, {6, 2}},
       {{4, 2}, {4, 0}}},
      {"overlap_open",
       polygon({kSquare, {{2, 1}, {6, 1}, {6, 3}, {2, 3}}}, kNonZero, kOpen),
       {8, 8, 2},
       {{4, 2}, {2, 2}, {5, 2}},
       {{4, 1}, {4, 3}}},
      {"bow_tie", polygon({kBowTie}, kNonZero, kClosed), {5, 6, 3}, {{2, 2}, {1, 2}}, {{2, 1}}},
      {"bow_tie_positive",
       polygon({kBowTie}, kPositive, kOpen),
       {3, 3, 2},
       {{1, 2}},
       {{2, 2}, {3, 2}}},
      {"marked_edge",
       polygon({{{0, 0}, {2, 0}}}, kNonZero, kClosed),
       {2, 1, 1},
       {{1, 0}},
       {{3, 0}}},
      {"no_open_edge", polygon({{{0, 0}, {2, 0}}}, kNonZero, kOpen), {0, 0, 1}, {}, {{1, 0}}},
      {"marked_point", polygon({{{3, 3}}}, kNonZero, kClosed), {1, 0, 1}, {{3, 3}}, {{3, 2}}},
      {"no_open_point", polygon({{{3, 3}}}, kNonZero, kOpen), {0, 0, 1}, {}, {{3, 3}}},
      {"spike",
       polygon({{{0, 0}, {4, 0}, {4, 4}, {9, 4}, {4, 4}, {0, 4}}}, kNonZero, kClosed),
       {5, 5, 2},
       {{9, 4}, {7, 4}},
       {{7, 3}}},
      {"polyline",
       set_of(SetPolylines{{{{0, 0}, {2, 0}, {4, 0}, {4, 4}}}}),
       {3, 2, 1},
       {{1, 0}, {4, 4}},
       {{2, 2}}},
      {"points",
       set_of(SetPoints{{{0, 0}, {1, 0}, {0, 0}}}),
       {2, 0, 1},
       {{0, 0}, {1, 0}},
       {{2, 0}}},
      {"point_off_a_line",
       without(set_of(SetLine{at(0, 0), at(1, 0)}), set_of(SetPoints{{{3, 0}}})),
       {1, 2, 2},
       {{2, 0}, {4, 0}},
       {{3, 0}}},
      {"point_on_open_square",
       either(polygon({kSquare}, kNonZero, kOpen), set_of(SetPoints{{{2, 0}}})),
       {5, 5, 2},
       {{2, 0}, {2, 2}},
       {{1, 0}}},
      {"point_in_the_plane",
       complement(set_of(SetPoints{{{1, 1}}})),
       {1, 0, 1},
       {{0, 0}},
       {{1, 1}}},
      {"regular_slit",
       testing::apply(SetOperator::Regularization,
                      without(square, set_of(SetPolylines{{{{0, 2}, {4, 2}}}}))),
       {4, 4, 2},
       {{2, 2}},
       {}},
      {"regular_dust",
       testing::apply(SetOperator::Regularization, set_of(SetLine{at(0, 0), at(1, 0)})),
       {0, 0, 1},
       {},
       {{0, 0}}},
  };
}

class SetCases : public ::testing::TestWithParam<SetCase> {};

TEST_P(SetCases, AreWhatTheirNameSays) {
  const SetCase& c = GetParam();
  const Nef2 set = to_nef(*c.set);
  EXPECT_EQ(counts(set), c.counts);
  for (const auto& [x, y] : c.inside) EXPECT_TRUE(set.contains(point(x, y))) << x << ' ' << y;
  for (const auto& [x, y] : c.outside) EXPECT_FALSE(set.contains(point(x, y))) << x << ' ' << y;
}

TEST_P(SetCases, AreThoseOfTheTwin) { EXPECT_EQ(disagreement(*GetParam().set), ""); }

// In every order of the two, through complements and back.
TEST_P(SetCases, CombineWithAllOthers) {
  const std::vector<SetCase> others = set_cases();
  for (const SetCase& other : others) {
    SCOPED_TRACE(other.name);
    const auto two = testing::apply(SetOperator::SymmetricDifference, GetParam().set, other.set);
    const LineCells cells = cells_of(*two);
    const TwoSets a{to_nef(*GetParam().set), marks_of(*GetParam().set, cells)};
    const TwoSets b{to_nef(*other.set), marks_of(*other.set, cells)};
    for (const auto op : {SetOperator::Union, SetOperator::Intersection, SetOperator::Difference,
                          SetOperator::SymmetricDifference}) {
      EXPECT_EQ(difference(cells, {testing::apply(op, a.engine, b.engine),
                                   testing::apply(op, cells, a.twin, b.twin)}),
                "");
    }
    EXPECT_EQ(a.engine == b.engine, a.twin == b.twin);
    const CellMarks rest = testing::apply(SetOperator::Difference, cells, a.twin, b.twin);
    EXPECT_EQ(a.engine.is_subset_of(b.engine),
              std::find(rest.begin(), rest.end(), true) == rest.end());
  }
}

INSTANTIATE_TEST_SUITE_P(Nef2, SetCases, ::testing::ValuesIn(set_cases()),
                         [](const auto& tested) { return tested.param.name; });

// ---------------------------------------------------------------- any order

TEST(Nef2, AWedgeOfHalfPlanesInAnyOrderIsTheSame) {
  std::vector<Nef2> sides;
  for (const Line2& l : {line(0, 0, 0, -1), line(0, 0, 1, 0), line(9, 0, 0, 9), line(0, 0, 2, -1),
                         line(0, 0, 0, -2)}) {
    sides.push_back(Nef2::half_plane(l, kClosed));
  }
  std::vector<std::size_t> order(sides.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Nef2 first = Nef2::whole();
  for (const Nef2& side : sides) first *= side;
  EXPECT_EQ(counts(first), (Counts{3, 3, 2}));
  EXPECT_EQ(first.area(), Rational(81) / 2);
  do {
    Nef2 all = Nef2::whole();
    Nef2 none;
    for (const std::size_t i : order) {
      all *= sides[i];
      none += !sides[i];
      expect_clean(all);
    }
    EXPECT_TRUE(all == first);
    EXPECT_TRUE(none == !first);
  } while (std::next_permutation(order.begin(), order.end()));
}

template <class Function>
void expect_bad_argument(const Function& function) {
  try {
    function();
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::BadArgument);
  }
}

TEST(Nef2, RefusesWhatIsNoSet) {
  expect_bad_argument([] { Nef2::half_plane(line(1, 1, 1, 1), kOpen); });
  expect_bad_argument([] { Nef2::half_plane(line(0, 0, 1, 1), point(5, 5), kOpen); });
  expect_bad_argument([] { Nef2::line(line(1, 1, 1, 1)); });
  expect_bad_argument([] { Nef2::ray(line(1, 1, 1, 1), kClosed); });
  expect_bad_argument([] { Line2::from_coefficients(0, 0, 1); });
  expect_bad_argument([] { Nef2::whole().shoot(point(0, 0), point(0, 0)); });
  expect_bad_argument([] { Nef2::whole().shoot_to_boundary(point(0, 0), point(0, 0)); });
  expect_bad_argument([] { Nef2::whole().transformed({1, 2, 0, 2, 4, 0}); });
  expect_bad_argument([] { Nef2::whole().with_marks({{1}, {}, {1}}); });
}

TEST(Nef2, RefusesCoordinatesThatAreNoNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Point2 p : {Point2{nan, 0}, Point2{0, infinity}, Point2{-infinity, nan}}) {
    const auto expect_not_finite = [](const auto& function) {
      try {
        function();
        ADD_FAILURE() << "not refused";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::NotFinite);
      }
    };
    const std::vector<Point2> points{{0, 0}, p, {1, 0}};
    expect_not_finite([&] { Nef2::whole().locate(p); });
    expect_not_finite([&] { Nef2::polygon(points); });
    expect_not_finite([&] { Nef2::polyline(points); });
  }
}

TEST(Nef2, AnyFunctionOfMarksIsApplied) {
  const auto a = polygon({kSquare}, kNonZero, kClosed);
  const auto b = half_plane(2, 0, 3, 5, kOpen);
  const auto two = either(a, b);
  const LineCells cells = cells_of(*two);
  const CellMarks in_a = marks_of(*a, cells);
  const CellMarks in_b = marks_of(*b, cells);
  for (int bits = 0; bits < 16; ++bits) {
    const MarkFunction f{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
    CellMarks expected(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) expected[c] = f(in_a[c], in_b[c]);
    Context context;
    EXPECT_EQ(difference(cells, {boolean_op(to_nef(*a), to_nef(*b), f, context), expected}), "");
  }
}

TEST(Nef2, UnionsOfNoneOneAndMany) {
  Context context;
  EXPECT_TRUE(union_of({}, context).is_empty());
  EXPECT_TRUE(intersection_of({}, context).is_whole());
  std::vector<Nef2> sets;
  Nef2 sum;
  Nef2 product = Nef2::whole();
  for (int i = 0; i < 13; ++i) {
    const std::vector<Point2> triangle{{i * 1.0, 0}, {i + 3.0, 0}, {i * 1.0, 3.0 + i % 3}};
    sets.push_back(i % 4 == 3 ? Nef2::half_plane(line(0, -1, 1, i), kOpen)
                              : Nef2::polygon(triangle, i % 2 == 0 ? kOpen : kClosed));
    sum += sets.back();
    product *= sets.back();
    EXPECT_TRUE(union_of(sets, context) == sum);
    EXPECT_TRUE(intersection_of(sets, context) == product);
  }
}

TEST(Nef2, ChainsOfOperationsNeverGrowNumbers) {
  Nef2 set = Nef2::whole();
  for (int i = 0; i < 60; ++i) {
    const Nef2 side = Nef2::half_plane(line(i, -i * i, i + 3, 7 - i), i % 2 == 0 ? kOpen : kClosed);
    set = i % 3 == 0 ? set ^ side : set * (side + set);
    expect_clean(set);
    for (const Crossing2& c : set.complex().points.crossings) {
      EXPECT_LT(std::max({c.a, c.b, c.c, c.d}), set.complex().points.inputs.size());
    }
    for (std::uint32_t p = 0; p < set.complex().points.inputs.size(); ++p) {
      EXPECT_TRUE(set.complex().points.inputs.is_double(p));
    }
  }
}

TEST(Nef2, AStopRequestIsHonouredAndChangesNothing) {
  const Nef2 a = Nef2::half_plane(line(0, 0, 1, 0), kClosed);
  const Nef2 b = Nef2::half_plane(line(0, 0, 0, 1), kClosed);
  std::stop_source stop;
  stop.request_stop();
  Context context({}, stop.get_token());
  EXPECT_THROW(boolean_op(a, b, kUnion, context), Error);
  expect_clean(a);
  EXPECT_TRUE(a == Nef2::half_plane(line(0, 0, 1, 0), kClosed));
}

/// Sets whose elements hang together in the same way: what tells them apart is where they lie.
TEST(Nef2, AreEqualWhereNothingIsBetween) {
  std::vector<Nef2> sets;
  for (const Line2& l : {line(0, 0, 1, 0), line(0, 1, 1, 1), line(2, 0, 3, 0), line(0, 0, 1, 1),
                         line(0, 0, 2, 2), line(1, 0, 2, 1), line(1, 0, 0, 0), line(0, 0, 0, 3)}) {
    for (const Boundary boundary : {kOpen, kClosed}) {
      sets.push_back(Nef2::half_plane(l, boundary));
      sets.push_back(Nef2::ray(l, boundary));
    }
    sets.push_back(Nef2::line(l));
    sets.push_back(Nef2::line(l) + Nef2::point(point(9, 5)));
  }
  for (const int x : {0, 1}) {
    const std::vector<Point2> triangle{{0, 0}, {4.0 + x, 1}, {2, 5}}, chain{{0, 0}, {1, 1.0 + x}};
    sets.push_back(Nef2::polygon(triangle));
    sets.push_back(Nef2::polyline(chain));
    sets.push_back(Nef2::point(point(x, 0)));
  }
  sets.push_back(Nef2::empty());
  sets.push_back(Nef2::whole());
  for (const Nef2& a : sets) {
    for (const Nef2& b : sets) EXPECT_EQ(a == b, (a ^ b).is_empty());
  }
}

}  // namespace
}  // namespace plumb::testing::nef2_test
