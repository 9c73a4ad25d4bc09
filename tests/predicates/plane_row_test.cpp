// Rows of planes in doubles against exact ones: they hold what they claim to hold, and fast_row
// serves every triangle whose plane doubles give closely.
#include "plumb/predicates/space/plane_row.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "float_environment.h"
#include "generate/space_cases.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/space/plane_table.h"
#include "space_oracle.h"

namespace plumb::plane_row_test {
namespace {

using cases::integer;
using cases::Random;
using cases::uniform;
using oracle::Int;
using Coefficients = std::array<Rational, 4>;

Rational power(int exponent) {
  const Integer p = Integer(1) << static_cast<unsigned>(std::abs(exponent));
  return exponent < 0 ? Rational(1, p) : Rational(p);
}

Rational largest_normal(const Coefficients& c) {
  return std::max({Rational(abs(c[0])), Rational(abs(c[1])), Rational(abs(c[2]))});
}

/// Half of the errors bound what the row is off by, for the canonical plane times some power of
/// two.
void expect_holds(const PlaneRow& row, const Coefficients& exact) {
  const double largest = std::max({std::fabs(row.n[0]), std::fabs(row.n[1]), std::fabs(row.n[2])});
  EXPECT_GE(largest, 0.5);
  EXPECT_LE(largest, 1);
  const double ratio = nearest_double(Rational(exact_rational(largest) / largest_normal(exact)));
  const Rational factor = power(static_cast<int>(std::lround(std::log2(ratio))));
  const auto off = [&](double value, const Rational& true_value) {
    return Rational(abs(Rational(exact_rational(value) - true_value * factor)) * 2);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LE(off(row.n[i], exact[i]), exact_rational(double(row.normal_error)));
  }
  EXPECT_GE(row.normal_error, 0x1p-48F);
  if (std::isfinite(row.offset_error)) {
    EXPECT_LE(off(row.d, exact[3]), exact_rational(double(row.offset_error)));
    EXPECT_LE(std::fabs(row.d), 0x1p900);
  }
}

/// What the law of fast_row is about.
struct Triangle {
  std::array<Point3, 3> at;
  Coefficients plane;            // not canonical
  std::array<Rational, 3> sums;  // of the two products' magnitudes in each component of the normal
  std::array<bool, 3> is_plain;  // is the component zero because each product has a zero factor?

  explicit Triangle(const std::array<Point3, 3>& corners) : at(corners) {
    std::array<std::array<Rational, 3>, 3> x;
    for (std::size_t i = 0; i < 3; ++i) {
      x[i] = {exact_rational(at[i].x), exact_rational(at[i].y), exact_rational(at[i].z)};
    }
    std::array<Rational, 3> u, v;
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = x[1][i] - x[0][i];
      v[i] = x[2][i] - x[0][i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const Rational left = u[j] * v[k], right = u[k] * v[j];
      plane[i] = left - right;
      sums[i] = abs(left) + abs(right);
      is_plain[i] = left == 0 && right == 0;
      plane[3] -= plane[i] * x[0][i];
    }
  }
  bool is_plane() const { return largest_normal(plane) != 0; }
  bool is_flipped() const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (plane[i] != 0) return plane[i] < 0;
    }
    return false;
  }
  /// Coordinates within the gate, normal and orientation to be had from doubles, with a factor of 2
  /// to spare against 2^-37 and 6 2^-52.
  bool is_close() const {
    for (const Point3& p : at) {
      if (std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) > 0x1p300) return false;
    }
    const Rational largest = largest_normal(plane);
    const Rational error = std::max({sums[0], sums[1], sums[2]}) * 12 * power(-52);
    if (largest < power(-500) || error > largest * power(-37)) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      if (plane[i] != 0) return abs(plane[i]) > error;
      if (!is_plain[i]) return false;
    }
    return false;
  }
  std::string text() const {
    std::ostringstream out;
    out << std::hexfloat;
    for (const Point3& p : at) out << " (" << p.x << " " << p.y << " " << p.z << ")";
    return out.str();
  }
};

void expect_fast_row(const Triangle& t, const testing_environment::Setting& mode, int& good) {
  SCOPED_TRACE(mode.name + t.text());
  FastRow fast;
  {
    const testing_environment::Scope scope(mode);
    fast = fast_row(t.at[0], t.at[1], t.at[2]);
  }
  EXPECT_TRUE(fast.is_good || !t.is_plane() || !t.is_close());
  if (!fast.is_good) return;
  ++good;
  ASSERT_TRUE(t.is_plane());
  EXPECT_EQ(fast.is_flipped, t.is_flipped());
  EXPECT_LE(fast.row.normal_error, 0x1p-35F);
  Coefficients canonical = t.plane;
  if (t.is_flipped()) {
    for (Rational& c : canonical) c = -c;
  }
  expect_holds(fast.row, canonical);
}

