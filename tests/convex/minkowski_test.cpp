// Minkowski sums: convex ones against the hull of all sums of two vertices, any against sums that a
// Boolean finds point by point; and the laws.
#include "plumb/convex/minkowski.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "generate/meshes.h"
#include "oracle/minkowski_check.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/space_audit.h"
#include "plumb/space/space_measure.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::minkowski_test {
namespace {

Nef3 sum(const Nef3& a, const Nef3& b) {
  Context context;
  return minkowski_sum(a, b, context);
}
Nef3 box(Point3 low, Point3 high) {
  Context context;
  return Nef3::from_mesh(box_mesh(low, high), {.rule = WindingRule::Positive}, context);
}
Nef3 translated(const Nef3& set, const RationalPoint3& by) {
  AffineMap3 map;
  for (std::size_t i = 0; i < 3; ++i) map.matrix[i][i] = 1;
  map.offset = {by.x, by.y, by.z};
  return set.transformed(map);
}

std::string flaw(const Nef3& set) {
  const auto found = audit(set.complex(), AuditForm::Minimal);
  return found ? found->invariant + " at " + found->place : std::string();
}

// ---------------------------------------------------------------- convex sets

RationalPoint3 lattice_point(Dice& dice, int size) {
  const auto x = dice.between(-size, size);
  const auto y = dice.between(-size, size);
  const auto z = dice.between(-size, size);
  return {x, y, z};
}
Nef3 lattice_segment(Dice& dice, int size) {
  const RationalPoint3 p = lattice_point(dice, size);
  const RationalPoint3 q = lattice_point(dice, size);
  return Nef3::segment(p, q);
}

/// A closed simplex of any dimension; few coordinates, so that edges and facets are often parallel.
Nef3 simplex(Dice& dice, std::size_t corners, int size) {
  std::vector<Point3> p;
  for (std::size_t i = 0; i < corners; ++i) {
    const RationalPoint3 at = lattice_point(dice, size);
    p.push_back({at.x.convert_to<double>(), at.y.convert_to<double>(), at.z.convert_to<double>()});
  }
  Context context;
  try {
    if (corners == 3) return Nef3::facet(p);
    return Nef3::from_mesh(make_mesh(p, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
                           {.rule = WindingRule::NonZero}, context);
  } catch (const Error&) {  // on a line
    return Nef3::point(lattice_point(dice, size));
  }
}

/// Never empty. `depth` bounds how long its numbers get.
Nef3 convex_set(Dice& dice, int depth) {
  switch (dice.below(depth > 0 ? 8U : 6U)) {
    case 0:
      return Nef3::point(lattice_point(dice, 3));
    case 1:
      return lattice_segment(dice, 2);
    case 2:
      return simplex(dice, 3, 2);
    case 3:
      return simplex(dice, 4, 2);
    case 4:
      return simplex(dice, 4, 5);
    case 5:
      return box({-1, -1, 0}, {1, 2, 1});
    case 6: {
      const Nef3 a = convex_set(dice, depth - 1);
      const Nef3 cut = a * convex_set(dice, depth - 1);
      return cut.is_empty() ? a : cut;
    }
    default: {
      const Nef3 a = convex_set(dice, depth - 1);
      return sum(a, lattice_segment(dice, 1));
    }
  }
}

/// Empty if `set` is the convex hull of all sums of two vertices: it is convex and holds them, and
/// its vertices are some of them.
std::string difference_from_hull(const Nef3& set, const Nef3& a, const Nef3& b) {
  if (!flaw(set).empty()) return flaw(set);
  if (!set.is_convex() || !set.is_closed()) return "not closed and convex";
  std::vector<RationalPoint3> sums;
  for (const RationalPoint3& p : vertices(a)) {
    for (const RationalPoint3& q : vertices(b)) sums.push_back(plus(p, q));
  }
  for (const RationalPoint3& p : sums) {
    if (!set.contains(p)) return "lacks a sum of vertices";
  }
  for (const RationalPoint3& v : vertices(set)) {
    if (std::find(sums.begin(), sums.end(), v) == sums.end())
      return "a vertex is no sum of vertices";
  }
  return {};
}

TEST(ConvexSum, IsTheHullOfAllSumsOfVertices) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Dice dice(seed);
    const Nef3 a = convex_set(dice, 2);
    const Nef3 b = convex_set(dice, 2);
    const Nef3 both = sum(a, b);
    RC_ASSERT(difference_from_hull(both, a, b) == "");
    RC_ASSERT(both == sum(b, a));
  }));
}

