// Adversarial input for the predicates: tuples of N points of D coordinates, by family.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace plumb::test {

/// N points of D coordinates.
template <std::size_t N, std::size_t D>
using Tuple = std::array<std::array<double, D>, N>;

enum class Family {
  Kettner,     // an exactly degenerate tuple, one point moved by a few ulps
  Near,        // rounded points of a line, plane, circle, sphere
  LowZero,     // exactly degenerate, small integers
  FullZero,    // exactly degenerate, 53-bit integers
  Scaled,      // one of the above times 2^k, 200 <= |k| <= 1000
  Bits,        // any finite bit pattern
  Subnormal,   // degenerate or nearly so, in multiples of 2^-1074
  Special,     // zeros, extremes and powers of two in one tuple
  Translated,  // exactly degenerate, moved by a rounded translation
  Spread,      // coordinates of one tuple up to 130 binades apart
  Flush,       // differences around 2^-1022 beside large ones: what FTZ and DAZ change most
  kCount
};

/// Straight: N = D + 1 points of a line or plane. Round: N = D + 2 points of a circle or sphere.
enum class Shape { Straight, Round };

template <std::size_t N, std::size_t D>
class Cases {
 public:
  static constexpr Shape kShape = N == D + 1 ? Shape::Straight : Shape::Round;
  static_assert(N == D + 1 || N == D + 2);

  explicit Cases(std::uint64_t seed) : rng_(seed) {}

  Tuple<N, D> make(Family f) {
    Tuple<N, D> t = raw(f);
    std::shuffle(t.begin(), t.end(), rng_);
    for (auto& p : t) {
      for (double& v : p) v = finite(v);
    }
    return t;
  }

 private:
  Tuple<N, D> raw(Family f) {
    switch (f) {
      case Family::Kettner:
        return kettner();
      case Family::Near:
        return near();
      case Family::LowZero:
        return zero(100, 1);
      case Family::FullZero:
        return zero(std::int64_t{1} << 51, std::int64_t{1} << 38);
      case Family::Scaled:
        return scaled();
      case Family::Bits:
        return each([&] { return finite(std::bit_cast<double>(rng_())); });
      case Family::Subnormal:
        return subnormal();
      case Family::Special:
        return each([&] { return special(); });
      case Family::Translated:
        return translated();
      case Family::Spread:
        return spread();
      default:
        return flush();
    }
  }

  Tuple<N, D> kettner() {
    Tuple<N, D> t = zero(coin() ? 30 : std::int64_t{1} << 40, 1);
    for (auto& p : t) {
      for (double& v : p) v = v / 4 + 0.5;
    }
    for (double& v : t[rng_() % N]) v = moved(v, integer(4));
    return t;
  }

  Tuple<N, D> scaled() {
    const Family base = static_cast<Family>(rng_() % 4);
    const int k = static_cast<int>(integer(400)) + 600;
    Tuple<N, D> t = raw(base);
    for (auto& p : t) {
      for (double& v : p) v = std::ldexp(v, coin_ ? k : -k);
    }
    coin_ = !coin_;
    return t;
  }

  Tuple<N, D> subnormal() {
    Tuple<N, D> t = zero(coin() ? 20 : std::int64_t{1} << 30, 1);
    const bool exact = coin();
    for (auto& p : t) {
      for (double& v : p) v = (v + (exact ? 0 : static_cast<double>(integer(1)))) * 0x1p-1074;
    }
    return t;
  }

  Tuple<N, D> translated() {
    Tuple<N, D> t = zero(1000, 1);
    std::array<double, D> by;
    for (double& v : by) v = unit() * std::ldexp(1, static_cast<int>(integer(20)));
    for (auto& p : t) {
      for (std::size_t i = 0; i < D; ++i) p[i] += by[i];
    }
    return t;
  }

  Tuple<N, D> spread() {
    Tuple<N, D> t = coin() ? near() : each([&] { return unit(); });
    const int binades = coin() ? 20 : (coin() ? 60 : 130);
    for (auto& p : t) {
      if (!coin()) continue;
      for (double& v : p) v = std::ldexp(v, -static_cast<int>(rng_() % unsigned(binades)));
    }
    return t;
  }

