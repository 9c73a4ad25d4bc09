// Convex pieces of sets of the plane: convex, disjoint, together the set; as few as can be, or
// nearly.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <stop_token>
#include <string>
#include <vector>

#include "generate/plane_families.h"
#include "generate/plane_program.h"
#include "generate/test_share.h"
#include "oracle/nef2_check.h"
#include "oracle/partition_check.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::plane_partition_test {
namespace {

using Points = std::vector<Point2>;

constexpr std::array kMethods{PartitionMethod::Cuts, PartitionMethod::Diagonals,
                              PartitionMethod::Optimal, PartitionMethod::Best};

PlanePieces pieces_of(const Nef2& set, PartitionMethod method, bool closed = false) {
  Context context;
  return decompose(set, {method, closed}, context);
}
std::size_t count_of(const Nef2& set, PartitionMethod method) {
  return pieces_of(set, method).pieces.size();
}
std::string flaw(const Nef2& set, PartitionMethod method, bool closed) {
  return flaw_of_partition(set, pieces_of(set, method, closed), closed);
}
void expect_pieces(const Nef2& set, PartitionMethod method) {
  for (const bool closed : {false, true}) EXPECT_EQ(flaw(set, method, closed), "") << closed;
}

Nef2 polygon(const Points& points) { return Nef2::polygon(points); }
Nef2 box(double x, double y, double to_x, double to_y, Boundary boundary = Boundary::Closed) {
  const Points corners{{x, y}, {to_x, y}, {to_x, to_y}, {x, to_y}};
  return Nef2::polygon(corners, boundary);
}
Nef2 segment(Point2 a, Point2 b) { return Nef2::polyline(Points{a, b}); }
Nef2 line(Point2 a, Point2 b) { return Nef2::line({{a.x, a.y}, {b.x, b.y}}); }
Nef2 ray(Point2 a, Point2 b) { return Nef2::ray({{a.x, a.y}, {b.x, b.y}}, Boundary::Closed); }

// ---------------------------------------------------------------- what is known

struct Known {
  const char* name;
  Points corners;
  std::size_t fewest;  ///< by diagonals
};

const std::vector<Known> kKnown{
    {"triangle", {{0, 0}, {3, 0}, {0, 3}}, 1},
    {"flat corner", {{0, 0}, {1, 0}, {3, 0}, {0, 3}}, 1},
    {"L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 2},
    {"T", {{0, 1}, {1, 1}, {1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {0, 2}}, 2},
    {"plus",
     {{1, 0},
      {2, 0},
      {2, 1},
      {3, 1},
      {3, 2},
      {2, 2},
      {2, 3},
      {1, 3},
      {1, 2},
      {0, 2},
      {0, 1},
      {1, 1}},
     3},
    {"star of four tips",
     {{0, 3}, {-1, 1}, {-3, 0}, {-1, -1}, {0, -3}, {1, -1}, {3, 0}, {1, 1}},
     3},
    {"U", {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 3},
    {"two reflex corners on one line", {{0, 0}, {6, 0}, {6, 2}, {4, 1}, {2, 1}, {0, 2}}, 3},
};

TEST(PlanePartition, GivesTheFewestPiecesByDiagonals) {
  for (const Known& known : kKnown) {
    SCOPED_TRACE(known.name);
    const Nef2 set = polygon(known.corners);
    EXPECT_EQ(count_of(set, PartitionMethod::Optimal), known.fewest);
    EXPECT_EQ(fewest_pieces_by_diagonals(set.parts().polygons.front()), known.fewest);
    EXPECT_LE(count_of(set, PartitionMethod::Best), known.fewest);
    for (const PartitionMethod method : kMethods) expect_pieces(set, method);
  }
}

// ---------------------------------------------------------------- random polygons

void expect_bounds(const Nef2& set, std::size_t holes) {
  const std::size_t r = pieces_of(set, PartitionMethod::Cuts).reflex_corners;
  const std::size_t least = (r + 1) / 2 + 1 - std::min((r + 1) / 2, holes);
  EXPECT_LE(count_of(set, PartitionMethod::Cuts), r + 1 - holes);
  EXPECT_LE(count_of(set, PartitionMethod::Diagonals), 2 * r + 1 - holes);
  const std::size_t best = count_of(set, PartitionMethod::Best);
  EXPECT_LE(best, (holes == 0 ? 2 : 4) * least);
  EXPECT_GE(best, least);
}

TEST(PlanePartition, IsOptimalForSmallPolygons) {
  for (std::uint64_t seed = 0; seed < share_of(400); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const std::size_t corners = 4 + dice.below(8);
    const std::uint32_t size = 3 + dice.below(5);
    const Nef2 set = polygon(lattice_polygon(dice, corners, size));
    const std::size_t fewest = fewest_pieces_by_diagonals(set.parts().polygons.front());
    const std::size_t optimal = count_of(set, PartitionMethod::Optimal);
    ASSERT_EQ(optimal, fewest);
    const std::size_t diagonals = count_of(set, PartitionMethod::Diagonals);
    EXPECT_GE(diagonals, optimal);
    EXPECT_LE(diagonals, 4 * optimal);
    EXPECT_LE(count_of(set, PartitionMethod::Best), optimal);
    expect_bounds(set, 0);
    const PartitionMethod method = kMethods[seed % kMethods.size()];
    ASSERT_EQ(flaw(set, method, seed % 8 < 4), "");
  }
}

/// Maps keep lines: as many pieces of polygons with crossings for corners, wherever they lie.
TEST(PlanePartition, IsOptimalForImagesToo) {
  for (std::uint64_t seed = 0; seed < share_of(60); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed + 1000);
    const Nef2 set = polygon(lattice_polygon(dice, 14, 6));
    const std::size_t optimal = count_of(set, PartitionMethod::Optimal);
    AffineMap2 map;
    map.xx = Rational(1 + dice.below(5)) / 7;
    map.xy = Rational(dice.below(9)) - 4;
    map.yx = Rational(3) - Rational(dice.below(7));
    map.yy = map.xx + (map.xy * map.yx + 1) / map.xx;  // of determinant 1 and more
    EXPECT_EQ(count_of(set.transformed(map), PartitionMethod::Optimal), optimal);
    map.yx = -map.yx;
    map.yy = (map.xy * map.yx - 1) / map.xx;
    EXPECT_EQ(count_of(set.transformed(map), PartitionMethod::Optimal), optimal);
  }
}

TEST(PlanePartition, StaysNearTheFewestWithHoles) {
  const PolygonWithHoles2 two_holes{{{0, 0}, {7, 0}, {7, 3}, {0, 3}},
                                    {{{1, 1}, {1, 2}, {2, 1}}, {{4, 1}, {5, 2}, {6, 1}}}};
  std::vector<Nef2> sets;
  Nef2 set = box(0, 0, 7, 3);
  for (const auto& hole : two_holes.holes) {
    Points corners;
    for (const RationalPoint2& p : hole) {
      corners.push_back({p.x.convert_to<double>(), p.y.convert_to<double>()});
    }
    set -= Nef2::polygon(corners, Boundary::Open);
  }
  const std::size_t fewest = fewest_pieces_by_diagonals(two_holes);
  const std::size_t diagonals = count_of(set, PartitionMethod::Diagonals);
  EXPECT_GE(diagonals, fewest);
  EXPECT_LE(diagonals, 4 * fewest);
  EXPECT_LE(count_of(set, PartitionMethod::Best), diagonals);
  expect_bounds(set, 2);
  for (const PartitionMethod method :
       {PartitionMethod::Cuts, PartitionMethod::Diagonals, PartitionMethod::Best}) {
    expect_pieces(set, method);
  }
}

TEST(PlanePartition, OfManyHolesHasItsBounds) {
  for (std::uint64_t seed = 0; seed < share_of(40); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    Nef2 set = box(0, 0, 20, 20);
    std::size_t holes = 0;
    for (double x = 1; x < 19; x += 6) {
      for (double y = 1; y < 19; y += 6) {
        Points hole = lattice_polygon(dice, 3 + dice.below(4), 4);
        for (Point2& p : hole) p = {p.x + x, p.y + y};
        set -= Nef2::polygon(hole, Boundary::Open);
        ++holes;
      }
    }
    expect_bounds(set, holes);
    const PartitionMethod method = kMethods[seed % 2 == 0 ? 0 : 1];
    ASSERT_EQ(flaw(set, method, false), "");
  }
}

// ---------------------------------------------------------------- any set

struct Named {
  const char* name;
  Nef2 set;
  std::size_t pieces;  ///< by cuts; 0: not known
};

std::vector<Named> odd_sets() {
  const Nef2 square = box(0, 0, 4, 4);
  const Nef2 strip = line({0, 0}, {1, 0}) + line({0, 1}, {1, 1});
  const Nef2 cross = segment({-1, 0}, {1, 0}) + segment({0, -1}, {0, 1});
  return {
      {"empty", Nef2::empty(), 0},
      {"plane", Nef2::whole(), 1},
      {"half-plane", Nef2::half_plane({{0, 0}, {1, 3}}, Boundary::Open), 1},
      {"without a point", Nef2::whole() - Nef2::point({1, 2}), 2},
      {"without a segment", Nef2::whole() - segment({0, 0}, {3, 1}), 2},
      {"without a line", Nef2::whole() - line({0, 0}, {3, 1}), 2},
      {"without two parallel lines", !strip, 3},
      {"without a ray", Nef2::whole() - ray({0, 0}, {0, 1}), 2},
      {"without two parallel rays", Nef2::whole() - ray({0, 0}, {1, 0}) - ray({0, 1}, {1, 1}), 0},
      {"without opposite rays", Nef2::whole() - ray({1, 0}, {2, 0}) - ray({-1, 0}, {-2, 0}), 2},
      {"without a square", !square, 4},
      {"without an open square", !square.interior(), 4},
      {"without a triangle and a point", !polygon({{0, 0}, {3, 0}, {0, 3}}) - Nef2::point({5, 5}),
       0},
      {"a ring", square - box(1, 1, 2, 2), 4},
      {"a ring in a ring", box(-2, -2, 9, 9) - box(-1, -1, 8, 8) + (square - box(1, 1, 2, 2)), 8},
      {"square without its inner point", square - Nef2::point({1, 1}), 2},
      {"square with a slit", square - segment({1, 1}, {2, 3}), 2},
      {"square without a cross", square - cross.transformed({1, 0, 2, 0, 1, 2}), 4},
      {"slit from the side", square - segment({0, 0}, {2, 1}), 2},
      {"square without a corner", square - Nef2::point({0, 0}), 1},
      {"half-open square", square - segment({0, 0}, {4, 0}), 1},
      {"two that touch", square + box(4, 4, 6, 6), 2},
      {"hole that touches", square - polygon({{0, 0}, {2, 1}, {1, 2}}).interior(), 0},
      {"whiskers", square + segment({4, 4}, {7, 5}) + Nef2::point({9, 9}) + ray({0, 0}, {-1, -1}),
       4},
      {"a cross", cross, 4},
      {"a point", Nef2::point({Rational(1) / 3, 2}), 1},
      {"a line without a point", line({0, 0}, {1, 1}) - Nef2::point({2, 2}), 2},
      {"an angle of more than half a turn",
       !(Nef2::half_plane({{0, 0}, {1, 0}}, Boundary::Open) *
         Nef2::half_plane({{0, 0}, {0, -1}}, Boundary::Open)),
       2},
  };
}

TEST(PlanePartition, OfAnySet) {
  for (const Named& named : odd_sets()) {
    SCOPED_TRACE(named.name);
    for (const PartitionMethod method : {PartitionMethod::Cuts, PartitionMethod::Best}) {
      expect_pieces(named.set, method);
    }
    const std::size_t count = count_of(named.set, PartitionMethod::Cuts);
    if (named.pieces > 0) {
      EXPECT_EQ(count, named.pieces);
    }
    if (named.set.is_bounded()) expect_pieces(named.set, PartitionMethod::Diagonals);
  }
  EXPECT_EQ(count_of(Nef2::empty(), PartitionMethod::Best), 0U);
}

/// Weakly simple: the boundary runs along slits twice, and through points more than once.
TEST(PlanePartition, IsOptimalWhereTheBoundaryTouchesItself) {
  const Nef2 square = box(0, 0, 4, 4);
  EXPECT_EQ(count_of(square - segment({0, 0}, {2, 1}), PartitionMethod::Optimal), 3U);
  EXPECT_EQ(count_of(square - segment({0, 0}, {2, 2}), PartitionMethod::Optimal), 2U);
  const Nef2 touched = square - polygon({{0, 0}, {2, 1}, {1, 2}}).interior();
  EXPECT_EQ(count_of(touched, PartitionMethod::Optimal), 3U);
  const Nef2 fork =
      square - segment({0, 0}, {2, 2}) - segment({2, 2}, {3, 2}) - segment({2, 2}, {2, 3});
  for (const Nef2& set : {touched, fork, square - segment({0, 0}, {2, 1})}) {
    expect_pieces(set, PartitionMethod::Optimal);
  }
}

TEST(PlanePartition, RefusesWhatAMethodCannotDo) {
  const Nef2 ring = box(0, 0, 4, 4) - box(1, 1, 2, 2);
  EXPECT_THROW(count_of(ring, PartitionMethod::Optimal), Error);
  EXPECT_THROW(count_of(!ring, PartitionMethod::Optimal), Error);
  EXPECT_THROW(count_of(!ring, PartitionMethod::Diagonals), Error);
  EXPECT_THROW(
      count_of(polygon(star_polygon(kMostCornersForOptimal + 1, 1)), PartitionMethod::Optimal),
      Error);
}

TEST(PlanePartition, OfLargePolygonsEndsSoon) {
  Context context;
  const Nef2 star = polygon(star_polygon(kMostCornersForOptimal, 1));
  const PlanePieces optimal = pieces_of(star, PartitionMethod::Optimal);
  EXPECT_TRUE(do_areas_add_up(star, optimal.pieces, context).value());
  EXPECT_LE(optimal.pieces.size(), count_of(star, PartitionMethod::Diagonals));
  const Nef2 large = polygon(star_polygon(4000, 2));
  const PlanePieces best = pieces_of(large, PartitionMethod::Best);
  EXPECT_TRUE(do_areas_add_up(large, best.pieces, context).value());
  EXPECT_LE(best.pieces.size(), best.reflex_corners + 1);
}

// Memory of the work, and of pieces while they are made; time; a stop.
TEST(PlanePartition, LooksAtTheContext) {
  const Nef2 star = polygon(star_polygon(kMostCornersForOptimal, 1));
  const Nef2 large = polygon(star_polygon(4000, 2));
  for (const PartitionMethod method : kMethods) {
    const Nef2& set = method == PartitionMethod::Optimal ? star : large;
    Context small({.max_memory_bytes = 100'000});
    EXPECT_THROW(decompose(set, {method, false}, small), Error);
    Context enough({.max_memory_bytes = 40'000'000});
    EXPECT_NO_THROW(decompose(set, {method, false}, enough));
    EXPECT_NO_THROW(enough.charge_memory(40'000'000, "all of it was given back"));
    std::stop_source stop;
    stop.request_stop();
    Context stopped({}, stop.get_token());
    EXPECT_THROW(decompose(set, {method, false}, stopped), Error);
    Context short_of_time({.max_seconds = 1e-9});
    EXPECT_THROW(decompose(set, {method, false}, short_of_time), Error);
    EXPECT_THROW(do_areas_add_up(set, pieces_of(set, method).pieces, stopped), Error);
  }
}

// ---------------------------------------------------------------- random sets

TEST(PlanePartition, OfRandomExpressions) {
  EXPECT_TRUE(rc::check([] {
    const auto bytes =
        *rc::gen::container<std::vector<std::uint8_t>>(rc::gen::arbitrary<std::uint8_t>());
    const Nef2 set = to_nef(*set_of_program(bytes, 10));
    const auto method = *rc::gen::element(PartitionMethod::Cuts, PartitionMethod::Best);
    RC_ASSERT(flaw(set, method, *rc::gen::arbitrary<bool>()) == "");
  }));
  for (std::uint64_t seed = 0; seed < share_of(300); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto values = static_cast<ProgramValues>(dice.below(kProgramValues));
    const std::size_t records = 2 + dice.below(8);
    const Nef2 set = to_nef(*set_of_program(random_program(dice, values, records), 10));
    for (const PartitionMethod method : {PartitionMethod::Cuts, PartitionMethod::Best}) {
      ASSERT_EQ(flaw(set, method, seed % 2 == 1), "");
    }
  }
}

}  // namespace
}  // namespace plumb::testing::plane_partition_test
