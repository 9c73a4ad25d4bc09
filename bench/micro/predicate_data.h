// Input for measuring predicates: tuples of points, random, nearly degenerate and exactly
// degenerate. Seeds are fixed; every program that measures sees the same data.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "plumb/predicates/point.h"

namespace plumb::bench {

enum class Family { Random, Near, Degenerate };

/// Small enough for the cache, large enough that branch predictors cannot learn it.
inline constexpr std::size_t kTuples = 4096;

template <class Point, std::size_t N>
using Tuples = std::vector<std::array<Point, N>>;

class PredicateData {
 public:
  Tuples<Point2, 3> orient2d(Family f) {
    return fill<Point2, 3>([&] {
      const Point2 p = point2(f), q = point2(f);
      const auto third = [&]() -> Point2 {
        if (f == Family::Random) return unit2();
        const double t = f == Family::Near ? unit() : integer(5);
        return {p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)};
      };
      return std::array<Point2, 3>{p, q, third()};
    });
  }

  Tuples<Point3, 4> orient3d(Family f) {
    return fill<Point3, 4>([&] {
      const Point3 p = point3(f), q = point3(f), r = point3(f);
      const auto fourth = [&]() -> Point3 {
        if (f == Family::Random) return unit3();
        const double s = f == Family::Near ? unit() : integer(3);
        const double t = f == Family::Near ? unit() : integer(3);
        return {p.x + s * (q.x - p.x) + t * (r.x - p.x), p.y + s * (q.y - p.y) + t * (r.y - p.y),
                p.z + s * (q.z - p.z) + t * (r.z - p.z)};
      };
      return std::array<Point3, 4>{p, q, r, fourth()};
    });
  }

  Tuples<Point2, 4> incircle(Family f) {
    return fill<Point2, 4>([&] {
      const Point2 center = point2(f);
      std::array<Point2, 4> tuple;
      for (Point2& p : tuple) p = f == Family::Random ? unit2() : around(center, f);
      return tuple;
    });
  }

  Tuples<Point3, 5> insphere(Family f) {
    return fill<Point3, 5>([&] {
      const Point3 center = point3(f);
      std::array<Point3, 5> tuple;
      for (Point3& p : tuple) p = f == Family::Random ? unit3() : around(center, f);
      return tuple;
    });
  }

 private:
  template <class Point, std::size_t N, class Make>
  static Tuples<Point, N> fill(Make make) {
    Tuples<Point, N> r(kTuples);
    for (auto& tuple : r) tuple = make();
    return r;
  }

  double unit() { return std::uniform_real_distribution<double>(0, 1)(rng_); }
  double integer(int bound) { return std::uniform_int_distribution<int>(-bound, bound)(rng_); }
  Point2 unit2() { return {unit(), unit()}; }
  Point3 unit3() { return {unit(), unit(), unit()}; }
  Point2 point2(Family f) {
    return f == Family::Degenerate ? Point2{integer(100), integer(100)} : unit2();
  }
  Point3 point3(Family f) {
    return f == Family::Degenerate ? Point3{integer(100), integer(100), integer(100)} : unit3();
  }

  /// On a circle: rounded, or a lattice point of x^2 + y^2 = 1105 (32 of them).
  Point2 around(const Point2& c, Family f) {
    if (f == Family::Near) {
      const double t = 6.283185307179586 * unit();
      return {c.x + 0.7 * std::cos(t), c.y + 0.7 * std::sin(t)};
    }
    for (;;) {
      const double x = integer(33), y = integer(33);
      if (x * x + y * y == 1105) return {c.x + x, c.y + y};
    }
  }

  /// On a sphere: rounded, or a lattice point of x^2 + y^2 + z^2 = 101 (168 of them).
  Point3 around(const Point3& c, Family f) {
    if (f == Family::Near) {
      const double z = 2 * unit() - 1, t = 6.283185307179586 * unit(), r = std::sqrt(1 - z * z);
      return {c.x + 0.7 * r * std::cos(t), c.y + 0.7 * r * std::sin(t), c.z + 0.7 * z};
    }
    for (;;) {
      const double x = integer(10), y = integer(10), z = integer(10);
      if (x * x + y * y + z * z == 101) return {c.x + x, c.y + y, c.z + z};
    }
  }

  std::mt19937_64 rng_{20240607};
};

}  // namespace plumb::bench
