// Rounding to doubles and to grids: what it promises on random scenes (against brute force), and
// what it reports on small ones.

#include "plumb/plane/plane_rounding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include "generate/rounding_scenes.h"
#include "oracle/rounding_check.h"
#include "plumb/plane/arrangement.h"
#include "plumb/plane/plane_audit.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/plane/rounding/vertex_places.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::plane_rounding_test {
namespace {

using testing::Dice;

constexpr double kUlp = 0x1p-52;

/// Returns the number of random scenes; the environment may ask for more.
std::uint64_t scene_count() {
  const char* const asked = std::getenv("PLUMB_CASES");
  return asked == nullptr ? 400 : std::strtoull(asked, nullptr, 10);
}

std::uint64_t first_seed() {
  const char* const asked = std::getenv("PLUMB_FIRST");
  return asked == nullptr ? 0 : std::strtoull(asked, nullptr, 10);
}

Nef2 polygon(const std::vector<Point2>& corners) { return Nef2::polygon(corners); }

/// Returns a polygon with rational corners.
Nef2 exact_polygon(const std::vector<RationalPoint2>& corners) {
  PointTable2 points;
  std::vector<std::uint32_t> chain;
  for (const RationalPoint2& p : corners) {
    chain.push_back(static_cast<std::uint32_t>(points.size()));
    points.push_back(p.x, p.y);
  }
  const std::vector<std::uint32_t> begin{0, static_cast<std::uint32_t>(chain.size())};
  return Nef2::polygons(points, chain, begin, WindingRule::NonZero, Boundary::Closed);
}

void expect_valid(const RoundedSet& rounded) {
  EXPECT_EQ(testing::invalid_doubles(rounded.set.complex()), "");
  EXPECT_EQ(round_to_doubles(rounded.set).set, rounded.set);
}

// ---------------------------------------------------------------- random scenes

TEST(RoundToDoubles, keeps_its_promises_on_random_scenes) {
  const std::uint64_t first = first_seed(), count = scene_count();
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    Dice dice(seed);
    const std::vector<std::uint8_t> program =
        testing::random_rounding_program(dice, 2 + dice.below(9));
    const std::string wrong = testing::rounding_of_program_disagreement(program);
    ASSERT_EQ(wrong, "") << "seed " << seed;
  }
}

/// The result of each of several Booleans in a row is rounded, and stays within the sum of the
/// distances.
TEST(RoundToDoubles, stays_valid_from_operation_to_operation) {
  for (std::uint64_t seed = 0; seed < 15; ++seed) {
    Dice dice(seed);
    Nef2 set;
    for (int step = 0; step < 12; ++step) {
      std::vector<Point2> corners;
      for (int i = 0; i < 3; ++i) {
        corners.push_back({static_cast<double>(dice.between(0, 12)) * 0.1,
                           static_cast<double>(dice.between(0, 12)) * 0.7});
      }
      const RoundedSet rounded = round_to_doubles(set ^ polygon(corners));
      ASSERT_EQ(testing::invalid_doubles(rounded.set.complex()), "") << "seed " << seed;
      EXPECT_LE(rounded.report.largest_move, 4 * rounded.report.largest_ulp) << "seed " << seed;
      set = rounded.set;
    }
  }
}

TEST(RoundToDoubles, gives_the_same_whatever_the_order_of_the_input) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Dice dice(seed);
    const auto program = testing::random_rounding_program(dice, 6);
    std::vector<std::uint8_t> turned;
    for (std::size_t i = program.size(); i > 0; i -= testing::kRoundingRecord) {
      const auto record =
          program.begin() + static_cast<std::ptrdiff_t>(i - testing::kRoundingRecord);
      turned.insert(turned.end(), record, record + testing::kRoundingRecord);
    }
    PlaneComplex a = testing::rounding_scene(program), b = testing::rounding_scene(turned);
    ASSERT_EQ(a.face_count(), b.face_count());
    b.marks = a.marks;  // The same cells, in the same order.
    const Nef2 p = Nef2::from_complex(a).closure(), q = Nef2::from_complex(b).closure();
    ASSERT_EQ(p, q);
    EXPECT_EQ(round_to_doubles(p).set, round_to_doubles(q).set) << "seed " << seed;
    EXPECT_EQ(round_to_doubles(p).report, round_to_doubles(q).report) << "seed " << seed;
  }
}

/// Edges of length 14 whose ordinates are subnormals do not settle locally.
TEST(RoundToDoubles, snaps_all_vertices_if_a_repair_does_not_settle) {
  constexpr std::uint64_t kSeed = 200015800;
  Dice dice(kSeed);
  const PlaneComplex exact =
      testing::rounding_scene(testing::random_rounding_program(dice, 2 + dice.below(24)));
  const RoundedSubdivision rounded = round_to_doubles(exact);
  EXPECT_GT(rounded.report.vertices_moved, 0U);
  EXPECT_EQ(testing::invalid_doubles(rounded.complex), "");
  EXPECT_LE(rounded.report.largest_move, 258 * rounded.report.largest_ulp);
}