TEST(ConvexSum, OfSpheresIsTheHullToo) {
  Context context;
  const auto sphere = [&](int depth, double radius, Point3 centre) {
    return Nef3::from_mesh(icosphere_mesh(depth, radius, centre), {.rule = WindingRule::Positive},
                           context);
  };
  const Nef3 a = sphere(1, 1, {0, 0, 0}), b = sphere(1, 0.7, {0.1, 0.2, 0.3});
  EXPECT_EQ(difference_from_hull(sum(a, b), a, b), "");
  // Every facet has a parallel one, every edge too.
  EXPECT_EQ(difference_from_hull(sum(a, a), a, a), "");
  const AffineMap3 twice{{{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}, {0, 0, 0}};
  EXPECT_EQ(sum(a, a), a.transformed(twice));
}

TEST(ConvexSum, MayBeGreaterThanAllDoubles) {
  const Nef3 a = box({1e308, 1e308, 1e308}, {1.7e308, 1.7e308, 1.7e308});
  const AffineMap3 twice{{{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}}, {0, 0, 0}};
  EXPECT_EQ(sum(a, a), a.transformed(twice));
  EXPECT_EQ(sum(a, a.interior()), a.transformed(twice).interior());
}

TEST(ConvexSum, OfBoxesAddsTheirSides) {
  const Nef3 a = box({0, 0, 0}, {1, 2, 3}), b = box({-1, 0, 2}, {3, 1, 4});
  EXPECT_EQ(sum(a, b), box({-1, 0, 2}, {4, 3, 7}));
  // Steiner: V(A + sB) for a box and a segment: base area times length on top.
  const Nef3 up = Nef3::segment({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(marked_volume(sum(a, up).complex()), Rational(6 + 2 + 3 + 6));
}

// ---------------------------------------------------------------- any set

/// A convex set without some of its boundary: half-spaces of both kinds.
Nef3 half_open(const Nef3& convex, Dice& dice) {
  Nef3 result = convex;
  const std::vector<RationalPoint3> corner = vertices(convex);
  for (const RationalPoint3& v : corner) {
    if (dice.below(3) == 0) result -= Nef3::point(v);
  }
  const SpaceComplex& c = convex.complex();
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    if (dice.below(2) == 0) continue;
    const IntegerRow row = c.planes().coefficients(c.facet_plane[f]);
    const Plane3 plane{Rational(row[0]), Rational(row[1]), Rational(row[2]), Rational(row[3])};
    if (c.volume_count() > 1) result -= Nef3::plane(plane);
  }
  return result;
}

TEST(MinkowskiSum, OfHalfOpenConvexSetsHoldsTheirSums) {
  std::size_t used = 0;
  for (std::uint64_t seed = 0; used < 12 && seed < 100; ++seed) {
    Dice dice(seed);
    const Nef3 a = half_open(simplex(dice, 4, 2), dice);
    const Nef3 b = half_open(convex_set(dice, 0), dice);
    if (a.is_empty() || b.is_empty() || !a.is_convex() || !b.is_convex()) continue;
    ++used;
    const Nef3 both = sum(a, b);
    EXPECT_EQ(wrong_place(both, a, b, dice, 40), "") << "seed " << seed;
    EXPECT_TRUE(both.is_convex()) << "seed " << seed;
  }
  EXPECT_EQ(used, 12U);
}

TEST(MinkowskiSum, WithAnOpenOperandIsOpen) {
  const Nef3 a = box({0, 0, 0}, {1, 1, 1}), b = box({0, 0, 0}, {2, 1, 1});
  EXPECT_EQ(sum(a.interior(), b), sum(a, b).interior());
  EXPECT_EQ(sum(a.interior(), b.interior()), sum(a, b).interior());
  EXPECT_EQ(sum(a.interior(), Nef3::point({1, 1, 1})), translated(a, {1, 1, 1}).interior());
  EXPECT_EQ(sum(a.interior(), Nef3::segment({0, 0, 0}, {1, 0, 0})),
            box({0, 0, 0}, {2, 1, 1}).interior());
}

TEST(MinkowskiSum, LeavesAFacetOpenWhereEitherOperandIs) {
  const auto below = [](int a, int b, int c, int d, Boundary boundary) {
    return Nef3::half_space({a, b, c, d}, boundary);
  };
  const Nef3 cube = box({0, 0, 0}, {1, 1, 1});
  const Nef3 open_right = cube * below(1, 0, 0, -1, Boundary::Open);
  EXPECT_EQ(sum(open_right, cube), box({0, 0, 0}, {2, 2, 2}) * below(1, 0, 0, -2, Boundary::Open));
  // An edge of an open facet, and a facet in its direction: what the two span stays.
  const Nef3 with_edge = open_right + Nef3::segment({1, 0, 0}, {1, 0, 1});
  const Nef3 both = sum(with_edge, cube);
  EXPECT_TRUE(both.contains(RationalPoint3{2, 1, Rational(3, 2)}));
  EXPECT_FALSE(both.contains(RationalPoint3{2, Rational(3, 2), 1}));
}

/// Two of these make the operands.
std::vector<Nef3> not_convex() {
  Context context;
  const Nef3 block = box({0, 0, 0}, {2, 2, 1}) - box({1, 1, -1}, {3, 3, 2}).interior();
  const std::vector<RationalPoint3> bent{{0, 0, 0}, {2, 0, 0}, {2, 1, 1}};
  const Nef3 ring = box({0, 0, 0}, {3, 3, 1}) - box({1, 1, -1}, {2, 2, 2}).interior();
  return {block, block.interior(), Nef3::polyline(bent, context), ring,
          box({0, 0, 0}, {1, 1, 1}) + Nef3::segment({1, 1, 1}, {2, 2, 2}) + Nef3::point({3, 0, 0})};
}

TEST(MinkowskiSum, HoldsTheSumsOfAnyTwoSets) {
  const std::vector<Nef3> sets = not_convex();
  const Nef3 wedge = Nef3::intersection(std::vector<HalfSpace3>{{{1, 1, 1, -1}, Boundary::Closed},
                                                                {{-1, 0, 0, 0}, Boundary::Open},
                                                                {{0, -1, 0, 0}, Boundary::Closed},
                                                                {{0, 0, -1, 0}, Boundary::Closed}},
                                        *std::make_unique<Context>());
  for (std::size_t i = 0; i < sets.size(); ++i) {
    Dice dice(i);
    const Nef3& other = i % 2 == 0 ? sets[(i + 3) % sets.size()] : wedge;
    const Nef3 both = sum(sets[i], other);
    EXPECT_EQ(wrong_place(both, sets[i], other, dice, 40), "") << i;
    EXPECT_EQ(both.is_closed(), sets[i].is_closed() && other.is_closed()) << i;
  }
}

// Facets with a segment, a bent one, and one that ends at the rim taken out.
TEST(MinkowskiSum, KeepsSlitsOfFacets) {
  Context context;
  const Nef3 cube = box({0, 0, 0}, {2, 2, 2});
  const std::vector<RationalPoint3> bent{{Rational(1, 2), 1, 2}, {1, 1, 2}, {1, Rational(3, 2), 2}};
  const std::vector<RationalPoint3> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const Nef3 slit = Nef3::segment({Rational(1, 2), 1, 2}, {Rational(3, 2), 1, 2});
  const std::vector<Nef3> sets{cube - slit, cube - Nef3::polyline(bent, context),
                               cube - Nef3::segment({0, 1, 2}, {1, 1, 2}),
                               Nef3::facet(square) - Nef3::segment({1, 1, 0}, {2, 1, 0}),
                               cube - slit - Nef3::point({1, 1, 0})};
  for (const Nef3& set : sets) {
    EXPECT_EQ(sum(set, Nef3::point({0, 0, 0})), set);
    EXPECT_EQ(sum(set, Nef3::point({1, 2, 3})), translated(set, {1, 2, 3}));
    Dice dice(1);
    const Nef3 along = Nef3::segment({0, 0, 0}, {Rational(1, 4), 0, 0});
    EXPECT_EQ(wrong_place(sum(set, along), set, along, dice, 60), "");
  }
}

TEST(MinkowskiSum, ObeysItsLaws) {
  const std::vector<Nef3> sets = not_convex();
  const Nef3 cube = box({0, 0, 0}, {1, 1, 1}), slant = Nef3::segment({0, 0, 0}, {1, 2, 1});
  for (const Nef3& set : sets) {
    EXPECT_EQ(sum(set, Nef3::point({1, 2, 3})), translated(set, {1, 2, 3}));
    EXPECT_EQ(sum(set, slant), sum(slant, set));
  }
  EXPECT_EQ(sum(sets[0] + sets[2], cube), sum(sets[0], cube) + sum(sets[2], cube));
  EXPECT_EQ(sum(sum(sets[3], slant), cube), sum(sets[3], sum(slant, cube)));
}

TEST(MinkowskiSum, OfNothingIsNothing) {
  EXPECT_TRUE(sum(Nef3::empty(), box({0, 0, 0}, {1, 1, 1})).is_empty());
  EXPECT_TRUE(sum(Nef3::point({0, 0, 0}), Nef3::empty()).is_empty());
}

TEST(MinkowskiSum, RefusesWhatIsUnbounded) {
  EXPECT_THROW(sum(Nef3::whole(), Nef3::point({0, 0, 0})), Error);
  EXPECT_THROW(sum(Nef3::point({0, 0, 0}), Nef3::plane({1, 0, 0, 0})), Error);
}

TEST(PolyhedralBall, IsConvexAndAsWideAsItSays) {
  Context context;
  for (unsigned rounds = 0; rounds < 5; ++rounds) {
    const Nef3 ball = polyhedral_ball(2, rounds, context);
    EXPECT_TRUE(ball.is_convex());
    EXPECT_TRUE(ball.contains(Point3{0, 0, -2}));
    EXPECT_EQ(ball.counts().facets, std::size_t{8} << 2U * rounds);
  }
  EXPECT_THROW(polyhedral_ball(0, 1, context), Error);
  EXPECT_THROW(polyhedral_ball(1, 8, context), Error);
  EXPECT_EQ(polyhedral_ball(5e-324, 0, context).counts().facets, 8U);
  EXPECT_THROW(polyhedral_ball(5e-324, 1, context), Error);
  for (const double radius : {1e-270, 1e308}) {
    EXPECT_EQ(polyhedral_ball(radius, 2, context).counts().facets, 128U);
    EXPECT_TRUE(polyhedral_ball(radius, 2, context).is_convex());
  }
}

/// Sums of several sets, convex or not, are sums of two in any order.
TEST(Minkowski, AddsAnyNumberOfSets) {
  Context context;
  const std::vector<Nef3> sets{not_convex()[0], box({0, 0, 0}, {1, 2, 1}).interior(),
                               Nef3::segment({0, 0, 0}, {1, 1, 2})};
  const Nef3 all = minkowski_sum(sets, context);
  EXPECT_EQ(all, sum(sum(sets[2], sets[0]), sets[1]));
  EXPECT_EQ(all, sum(sets[0], sum(sets[1], sets[2])));
  EXPECT_EQ(minkowski_sum(std::span<const Nef3>(sets).first(1), context), sets[0]);
  EXPECT_EQ(minkowski_sum(std::span<const Nef3>(sets).first(0), context), Nef3::point({0, 0, 0}));
  const std::vector<Nef3> with_empty{Nef3::whole(), Nef3::empty(), sets[0]};
  EXPECT_TRUE(minkowski_sum(with_empty, context).is_empty());
}

TEST(Erosion, UndoesASumOfConvexSets) {
  Context context;
  const Nef3 a = box({0, 0, 0}, {3, 2, 2}), b = polyhedral_ball(1, 0, context);
  const Nef3 edge = Nef3::segment({0, 0, 0}, {1, 1, 2});
  EXPECT_EQ(minkowski_erosion(sum(a, edge), edge, context), a);
  EXPECT_TRUE(minkowski_erosion(b, a, context).is_empty());
  EXPECT_EQ(minkowski_erosion(!a, b, context), !sum(a, b));
  const Nef3 block = not_convex()[0], cube = box({0, 0, 0}, {0.5, 0.5, 0.5});
  EXPECT_EQ(minkowski_erosion(sum(a, cube).interior(), cube, context), a.interior());
  EXPECT_EQ(minkowski_erosion(block, cube, context),
            box({0, 0, 0}, {1.5, 1.5, 0.5}) - box({0.5, 0.5, -1}, {2, 2, 1}).interior());
  EXPECT_TRUE(minkowski_erosion(a, Nef3::empty(), context).is_whole());
}

}  // namespace
}  // namespace plumb::testing::minkowski_test
