// Homogeneous points and lines of the plane in GMP integers, and the Exact rung of crossings,
// against rational numbers: Cramer's rule with divisions.
#include "plumb/predicates/plane/point2_exact.h"

#include <gtest/gtest.h>

#include <array>
#include <cfloat>
#include <optional>
#include <vector>

#include "testing/plumb/testing/dice.h"

namespace plumb::point2_exact_test {

using detail::Scratch2;
using detail::Triple;

RationalPoint2 value_of(const Triple& p) {
  return {detail::to_rational(p.x, p.w), detail::to_rational(p.y, p.w)};
}

Rational cross(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
               const RationalPoint2& d) {
  return (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
}

/// Where the lines a b and c d meet; none: they are parallel.
std::optional<RationalPoint2> meeting(const RationalPoint2& a, const RationalPoint2& b,
                                      const RationalPoint2& c, const RationalPoint2& d) {
  const Rational den = cross(a, b, c, d);
  if (den == 0) return {};
  const Rational t = cross(a, c, c, d) / den;
  return RationalPoint2{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

Sign order(const RationalPoint2& p, const RationalPoint2& q) {
  return sign_of(p.x != q.x ? p.x.compare(q.x) : p.y.compare(q.y));
}

TEST(Point2Exact, ADoubleHasTheLeastPowerOfTwoForW) {
  const double values[] = {0,       -0.0,     1,      -3,      0.75,      0x1p-1074,   -0x1p-1022,
                           DBL_MAX, -DBL_MAX, 0x1p53, -0x1p60, 0x1.8p-30, 0x1p-3 + 5.0};
  for (const double x : values) {
    for (const double y : values) {
      const Triple p = Scratch2::fresh().point(Point2{x, y});
      EXPECT_EQ(value_of(p), (RationalPoint2{Rational(x), Rational(y)}));
      EXPECT_EQ(mpz_sgn(p.w), 1);
      EXPECT_EQ(mpz_popcount(p.w), 1U);
      const bool is_least = mpz_cmp_si(p.w, 1) == 0 || mpz_odd_p(p.x) || mpz_odd_p(p.y);
      EXPECT_TRUE(is_least) << x << ", " << y;
    }
  }
}

TEST(Point2Exact, AFractionAndAPointOfATableAreThemselves) {
  const std::vector<RationalPoint2> given = {
      {Rational(1, 3), Rational(-2, 5)}, {0.5, -8}, {0, Rational(1, 7)}, {Rational(-9, 2), 0}};
  PointTable2 table;
  for (const RationalPoint2& p : given) table.push_back(p.x, p.y);
  for (std::uint32_t i = 0; i < given.size(); ++i) {
    Scratch2& scratch = Scratch2::fresh();
    for (const Triple& p : {scratch.point(given[i]), scratch.point(table, i)}) {
      EXPECT_EQ(value_of(p), given[i]);
      EXPECT_EQ(mpz_sgn(p.w), 1);
    }
  }
}

TEST(Point2Exact, JoinsAndMeetsAreThoseOfRationalNumbers) {
  testing::Dice dice(1);
  const auto coordinate = [&] { return Rational(dice.between(-2, 2), dice.between(1, 2)); };
  int parallel = 0, on_line = 0;
  for (int round = 0; round < 2000; ++round) {
    std::array<RationalPoint2, 5> p;
    PointTable2 table;
    for (RationalPoint2& q : p) {
      q = {coordinate(), coordinate()};
      table.push_back(q.x, q.y);
    }
    Scratch2& scratch = Scratch2::fresh();
    const Triple line = scratch.line(table, 0, 1), other = scratch.line(table, 2, 3);
    const Triple fifth = scratch.point(table, 4), at = scratch.cross(line, other);
    const Sign side = sign_of(cross(p[0], p[1], p[0], p[4]).sign());
    EXPECT_EQ(scratch.dot_sign(line, fifth), side);
    EXPECT_EQ(detail::sign_of_mpz(at.w), sign_of(cross(p[0], p[1], p[2], p[3]).sign()));
    on_line += side == Sign::Zero ? 1 : 0;
    const auto expected = meeting(p[0], p[1], p[2], p[3]);
    parallel += expected ? 0 : 1;
    if (!expected) continue;
    EXPECT_EQ(value_of(at), *expected);
    EXPECT_EQ(scratch.compare_xy(at, fifth), order(*expected, p[4]));
    EXPECT_EQ(scratch.compare_xy(fifth, at), order(p[4], *expected));
    const Crossing2 x{0, 1, 2, 3, 0, 0, 0};
    EXPECT_EQ(value_of(Scratch2::fresh().point(table, x)), *expected);
  }
  EXPECT_GT(parallel, 100);
  EXPECT_GT(on_line, 100);
}

TEST(Point2Exact, QuotientsHaveDenominatorsOfAnySign) {
  const auto integers = [] {
    std::vector<Integer> all;
    for (int i = -3; i <= 3; ++i) all.emplace_back(i);
    return all;
  }();
  Scratch2& scratch = Scratch2::fresh();
  for (const Integer& p : integers) {
    for (const Integer& pw : integers) {
      for (const Integer& q : integers) {
        for (const Integer& qw : integers) {
          if (pw.is_zero() || qw.is_zero()) continue;
          EXPECT_EQ(scratch.compare_quotients(p.mpz(), pw.mpz(), q.mpz(), qw.mpz()),
                    sign_of(Rational(p, pw).compare(Rational(q, qw))));
        }
      }
    }
  }
}

/// Coordinates on the limits of one and of two limbs, where widths that are too narrow overflow;
/// beyond them, and for fractions, the rung does not decide.
TEST(Point2Exact, TheExactRungIsRightUpToItsLimitsAndUnsureBeyond) {
  testing::Dice dice(2);
  for (const int bits : {4, 62, 63, 126, 127}) {
    const double top = std::ldexp(1, bits) - std::ldexp(1, bits - std::min(bits, 53));
    const auto coordinate = [&] {
      const double size[] = {0, 1, top, top, std::ldexp(1, bits - 1)};
      return (dice.below(2) == 0 ? 1 : -1) * size[dice.below(5)];
    };
    for (int round = 0; round < 300; ++round) {
      PointTable2 table;
      std::vector<RationalPoint2> p;
      table.push_back({1, top});  // sets the width of both grids
      table.push_back({top, 1});
      for (int i = 2; i < 8; ++i) table.push_back({coordinate(), coordinate()});
      for (std::uint32_t i = 0; i < 8; ++i) p.push_back(table.exact(i));
      const auto first = meeting(p[0], p[1], p[2], p[3]), second = meeting(p[0], p[1], p[4], p[5]);
      if (!first || !second || p[4] == p[5]) continue;
      const Crossing2 x{0, 1, 2, 3, 0, 0, 0}, y{0, 1, 4, 5, 0, 0, 0};
      const auto expect = [&](FilteredSign found, Sign wanted) {
        EXPECT_EQ(found, bits <= 126 ? filtered(wanted) : FilteredSign::Unsure) << bits;
      };
      expect(rung::compare_xy_exact(table, x, 6), order(*first, p[6]));
      expect(rung::compare_xy_exact(table, x, y), order(*first, *second));
      expect(rung::orient2d_exact(table, 4, 5, x), sign_of(cross(p[4], p[5], p[4], *first).sign()));
      table.push_back(Rational(1, 3), 0);
      EXPECT_EQ(rung::compare_xy_exact(table, x, 8), FilteredSign::Unsure);
      EXPECT_EQ(rung::orient2d_exact(table, 8, 4, x), FilteredSign::Unsure);
      EXPECT_EQ(rung::compare_xy_exact(table, x, {0, 1, 2, 8, 0, 0, 0}), FilteredSign::Unsure);
    }
  }
}

}  // namespace plumb::point2_exact_test