/// Three points of which the third is 2^-flat beside the line of the others, the axes in any order
/// and stretched.
Triangle sliver(Random& r, int flat, int stretch) {
  const auto any = [&] { return cases::uniform_point(r, 1); };
  using cases::operator+;
  const Point3 p = cases::scaled(any(), std::ldexp(1, integer(r, -3, 12))), u = any(), w = any();
  const Point3 beside = cases::scaled(w, std::ldexp(1, -integer(r, 0, flat)));
  std::array<Point3, 3> at = {p, p + u, p + cases::scaled(u, uniform(r, -2, 2)) + beside};
  const std::array<int, 3> up = {integer(r, -stretch, stretch), integer(r, -stretch, stretch),
                                 integer(r, -stretch, stretch)};
  const int turn = integer(r, 0, 2);
  for (Point3& x : at) {
    x = {std::ldexp(x.x, up[0]), std::ldexp(x.y, up[1]), std::ldexp(x.z, up[2])};
    if (turn == 1) x = {x.y, x.z, x.x};
    if (turn == 2) x = {x.z, x.x, x.y};
  }
  return Triangle(at);
}

/// Coordinates from few values: differences and products that are zero, and that only underflow to
/// it.
Triangle from_few(Random& r, const std::vector<double>& values) {
  const auto one = [&] {
    return values[static_cast<std::size_t>(integer(r, 0, static_cast<int>(values.size()) - 1))];
  };
  std::array<Point3, 3> at;
  for (Point3& p : at) {
    p.x = one();
    p.y = one();
    p.z = one();
  }
  return Triangle(at);
}

TEST(FastRow, HoldsThePlaneWhereItIsGood) {
  Random random(61);
  int good = 0;
  for (int i = 0; i < 6000 && !HasFailure(); ++i) {
    const auto& mode = testing_environment::kSettings[static_cast<std::size_t>(i) % 8];
    expect_fast_row(sliver(random, 4, 0), mode, good);
    expect_fast_row(sliver(random, 30, 0), mode, good);
    expect_fast_row(sliver(random, 12, 90), mode, good);
    expect_fast_row(from_few(random, {0, 1, 2, -1}), mode, good);
    expect_fast_row(from_few(random, {0, 1, 0x1p-560, 0x1p290, -0x1p-540}), mode, good);
    expect_fast_row(from_few(random, {0, 1, 0x1p-1074, 0x3p-1072, -0x1p-1021, 0x1p299}), mode,
                    good);
    expect_fast_row(from_few(random, {1, 0x1p1023, -0x1p1000, 0x1p300, 0x1p700}), mode, good);
  }
  EXPECT_GT(good, 12000);
}

/// Integers of any length, the offset with a power of two of its own.
TEST(ExactRow, HoldsThePlane) {
  Random random(62);
  const auto number = [&](int bits) {
    Integer x = 0;
    for (int i = 0; i <= bits / 30; ++i) x = (x << 30) + integer(random, 0, (1 << 30) - 1);
    x >>= static_cast<unsigned>(30 - bits % 30);
    return integer(random, 0, 1) == 0 ? x : Integer(-x);
  };
  for (int i = 0; i < 3000 && !HasFailure(); ++i) {
    const auto bits = [&] { return integer(random, 0, 3) == 0 ? 0 : integer(random, 0, 420); };
    const int reach = std::array{90, 200, 910, 1300}[static_cast<std::size_t>(i) % 4];
    Coefficients c = {number(bits()), number(bits()), number(bits()),
                      number(integer(random, 0, 60)) * power(integer(random, -reach, reach))};
    PlaneTable table;
    const OrientedPlane plane = table.intern(c[0], c[1], c[2], c[3]);
    const auto first = std::find_if(c.begin(), c.begin() + 3, [](const auto& x) { return x != 0; });
    ASSERT_EQ(plane.is_valid(), first != c.begin() + 3);
    if (!plane.is_valid()) continue;
    if (*first < 0) {
      for (Rational& x : c) x = -x;
    }
    const PlaneRow& row = table.row(plane.plane());
    expect_holds(row, c);
    EXPECT_LE(row.normal_error, 0x1.001p-48F);
    const Rational offset = abs(Rational(c[3] / largest_normal(c)));
    if (offset > power(-100) && offset < power(100)) {
      EXPECT_LE(row.offset_error, 0x1.001p-48 * std::fabs(row.d) + 0x1p-126);
    }
  }
}

TEST(RoundedUp, IsNoLessAndHardlyMore) {
  for (const auto& mode : testing_environment::kSettings) {
    const testing_environment::Scope scope(mode);
    for (const double x : {0.0, 0x1p-1074, 0x1p-149, 0x1p-127, 0x1.0000001p-126, 1.0, 0x1.fffffep0,
                           0x1.ffffffp0, 0x1.0000010000001p50, 0x1.ffffp126}) {
      const float up = rounded_up(x);
      EXPECT_GE(ordered_key(double(up)), ordered_key(x)) << mode.name;
      EXPECT_GE(up, 0x1p-126F) << mode.name;
      EXPECT_LE(double(up), std::max(x * 1.00001, 0x1p-126)) << mode.name;
    }
    for (const double x : {0x1.fffffep127, 0x1p128, 0x1p900, 0x1p1023}) {
      EXPECT_TRUE(std::isinf(rounded_up(x))) << mode.name;
    }
  }
}

}  // namespace
}  // namespace plumb::plane_row_test
