// Convex pieces rounded together: at doubles, disjoint, near, and unchanged if nothing must move.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "generate/plane_families.h"
#include "plumb/convex/plane_partition.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/plane/plane_points.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {
namespace {

using Points = std::vector<Point2>;

Rational area_of(const Nef2& set) { return marked_area(set.complex()).value_or(0); }

bool are_at_doubles(const Nef2& set) {
  const PlaneComplex& complex = set.complex();
  for (const std::uint32_t p : complex.vertex_point) {
    if (p >= complex.points.inputs.size() || !complex.points.inputs.is_double(p)) return false;
  }
  return true;
}

/// Whether the interiors of sets are disjoint: their areas add up to the area of their union.
bool are_disjoint(const std::vector<Nef2>& sets) {
  Rational sum = 0;
  for (const Nef2& set : sets) sum += area_of(set);
  return sum == area_of(union_of(sets));
}

/// Whether a ring of a piece turns right at a corner.
bool turns_right(const Nef2& piece) {
  const PlaneComplex& complex = piece.complex();
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    if (!complex.mark(FaceId(f))) continue;
    for (const std::vector<VertexId>& ring : face_rings(complex, FaceId(f))) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const auto at = [&](std::size_t k) {
          return exact(complex.points, complex.vertex_point[ring[k % ring.size()]]);
        };
        const RationalPoint2 a = at(i), b = at(i + 1), c = at(i + 2);
        if ((b.x - a.x) * (c.y - b.y) < (b.y - a.y) * (c.x - b.x)) return true;
      }
    }
  }
  return false;
}

std::vector<Nef2> rounded_one_by_one(const std::vector<Nef2>& pieces) {
  std::vector<Nef2> rounded;
  for (const Nef2& piece : pieces) rounded.push_back(round_to_doubles(piece).set);
  return rounded;
}

/// A star, turned and moved by rationals, so that no corner is at doubles.
Nef2 skew_star(std::uint64_t seed) {
  Dice dice(seed);
  AffineMap2 map;
  map.xx = Rational(1 + dice.below(5)) / 7;
  map.xy = Rational(dice.below(9)) / 11;
  map.yx = -Rational(dice.below(7)) / 13;
  map.yy = Rational(3) / 7;
  return Nef2::polygon(star_polygon(6 + dice.below(24), seed)).transformed(map);
}

TEST(RoundedPieces, are_disjoint_at_doubles_and_near) {
  std::size_t overlapping_one_by_one = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const Nef2 set = skew_star(seed);
    for (const PartitionMethod method : {PartitionMethod::Cuts, PartitionMethod::Diagonals}) {
      const PlanePieces exact = decompose(set, {method, seed % 2 == 0});
      const RoundedPieces rounded = round_to_doubles(exact.pieces);
      ASSERT_EQ(rounded.pieces.size(), exact.pieces.size());
      EXPECT_TRUE(are_disjoint(rounded.pieces));
      // Pieces that share borders leave no gaps: their union is as near to the set as each of them.
      const Nef2 moved = union_of(rounded.pieces) ^ set;
      EXPECT_LT(nearest_double(area_of(moved)), 1e-12);
      for (std::size_t i = 0; i < exact.pieces.size(); ++i) {
        EXPECT_TRUE(are_at_doubles(rounded.pieces[i]));
        EXPECT_LT(nearest_double(area_of(rounded.pieces[i] ^ exact.pieces[i])), 1e-12);
      }
      if (!are_disjoint(rounded_one_by_one(exact.pieces))) ++overlapping_one_by_one;
    }
  }
  EXPECT_GT(overlapping_one_by_one, 10U);  // The examples are such that this matters.
}