TEST(UlpOf, is_the_distance_to_the_next_double) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double x :
       {0.0, 5e-324, 1e-310, 0x1p-1022, 0x1p-1021, 1e-300, 1.0, 1.5, -3.0, 1e300}) {
    EXPECT_EQ(ulp_of(x), std::nextafter(std::fabs(x), kInfinity) - std::fabs(x)) << x;
  }
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(ulp_of(largest), largest - std::nextafter(largest, 0.0));
}

// ---------------------------------------------------------------- nothing to repair

TEST(RoundToDoubles, returns_sets_of_doubles_as_they_are) {
  const Nef2 set = polygon({{0, 0}, {0.1, 5e-324}, {1e300, 7}, {-3, 1e-300}});
  const RoundedSet rounded = round_to_doubles(set);
  EXPECT_EQ(rounded.set, set);
  EXPECT_FALSE(rounded.report.is_changed());
  EXPECT_EQ(rounded.report.largest_move, 0);
  EXPECT_TRUE(round_to_doubles(Nef2()).set.is_empty());
  EXPECT_TRUE(round_to_doubles(Nef2::whole()).set.is_whole());
  EXPECT_EQ(round_to_doubles(set.complement()).set, set.interior().complement());
}

TEST(RoundToDoubles, rounds_vertices_to_the_nearest_doubles) {
  const Rational third = Rational(1) / 3;
  const Nef2 set = exact_polygon({{third, third}, {5, third}, {third, 7}});
  const RoundedSet rounded = round_to_doubles(set);
  const double near = nearest_double(third);
  EXPECT_EQ(rounded.set, polygon({{near, near}, {5, near}, {near, 7}}));
  EXPECT_FALSE(rounded.report.is_changed());
  EXPECT_TRUE(rounded.report.is_faithful());
  EXPECT_LE(rounded.report.largest_move, rounded.report.largest_ulp / 2);
  EXPECT_EQ(rounded.report.largest_ulp, 4 * kUlp);
}

// ---------------------------------------------------------------- what is repaired

/// A spike whose sides round to one line: the ring would run up and back over itself.
TEST(RoundToDoubles, leaves_out_a_spike) {
  const double x = 1 + kUlp;
  const Nef2 a = polygon({{1, 0}, {3, 2}, {x, 3}, {x, 4}});
  const Nef2 b = polygon({{0, 1}, {2, 1}, {2, 2.5}, {0, 2.5}});
  const RoundedSet rounded = round_to_doubles(a + b);
  expect_valid(rounded);
  EXPECT_EQ(rounded.set, polygon({{0, 1}, {1, 1}, {1, 0}, {3, 2}, {x, 3}, {x, 2.5}, {0, 2.5}}));
  EXPECT_EQ(rounded.report.edges_folded, 1U);
  EXPECT_EQ(rounded.report.edges_bent, 1U);
  EXPECT_EQ(rounded.report.collapsed, 0U);
  EXPECT_LE(rounded.report.largest_move, kUlp);
}

TEST(RoundToDoubles, leaves_out_faces_that_collapse) {
  const Rational third = Rational(1) / 3, tiny = third + Rational(1) / (Integer(1) << 90);
  const RoundedSet rounded =
      round_to_doubles(exact_polygon({{third, third}, {tiny, third}, {third, tiny}}));
  EXPECT_TRUE(rounded.set.is_empty());
  EXPECT_EQ(rounded.report.collapsed, 1U);
  EXPECT_EQ(rounded.report.vertices_merged, 2U);
  EXPECT_TRUE(rounded.report.is_changed());
  EXPECT_FALSE(rounded.report.is_faithful());
}

TEST(RoundToDoubles, keeps_a_line_that_collapses_as_a_point) {
  const Rational third = Rational(1) / 3, next = third + Rational(1) / (Integer(1) << 90);
  PointTable2 points;
  points.push_back(third, third);
  points.push_back(next, third);
  const std::vector<std::uint32_t> chain{0, 1}, begin{0, 2};
  const RoundedSet rounded = round_to_doubles(Nef2::polylines(points, chain, begin));
  EXPECT_EQ(rounded.set, Nef2::point({exact_rational(nearest_double(third)),
                                      exact_rational(nearest_double(third))}));
  EXPECT_EQ(rounded.report.vertices_merged, 1U);
}

TEST(RoundToDoubles, leaves_out_what_is_unbounded) {
  const Nef2 half = Nef2::half_plane({{0, 0}, {1, 3}}, Boundary::Closed);
  const Nef2 box = polygon({{10, 0}, {12, 0}, {12, 2}, {10, 2}});
  EXPECT_TRUE(round_to_doubles(half).set.is_empty());
  const Nef2 both = Nef2::half_plane({{0, 0}, {0, 1}}, Boundary::Closed) + box;
  EXPECT_EQ(round_to_doubles(both).set, box);
  // A bounded hole of an unbounded face is not a part of the set.
  EXPECT_TRUE(round_to_doubles(half - polygon({{-20, 20}, {-22, 20}, {-21, 23}})).set.is_empty());
}