  /// Terms that flushing changes are multiplied by up to M^(n-1), as in the derivation of F.
  Tuple<N, D> flush() {
    const double large = std::ldexp(1, static_cast<int>(rng_() % 340));
    return each([&] {
      if (rng_() % 3 == 0) return large * static_cast<double>(integer(2));
      return static_cast<double>(integer(std::int64_t{1} << 53)) * 0x1p-1074;
    });
  }

  /// Integer points of a line or plane through lattice steps, of a circle or sphere of integers.
  Tuple<N, D> zero(std::int64_t position, std::int64_t step) {
    const std::array<double, D> origin = lattice(position);
    const double scale = 1 + static_cast<double>(rng_() % static_cast<std::uint64_t>(step));
    Tuple<N, D> t;
    if constexpr (kShape == Shape::Straight) {
      std::array<std::array<double, D>, D - 1> steps;
      for (auto& s : steps) s = lattice(50);
      for (auto& p : t) p = combined(origin, steps, scale);
    } else {
      for (auto& p : t) p = around(origin, scale);
    }
    return t;
  }

  std::array<double, D> combined(std::array<double, D> p,
                                 const std::array<std::array<double, D>, D - 1>& steps,
                                 double scale) {
    for (const auto& s : steps) {
      const double times = scale * static_cast<double>(integer(6));
      for (std::size_t i = 0; i < D; ++i) p[i] += times * s[i];
    }
    return p;
  }

  /// x^2 + y^2 = 1105 has 32 lattice points, x^2 + y^2 + z^2 = 101 has 168.
  std::array<double, D> around(std::array<double, D> p, double scale) {
    const double wanted = D == 2 ? 1105 : 101;
    for (;;) {
      const std::array<double, D> v = lattice(D == 2 ? 33 : 10);
      double sum = 0;
      for (const double c : v) sum += c * c;
      if (sum != wanted) continue;
      for (std::size_t i = 0; i < D; ++i) p[i] += scale * v[i];
      return p;
    }
  }

  Tuple<N, D> near() {
    Tuple<N, D> t = each([&] { return unit(); });
    if constexpr (kShape == Shape::Straight) {
      std::array<double, D> last = t[0];
      for (std::size_t j = 1; j < D; ++j) {
        const double s = 2 * unit() - 0.5;
        for (std::size_t i = 0; i < D; ++i) last[i] += s * (t[j][i] - t[0][i]);
      }
      t[D] = last;
    } else {
      const std::array<double, D> center = t[0];
      for (auto& p : t) p = on_sphere(center, p);
    }
    return t;
  }

  static std::array<double, D> on_sphere(const std::array<double, D>& c, std::array<double, D> p) {
    double length = 0;
    for (double& v : p) v -= 0.5;
    for (const double v : p) length += v * v;
    length = std::sqrt(length) + DBL_MIN;
    for (std::size_t i = 0; i < D; ++i) p[i] = c[i] + 0.7 * p[i] / length;
    return p;
  }

  double special() {
    static constexpr std::array<double, 14> kValues = {
        0.0,      0x1p-1074, 0x1p-1073, 0x1.fffffffffffffp-1023, DBL_MIN, 0x1p-540,
        0x1p-341, 0x1p-53,   1.0,       0x1.0000000000001p0,     3.0,     0x1p340,
        0x1p512,  DBL_MAX};
    const double v = kValues[rng_() % kValues.size()];
    return coin() ? v : -v;
  }

  template <class Make>
  Tuple<N, D> each(Make make) {
    Tuple<N, D> t;
    for (auto& p : t) {
      for (double& v : p) v = make();
    }
    return t;
  }

  std::array<double, D> lattice(std::int64_t bound) {
    std::array<double, D> p;
    for (double& v : p) v = static_cast<double>(integer(bound));
    return p;
  }

  static double moved(double v, std::int64_t ulps) {
    for (; ulps > 0; --ulps) v = std::nextafter(v, DBL_MAX);
    for (; ulps < 0; ++ulps) v = std::nextafter(v, -DBL_MAX);
    return v;
  }

  static double finite(double v) {
    return std::isfinite(v) ? v : (std::signbit(v) ? -DBL_MAX : DBL_MAX);
  }

  std::int64_t integer(std::int64_t bound) {
    return std::uniform_int_distribution<std::int64_t>(-bound, bound)(rng_);
  }
  double unit() { return std::uniform_real_distribution<double>(0, 1)(rng_); }
  bool coin() { return rng_() % 2 == 0; }

  std::mt19937_64 rng_;
  bool coin_ = false;
};

}  // namespace plumb::test
