#include "plane_families.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string>

#include "plumb/predicates/rounding.h"

namespace plumb {

namespace {

constexpr double kMax = std::numeric_limits<double>::max();
constexpr double kLeast = std::numeric_limits<double>::denorm_min();

int integer(TestRandom& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}
double real(TestRandom& random) { return std::uniform_real_distribution<double>(-1, 1)(random); }

RationalPoint2 point(double x, double y) { return {exact_rational(x), exact_rational(y)}; }

template <class Coordinate>
EightPoints eight(Coordinate coordinate) {
  EightPoints points;
  for (int i = 0; i < 8; ++i) {
    const Rational x(coordinate());
    points.push_back({x, Rational(coordinate())});
  }
  return points;
}

template <class Coordinate>
EightPoints eight_doubles(Coordinate coordinate) {
  return eight([&] { return exact_rational(coordinate()); });
}

/// Moves a coordinate to a neighbouring double, sometimes.
void jiggle(TestRandom& random, Rational& v) {
  const int move = integer(random, -2, 2);
  const double d = nearest_double(v);
  if (move == -1) v = exact_rational(std::nextafter(d, -kMax));
  if (move == 1) v = exact_rational(std::nextafter(d, kMax));
}

void jiggle(TestRandom& random, EightPoints& points) {
  RationalPoint2& p = points[static_cast<std::size_t>(integer(random, 0, 7))];
  jiggle(random, integer(random, 0, 1) == 0 ? p.x : p.y);
}

void scale(EightPoints& points, int x_exponent, int y_exponent) {
  const auto power = [](int e) {
    return e < 0 ? Rational(1, Integer(1) << -e) : Rational(Integer(1) << e);
  };
  for (RationalPoint2& p : points) {
    p.x *= power(x_exponent);
    p.y *= power(y_exponent);
  }
}

EightPoints small_integers(TestRandom& random) {
  return eight_doubles([&] { return integer(random, -3, 3); });
}

EightPoints larger_integers(TestRandom& random) {
  return eight_doubles([&] { return integer(random, -1000000, 1000000); });
}

EightPoints full_mantissas(TestRandom& random) {
  return eight_doubles([&] { return real(random); });
}

/// Kettner et al.: a tiny grid of doubles around points of one line.
EightPoints near_line(TestRandom& random) {
  return eight_doubles(
      [&] { return 0.5 + 12 * integer(random, 0, 2) + integer(random, 0, 32) * 0x1p-53; });
}

/// Four lines through one point, each end as far as a double holds it exactly; then one ulp off.
EightPoints lines_through_a_point(TestRandom& random) {
  const double ox = integer(random, -5, 5), oy = integer(random, -5, 5);
  EightPoints points;
  for (int line = 0; line < 4; ++line) {
    const double u = std::ldexp(integer(random, -999, 999), integer(random, -20, 0));
    const double v = std::ldexp(integer(random, -999, 999), integer(random, -20, 0));
    const int m = integer(random, 1, 9), n = integer(random, -9, 9);
    points.push_back(point(ox - m * u, oy - m * v));
    points.push_back(point(ox + n * u, oy + n * v));
  }
  jiggle(random, points);
  return points;
}

EightPoints near_parallel(TestRandom& random) {
  const double u = real(random), v = real(random);
  EightPoints points;
  for (int line = 0; line < 4; ++line) {
    const double x = real(random), y = real(random);
    points.push_back(point(x, y));
    points.push_back(point(x + u, y + v));
    jiggle(random, points.back().x);
  }
  return points;
}

EightPoints near_equal(TestRandom& random) {
  const double x = real(random), y = real(random);
  EightPoints points = eight_doubles([] { return 0.0; });
  for (RationalPoint2& p : points) {
    p = point(x, y);
    jiggle(random, p.x);
    jiggle(random, p.y);
  }
  return points;
}

EightPoints scaled(TestRandom& random) {
  constexpr EightPoints (*kMakers[])(TestRandom&) = {small_integers, near_line, near_parallel,
                                                     lines_through_a_point};
  EightPoints points = kMakers[integer(random, 0, 3)](random);
  const int x = integer(random, 200, 900);
  const int y = integer(random, 200, 900);
  scale(points, integer(random, 0, 1) == 0 ? x : -x, integer(random, 0, 1) == 0 ? y : -y);
  return points;
}

EightPoints subnormals(TestRandom& random) {
  return eight_doubles([&] { return integer(random, -4, 4) * kLeast; });
}

EightPoints around_the_least_normal(TestRandom& random) {
  return eight_doubles([&] { return integer(random, -9, 9) * 0x1p-1024; });
}

EightPoints bit_patterns(TestRandom& random) {
  return eight_doubles([&] {
    double d = 0;
    do d = std::bit_cast<double>(random());
    while (!std::isfinite(d));
    return d;
  });
}

EightPoints extremes(TestRandom& random) {
  constexpr double kValues[] = {kMax,   -kMax,   0,         1,        -1,
                                kLeast, -kLeast, 0x1p-1022, kMax / 2, 0x1p1023};
  return eight_doubles([&] { return kValues[integer(random, 0, 9)]; });
}

/// Exponents spread over about the width of the fixed integers' tiers.
EightPoints spread(TestRandom& random) {
  const int range = integer(random, 1, 150);
  return eight_doubles([&] { return std::ldexp(real(random), integer(random, -range, 0)); });
}

/// The widest integers each tier admits: proves the widths of the Exact rung.
EightPoints tier_limits(TestRandom& random) {
  const int bits = (integer(random, 0, 1) == 0 ? 62 : 126) + integer(random, 0, 1);
  const double top = std::ldexp(1 - 0x1p-53, bits);
  const double values[] = {top, -top, 1, -1, 0, std::nextafter(top, 0), -std::ldexp(0.5, bits)};
  return eight_doubles([&] { return values[integer(random, 0, 6)]; });
}

EightPoints fractions(TestRandom& random) {
  return eight([&] { return Rational(integer(random, -9, 9), integer(random, 1, 4)); });
}

EightPoints long_fractions(TestRandom& random) {
  return eight([&] {
    return Rational(Integer(integer(random, -9999999, 9999999)) * integer(random, 1, 1 << 30),
                    integer(random, 1, 1 << 30));
  });
}

/// Each point a double with probability one half, else just beside one.
EightPoints beside_doubles(TestRandom& random) {
  EightPoints points = integer(random, 0, 1) == 0 ? near_line(random) : small_integers(random);
  for (RationalPoint2& p : points) {
    if (integer(random, 0, 1) == 0) continue;
    const Rational off(integer(random, -1, 1), Integer(1) << integer(random, 54, 3000));
    (integer(random, 0, 1) == 0 ? p.x : p.y) += off;
  }
  return points;
}

/// Fractions on common lines: every sign may be zero.
EightPoints lattice_of_thirds(TestRandom& random) {
  EightPoints points = lines_through_a_point(random);
  const Rational third(integer(random, 1, 3), 3);
  for (RationalPoint2& p : points) p = {p.x * third + third, p.y * third};
  return points;
}

EightPoints beyond_doubles(TestRandom& random) {
  return eight([&] {
    const Integer huge = Integer(1) << integer(random, 1000, 1300);
    const Rational v(huge * integer(random, -3, 3) + integer(random, -1, 1));
    return integer(random, 0, 1) == 0 ? v : Rational(integer(random, -3, 3), huge);
  });
}

EightPoints long_integers(TestRandom& random) {
  return eight(
      [&] { return Rational((Integer(integer(random, -3, 3)) << 53) + integer(random, -2, 2)); });
}

}  // namespace

const std::vector<PlaneFamily>& plane_families() {
  static const std::vector<PlaneFamily> families = {
      {"small integers", small_integers},
      {"larger integers", larger_integers},
      {"full mantissas", full_mantissas},
      {"near a line", near_line},
      {"lines through a point, one ulp off", lines_through_a_point},
      {"near-parallel lines", near_parallel},
      {"near-equal points", near_equal},
      {"scaled by powers of two", scaled},
      {"multiples of 2^-1074", subnormals},
      {"around the least normal", around_the_least_normal},
      {"bit patterns", bit_patterns},
      {"extremes", extremes},
      {"spread exponents", spread},
      {"limits of the fixed widths", tier_limits},
      {"fractions", fractions},
      {"long fractions", long_fractions},
      {"beside doubles", beside_doubles},
      {"thirds on common lines", lattice_of_thirds},
      {"beyond doubles", beyond_doubles},
      {"long integers", long_integers},
  };
  return families;
}

}  // namespace plumb