TEST(RoundToDoubles, refuses_coordinates_beyond_the_largest_double) {
  const Rational far = exact_rational(std::numeric_limits<double>::max()) * 2;
  try {
    static_cast<void>(round_to_doubles(exact_polygon({{0, 0}, {far, 0}, {0, 1}})));
    ADD_FAILURE() << "rounded";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::NumberOutOfRange);
  }
}

/// Cells of an overlay are rounded together: areas add up to that of the hull, exactly.
TEST(RoundToDoubles, keeps_a_coverage) {
  Dice dice(5);
  PointTable2 points;
  std::vector<SweepSegment> segments;
  const auto add = [&](Point2 p, Point2 q) {
    points.push_back(p);
    points.push_back(q);
    const auto n = static_cast<std::uint32_t>(points.size());
    segments.push_back({n - 2, n - 1});
  };
  add({0, 0}, {1, 0}), add({1, 0}, {1, 1}), add({1, 1}, {0, 1}), add({0, 1}, {0, 0});
  const auto on_side = [&dice] { return static_cast<double>(dice.between(1, 999)) / 1000; };
  for (int i = 0; i < 20; ++i) {
    add({0, on_side()}, {1, on_side()});
    add({on_side(), 0}, {on_side(), 1});
  }
  const Arrangement arrangement = arrange(points, segments);
  const RoundedSubdivision rounded = round_to_doubles(arrangement.complex);
  EXPECT_EQ(testing::invalid_doubles(rounded.complex), "");
  Rational sum = 0;
  for (std::size_t f = 1; f < rounded.complex.face_count(); ++f) {
    sum += *face_area(rounded.complex, FaceId(f));
  }
  EXPECT_EQ(sum, Rational(1));
  EXPECT_GT(rounded.complex.face_count(), 200U);
  EXPECT_LE(rounded.report.largest_move, 2 * kUlp);
}

// ---------------------------------------------------------------- grids

TEST(RoundToGrid, moves_each_point_by_half_a_step_at_most) {
  const Nef2 star = polygon({{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}});
  for (const Rational& step : {Rational(1), Rational(1) / 10, Rational(1) / 1000, Rational(3)}) {
    const RoundedSet rounded = round_to_grid(star, step);
    EXPECT_EQ(testing::invalid_doubles(rounded.set.complex()), "");
    EXPECT_LE(exact_rational(rounded.report.largest_move), step / 2 + Rational(kUlp * 16));
    const RoundedSet twice = round_to_grid(rounded.set, step);
    EXPECT_EQ(twice.set, rounded.set);
    for (const std::uint32_t p : rounded.set.complex().vertex_point) {
      const RationalPoint2 at = exact(rounded.set.complex().points, p);
      for (const Rational& c : {at.x, at.y}) {
        const Rational multiple = Rational(static_cast<int>(std::lround(nearest_double(c / step))));
        EXPECT_EQ(nearest_double(multiple * step), nearest_double(c)) << step.str();
      }
    }
  }
}

/// An edge that passes within half a step of a vertex is bent to it.
TEST(RoundToGrid, bends_edges_to_hot_pixels) {
  const Nef2 above = polygon({{0, 0}, {10, 3}, {5, 9}});
  const Nef2 touch = polygon({{4.2, 0.9}, {4.4, -3}, {7, -3}});
  const RoundedSet rounded = round_to_grid(above + touch, 1);
  EXPECT_EQ(testing::invalid_doubles(rounded.set.complex()), "");
  EXPECT_GT(rounded.report.edges_bent, 0U);
  EXPECT_TRUE(rounded.set.has_on_boundary({4, 1}));
}

TEST(RoundToGrid, refuses_steps_that_are_not_positive) {
  for (const int step : {0, -1}) {
    EXPECT_THROW(static_cast<void>(round_to_grid(Nef2(), step)), Error);
  }
}

TEST(HotPixels, contain_their_lower_and_left_sides) {
  const std::vector<RationalPoint2> at{{0, 0}, {8, 4}, {4, 1}, {6, 4}, {2, 0}};
  PlaneComplex complex;
  for (const RationalPoint2& p : at) {
    complex.points.inputs.push_back(p.x, p.y);
    complex.vertex_point.push_back(static_cast<std::uint32_t>(complex.vertex_point.size()));
  }
  const HotPixels pixels(complex, 2, unlimited_context());
  // Halves round up: 1 goes to 2.
  EXPECT_EQ(pixels.places()[pixels.pixel_of(VertexId(2))], (Point2{4, 2}));
  std::vector<std::uint32_t> route;
  pixels.route(VertexId(0), VertexId(1), route);
  std::vector<Point2> places;
  for (const std::uint32_t p : route) places.push_back(pixels.places()[p]);
  // y = x / 2 meets the pixel round (2, 0) from (1, 0.5) to (2, 1), its open upper side, and that
  // round (6, 4) from (6, 3), its closed lower side.
  EXPECT_EQ(places, (std::vector<Point2>{{0, 0}, {2, 0}, {4, 2}, {6, 4}, {8, 4}}));
}

}  // namespace
}  // namespace plumb::plane_rounding_test
