// The Big rung's shared parts (internal): the determinants over integers of any size. Doubles reach
// it on their common grid (up to 2098 bits), rationals over their common denominator.
#pragma once

#include <array>
#include <cstddef>

#include "plumb/predicates/decompose.h"
#include "plumb/predicates/rational.h"
#include "plumb/predicates/sign.h"

namespace plumb::rung {

/// The integer value / 2^grid.low().
Integer big_on_grid(const Grid& grid, double value);

/// One coordinate of N points minus that of an origin.
template <std::size_t N>
std::array<Integer, N> big_differences(const std::array<double, N>& values, double origin,
                                       const Grid& grid) {
  const Integer o = big_on_grid(grid, origin);
  std::array<Integer, N> r;
  for (std::size_t i = 0; i < N; ++i) r[i] = big_on_grid(grid, values[i]) - o;
  return r;
}

/// x[0] y[1] - x[1] y[0].
Sign big_cross(const std::array<Integer, 2>& x, const std::array<Integer, 2>& y);
/// The determinant of three columns.
Sign big_orient3d(const std::array<Integer, 3>& x, const std::array<Integer, 3>& y,
                  const std::array<Integer, 3>& z);
/// ... of x, y and x^2 + y^2.
Sign big_incircle(const std::array<Integer, 3>& x, const std::array<Integer, 3>& y);
/// ... of x, y, z and x^2 + y^2 + z^2.
Sign big_insphere(const std::array<Integer, 4>& x, const std::array<Integer, 4>& y,
                  const std::array<Integer, 4>& z);

}  // namespace plumb::rung
