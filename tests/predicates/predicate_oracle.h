// The signs of the predicates' determinants by Boost cpp_int: Laplace expansion of the differences,
// sharing no code with the library. Requires the default floating-point environment.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "predicate_cases.h"

namespace plumb::test {

using Big = boost::multiprecision::cpp_int;
using Matrix = std::vector<std::vector<Big>>;

inline Big determinant(const Matrix& m) {
  if (m.size() == 1) return m[0][0];
  if (m.size() == 2) return m[0][0] * m[1][1] - m[0][1] * m[1][0];
  Big sum = 0;
  for (std::size_t row = 0; row < m.size(); ++row) {
    if (m[row].back().is_zero()) continue;
    Matrix minor;
    for (std::size_t i = 0; i < m.size(); ++i) {
      if (i != row) minor.emplace_back(m[i].begin(), m[i].end() - 1);
    }
    const Big term = m[row].back() * determinant(minor);
    (row + m.size()) % 2 == 1 ? sum += term : sum -= term;
  }
  return sum;
}

/// The least exponent e such that all coordinates are multiples of 2^e.
inline int unit_exponent(double v) {
  int e = 0;
  const auto m = static_cast<std::int64_t>(std::ldexp(std::frexp(v, &e), 53));
  return m == 0 ? 2000 : e - 53 + __builtin_ctzll(static_cast<unsigned long long>(m));
}

inline Big to_integer(double v, int unit) {
  int e = 0;
  const auto m = static_cast<std::int64_t>(std::ldexp(std::frexp(v, &e), 53));
  if (m == 0) return 0;
  const int shift = e - 53 - unit;
  return shift >= 0 ? Big(Big(m) << shift) : Big(m / (std::int64_t{1} << -shift));
}

/// The sign of det [p - last] for N = D + 1 points, of det [p - last, |p - last|^2] for D + 2.
template <std::size_t N, std::size_t D>
int oracle_sign(const Tuple<N, D>& t) {
  int unit = 2000;
  for (const auto& p : t) {
    for (const double v : p) unit = std::min(unit, unit_exponent(v));
  }
  Matrix m(N - 1);
  for (std::size_t i = 0; i + 1 < N; ++i) {
    Big lift = 0;
    for (std::size_t k = 0; k < D; ++k) {
      m[i].push_back(to_integer(t[i][k], unit) - to_integer(t[N - 1][k], unit));
      lift += m[i].back() * m[i].back();
    }
    if (N == D + 2) m[i].push_back(lift);
  }
  return determinant(m).sign();
}

}  // namespace plumb::test