/// Diagonals end at corners, so neighbours bend no sides. Only rounding of the corners themselves
/// could make a side bend, and these pieces are far too thick for that.
TEST(RoundedPieces, of_diagonals_fit_corner_to_corner) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const PlanePieces exact = decompose(skew_star(seed), {PartitionMethod::Diagonals, true});
    const RoundedPieces rounded = round_to_doubles(exact.pieces);
    EXPECT_EQ(rounded.rounding.edges_bent, 0U);
    for (std::size_t i = 0; i < exact.pieces.size(); ++i) {
      EXPECT_LE(rounded.pieces[i].counts().vertices, exact.pieces[i].counts().vertices);
    }
  }
}

/// A cut that prolongs a side ends inside another side, hardly ever at doubles.
TEST(RoundedPieces, count_those_that_a_neighbour_bends) {
  std::size_t bent = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const PlanePieces exact = decompose(skew_star(seed), {PartitionMethod::Cuts, true});
    const RoundedPieces rounded = round_to_doubles(exact.pieces);
    std::size_t not_convex = 0;
    for (const Nef2& piece : rounded.pieces) not_convex += turns_right(piece) ? 1 : 0;
    EXPECT_EQ(rounded.not_convex, not_convex);
    bent += not_convex;
  }
  EXPECT_GT(bent, 0U);
}

TEST(RoundedPieces, at_doubles_stay_as_they_are) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const Nef2 set = Nef2::polygon(lattice_polygon(dice, 12, 8));
    const PlanePieces exact = decompose(set, {PartitionMethod::Diagonals, false});
    const RoundedPieces rounded = round_to_doubles(exact.pieces);
    EXPECT_EQ(rounded.not_convex, 0U);
    EXPECT_FALSE(rounded.rounding.is_changed());
    for (std::size_t i = 0; i < exact.pieces.size(); ++i) {
      EXPECT_TRUE(rounded.pieces[i] == exact.pieces[i].closure());
    }
  }
}

TEST(RoundedPieces, without_area_or_bound_stay_in_their_places) {
  const RationalPoint2 third{Rational(1) / 3, Rational(1) / 3};
  const std::vector<Nef2> pieces{Nef2::whole(), Nef2::point(third),
                                 Nef2::polygon(Points{{0, 0}, {1, 0}, {0, 1}}), Nef2::empty()};
  const RoundedPieces rounded = round_to_doubles(pieces);
  EXPECT_TRUE(rounded.pieces[0] == Nef2::whole());
  const Rational near_third = exact_rational(1.0 / 3);
  EXPECT_TRUE(rounded.pieces[1] == Nef2::point(RationalPoint2{near_third, near_third}));
  EXPECT_TRUE(rounded.pieces[2] == pieces[2]);
  EXPECT_TRUE(rounded.pieces[3].is_empty());
  EXPECT_TRUE(round_to_doubles(std::vector<Nef2>{}).pieces.empty());
}

TEST(RoundedPieces, tell_what_changed_in_pieces_without_area) {
  const Rational tiny = exact_rational(0x1p-80);
  PointTable2 ends;
  ends.push_back(1, 1);
  ends.push_back(1 + tiny, 1);
  const std::array<std::uint32_t, 2> corners{0, 1}, begin{0, 2};
  const std::vector<Nef2> pieces{Nef2::polylines(ends, corners, begin)};
  ASSERT_FALSE(pieces[0].is_empty());
  EXPECT_EQ(round_to_doubles(pieces).rounding, round_to_doubles(pieces[0]).report);
  EXPECT_TRUE(round_to_doubles(pieces).rounding.is_changed());
}

TEST(RoundedPieces, beyond_the_largest_double_are_refused) {
  AffineMap2 map;
  map.xx = exact_rational(1e300) * exact_rational(1e300);
  const Nef2 set = Nef2::polygon(Points{{0, 0}, {1, 0}, {0, 1}}).transformed(map);
  try {
    static_cast<void>(round_to_doubles(std::vector<Nef2>{set}));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::NumberOutOfRange);
  }
}

}  // namespace
}  // namespace plumb::testing
