// Weights from doubles with error bounds against exact arithmetic: whatever is certain is the
// nearest double, and in general position all is.
#include "plumb/space/set/line_weights.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "plumb/predicates/rational.h"
#include "plumb/predicates/rounding.h"
#include "plumb/testing/dice.h"

namespace plumb::line_weights_test {
namespace {

using testing::Dice;
using Exact = std::array<Rational, 3>;

Exact exact(const Point3& p) {
  return {exact_rational(p.x), exact_rational(p.y), exact_rational(p.z)};
}

Exact minus(const Exact& a, const Exact& b) {
  return {Rational(a[0] - b[0]), Rational(a[1] - b[1]), Rational(a[2] - b[2])};
}

/// Returns the determinant of the differences of three points from a fourth one.
Rational volume(const Point3& o, const Point3& p, const Point3& q, const Point3& r) {
  const Exact a = minus(exact(p), exact(o)), b = minus(exact(q), exact(o)),
              c = minus(exact(r), exact(o));
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// A line and a triangle whose plane it meets.
struct Scene {
  LineEnds line;
  TrianglePoints triangle;
};

/// Returns points whose coordinates are of a kind: any doubles, floats, or integers near 0.
Scene random_scene(Dice& dice, std::uint32_t kind) {
  const auto number = [&]() -> double {
    const auto bits = static_cast<double>(dice.between(-(std::int64_t{1} << 52), 1LL << 52));
    if (kind == 0) return std::ldexp(bits, -52);
    if (kind == 1) return static_cast<float>(std::ldexp(bits, -52));
    if (kind == 2) return static_cast<double>(dice.between(-3, 3));
    return std::ldexp(bits, static_cast<int>(dice.between(-130, 20)));
  };
  const auto point = [&] {
    const double x = number(), y = number(), z = number();
    return Point3{x, y, z};
  };
  Scene scene;
  for (Point3& p : scene.line) p = point();
  for (Point3& p : scene.triangle) p = point();
  return scene;
}

/// Checks that weights are the shares of exact numbers, rounded. Returns whether there are any.
template <std::size_t N>
bool expect_shares(const std::optional<std::array<double, N>>& weights,
                   const std::array<Rational, N>& parts) {
  if (!weights) return false;
  Rational whole = 0;
  for (const Rational& part : parts) whole += part;
  if (whole == 0) {
    ADD_FAILURE() << "the line does not meet the plane in one point";
    return true;
  }
  for (std::size_t i = 0; i < N; ++i) {
    EXPECT_GT((*weights)[i], 0);
    EXPECT_EQ((*weights)[i], nearest_double(Rational(parts[i] / whole)));
  }
  return true;
}

TEST(LineWeights, AreTheNearestDoubles) {
  for (std::uint32_t kind = 0; kind < 4; ++kind) {
    SCOPED_TRACE(kind);
    int inside = 0, found = 0;
    Dice dice(kind);
    for (int n = 0; n < 4000; ++n) {
      const auto [line, t] = random_scene(dice, kind);
      const auto& [a, b] = line;
      const Rational at_a = volume(t[0], t[1], t[2], a), at_b = volume(t[0], t[1], t[2], b);
      found += expect_shares(weights_on_line(line, t), std::array{at_b, Rational(-at_a)}) ? 1 : 0;
      inside += at_a * at_b < 0 ? 1 : 0;
      const std::array<Rational, 3> parts{volume(a, b, t[1], t[2]), volume(a, b, t[2], t[0]),
                                          volume(a, b, t[0], t[1])};
      found += expect_shares(weights_of_corners(t, line), parts) ? 1 : 0;
      const bool is_positive = parts[0] > 0 && parts[1] > 0 && parts[2] > 0;
      const bool is_negative = parts[0] < 0 && parts[1] < 0 && parts[2] < 0;
      inside += is_positive || is_negative ? 1 : 0;
    }
    EXPECT_GT(inside, 400);
    EXPECT_LE(found, inside);
    if (kind < 2) {
      EXPECT_GE(found, inside - 4) << "in general position the doubles suffice";
    }
  }
}

TEST(LineWeights, NearlyParallelLinesAreRightOrLeftOut) {
  Dice dice(7);
  int found = 0;
  for (int n = 0; n < 2000; ++n) {
    auto [line, t] = random_scene(dice, 0);
    for (Point3& p : line) p.z = t[0].z;
    t[1].z = t[2].z = t[0].z;
    const double step = std::ldexp(1, static_cast<int>(dice.between(-54, -30)));
    line[0].z += step;
    line[1].z -= step * static_cast<double>(dice.below(3));
    const std::array parts{volume(t[0], t[1], t[2], line[1]),
                           Rational(-volume(t[0], t[1], t[2], line[0]))};
    found += expect_shares(weights_on_line(line, t), parts) ? 1 : 0;
  }
  EXPECT_GT(found, 100);
}

TEST(LineWeights, AreNotGivenBeyondTheRangeOfTheirBounds) {
  const TrianglePoints t{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  EXPECT_TRUE(weights_of_corners(t, {{{0, 0, 0}, {1.1, 1.3, 1.7}}}).has_value());
  for (const double x : {0x1p70, 0x1p-70, 0x1p-1074, HUGE_VAL, std::nan("")}) {
    EXPECT_FALSE(weights_of_corners(t, {{{x, 0, 0}, {1.1, 1.3, 1.7}}}).has_value()) << x;
    EXPECT_FALSE(weights_on_line({{{0, 0, 0}, {1.1, 1.3, x}}}, t).has_value()) << x;
  }
}

}  // namespace
}  // namespace plumb::line_weights_test
