// Elementary functions: each result is the double nearest to the exact value, which Boost computes
// with a hundred digits, without MPFR.
#include "plumb/predicates/arithmetic/elementary.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace plumb::elementary_test {
namespace {

using Real = boost::multiprecision::cpp_bin_float_100;

/// Expects that no neighbour of `found` is nearer to `exact`.
void expect_nearest(double found, const Real& exact, const char* what, double x) {
  const Real distance = abs(Real(found) - exact);
  for (const double end : {-INFINITY, INFINITY}) {
    EXPECT_LE(distance, abs(Real(std::nextafter(found, end)) - exact)) << what << " of " << x;
  }
}

void expect_right_angle_functions(double x) {
  expect_nearest(sine(x), sin(Real(x)), "sine", x);
  expect_nearest(cosine(x), cos(Real(x)), "cosine", x);
  expect_nearest(tangent(x), tan(Real(x)), "tangent", x);
  EXPECT_EQ(direction_at(x).x, cosine(x));
  EXPECT_EQ(direction_at(x).y, sine(x));
}

TEST(Elementary, FunctionsOfAnglesAreNearest) {
  std::vector<double> angles = {0, 1, -1, 0.5, 1e-8, -1e-8, 1e-300, 1e6, -12345.678};
  for (int i = 1; i < 64; ++i) {
    const double near = i * std::numbers::pi / 12;  // Sines near zero, one and one half.
    for (const double x : {near, std::nextafter(near, 0.), std::nextafter(near, 1000.)}) {
      angles.push_back(x);
      angles.push_back(-x);
    }
  }
  std::mt19937_64 rng(20261128);
  std::uniform_real_distribution<double> exponent(-40, 20), sign(-1, 1);
  for (int i = 0; i < 300; ++i) angles.push_back(std::exp2(exponent(rng)) * sign(rng));
  for (const double x : angles) expect_right_angle_functions(x);
}

TEST(Elementary, AnglesOfNumbersAreNearest) {
  std::mt19937_64 rng(1);
  std::uniform_real_distribution<double> number(-1, 1), exponent(-30, 30);
  for (int i = 0; i < 300; ++i) {
    const double x = number(rng), y = number(rng) * std::exp2(exponent(rng));
    expect_nearest(arc_cosine(x), acos(Real(x)), "arc cosine", x);
    expect_nearest(arc_tangent(y, x), atan2(Real(y), Real(x)), "arc tangent", y);
  }
  EXPECT_EQ(arc_cosine(1), 0);
  EXPECT_EQ(arc_cosine(-1), std::numbers::pi);
  EXPECT_EQ(arc_tangent(0, -1), std::numbers::pi);
  EXPECT_EQ(arc_tangent(1, 0), std::numbers::pi / 2);
  EXPECT_EQ(arc_tangent(0, 0), 0);
}

TEST(Elementary, SmallNumbersAreTheirOwnSines) {
  for (const double x : {0x1p-1074, 0x1p-1060, 0x1.8p-1022, 0x1p-500}) {
    EXPECT_EQ(sine(x), x);
    EXPECT_EQ(tangent(-x), -x);
    EXPECT_EQ(direction_at(x).y, x);
    EXPECT_EQ(cosine(x), 1);
    EXPECT_EQ(arc_tangent(x, 1), x);
  }
}

}  // namespace
}  // namespace plumb::elementary_test
