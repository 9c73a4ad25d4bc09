// The common parts of the stages of the predicates on points of doubles after their filters.
// Internal.
//
// Integers of a fixed width: differences on a common grid, and determinants. With all differences
// |d| <= 2^b (2^bx, 2^by, 2^bz by axis), the exact values are bounded by
//
//   2 x 2 minor           <= 2^(2b+1)
//   lift of 2, 3 squares  <= 2^(2b+1), < 2^(2b+2)
//   3 x 3 minor           <  2^(3b+3)          6 terms
//   orient3d              <  2^(bx+by+bz+3)    6 terms
//   incircle              <  2^(4b+4)          12 terms of degree 4
//   insphere              <  2^(5b+7)          72 terms of degree 5
//
// and every partial sum by the same (docs/design/numbers.md, Fixed widths for input points). A
// Fixed<L> holds magnitudes below 2^(64L-1). The templates take their widths as parameters; each
// caller picks them by b and shows that they suffice.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/fixed.h"
#include "plumb/predicates/input/input_filters.h"
#include "plumb/predicates/rational.h"
#include "plumb/predicates/sign.h"

namespace plumb::rung {

/// The most bits of integers on a grid whose differences have one limb (|n| < 2^61, |d| <= 2^62),
/// or two (|n| < 2^125, |d| <= 2^126).
inline constexpr int kOneLimbBits = 61;
inline constexpr int kTwoLimbBits = 125;

/// Returns the least b, or one more, such that |d| <= 2^b for every d in `differences`.
template <std::size_t N>
int magnitude_bits(const std::array<Fixed<1>, N>& differences) {
  std::uint64_t any = 0;
  for (const Fixed<1>& d : differences) {
    const auto v = static_cast<std::int64_t>(d.limb(0));
    any |= static_cast<std::uint64_t>(v ^ (v >> 63));  // This is |v|, or |v| - 1 for a negative v.
  }
  return static_cast<int>(std::bit_width(any));
}

template <int L>
Fixed<L> on_grid(const Grid& grid, double value) {
  if constexpr (L == 1) {
    return Fixed<1>(grid.to_int64(value));
  } else {
    return grid.to_fixed<L>(value);
  }
}

/// Returns one coordinate of N points, minus the same coordinate of an origin, on `grid`.
template <int L, std::size_t N>
std::array<Fixed<L>, N> differences(const Grid& grid, const std::array<double, N>& values,
                                    double origin) {
  const Fixed<L> o = on_grid<L>(grid, origin);
  std::array<Fixed<L>, N> r;
  for (std::size_t i = 0; i < N; ++i) r[i] = on_grid<L>(grid, values[i]) - o;
  return r;
}

/// Returns x0 y1 - x1 y0.
template <int To, int L>
Fixed<To> minor2(const Fixed<L>& x0, const Fixed<L>& y0, const Fixed<L>& x1, const Fixed<L>& y1) {
  return multiply_to<To>(x0, y1) - multiply_to<To>(x1, y0);
}

/// Returns the 2 x 2 minors of rows (1,2), (2,0), (0,1) of two columns.
template <int To, int L>
std::array<Fixed<To>, 3> cyclic_minors(const std::array<Fixed<L>, 3>& x,
                                       const std::array<Fixed<L>, 3>& y) {
  return {minor2<To>(x[1], y[1], x[2], y[2]), minor2<To>(x[2], y[2], x[0], y[0]),
          minor2<To>(x[0], y[0], x[1], y[1])};
}

template <int To, int A, int B>
Fixed<To> dot(const std::array<Fixed<A>, 3>& u, const std::array<Fixed<B>, 3>& v) {
  return multiply_to<To>(u[0], v[0]) + multiply_to<To>(u[1], v[1]) + multiply_to<To>(u[2], v[2]);
}

template <int To, int L>
Fixed<To> square(const Fixed<L>& x) {
  return multiply_to<To>(x, x);
}

}  // namespace plumb::rung

// The last stage: determinants of integers of any size. Doubles come to it on their common grid,
// with up to 2098 bits, rationals over their common denominator.
namespace plumb::rung {

/// Returns the integer value / 2^grid.low().
Integer big_on_grid(const Grid& grid, double value);

/// Returns one coordinate of N points, minus the same coordinate of an origin.
template <std::size_t N>
std::array<Integer, N> big_differences(const std::array<double, N>& values, double origin,
                                       const Grid& grid) {
  const Integer o = big_on_grid(grid, origin);
  std::array<Integer, N> r;
  for (std::size_t i = 0; i < N; ++i) r[i] = big_on_grid(grid, values[i]) - o;
  return r;
}

/// Returns the sign of x[0] y[1] - x[1] y[0].
Sign big_cross(const std::array<Integer, 2>& x, const std::array<Integer, 2>& y);
/// Returns the sign of the determinant of three columns.
Sign big_orient3d(const std::array<Integer, 3>& x, const std::array<Integer, 3>& y,
                  const std::array<Integer, 3>& z);
/// Returns the sign of the determinant with the columns x, y and x^2 + y^2.
Sign big_incircle(const std::array<Integer, 3>& x, const std::array<Integer, 3>& y);
/// Returns the sign of the determinant with the columns x, y, z and x^2 + y^2 + z^2.
Sign big_insphere(const std::array<Integer, 4>& x, const std::array<Integer, 4>& y,
                  const std::array<Integer, 4>& z);

}  // namespace plumb::rung

// The stage of small integers: the evaluation of the filter, if it was exact.
//
// If all coordinates are integers below 2^51 and the computed permanent is at most 2^52, the
// evaluation makes no rounding error, in any rounding mode: differences of such integers are exact;
// every later intermediate is an integer that is either at most the permanent in magnitude, hence
// exact (the true permanent is below 2^53, the computed one having a relative error far below 1),
// or multiplied by an exact zero, hence without effect. So the sign of the determinant is its sign,
// zero included. Therefore degenerate inputs of small integers take little time.
namespace plumb::rung {

/// Whether all values are integers of [-2^51, 2^51). Adding 1.5 * 2^52 rounds to an integer, in
/// whatever direction; subtracting it is exact. Bits are compared and not doubles, because under
/// DAZ a subnormal number equals zero; the sign bit is left out for -0.
template <std::size_t N>
bool all_integers(const std::array<double, N>& values) {
  constexpr double kMagic = 0x1.8p52;
  std::uint64_t changed = 0, far = 0;
  for (const double v : values) {
    const double shifted = v + kMagic;
    changed |= std::bit_cast<std::uint64_t>(shifted - kMagic) ^ std::bit_cast<std::uint64_t>(v);
    far |= std::bit_cast<std::uint64_t>(shifted) ^ std::bit_cast<std::uint64_t>(kMagic);
  }
  return (changed << 1) == 0 && (far >> 52) == 0;
}

/// Returns the sign of the evaluation if it is exact, otherwise Unsure.
template <std::size_t N>
FilteredSign small_sign(const detail::Evaluation& e, const std::array<double, N>& values) {
  if (!(e.permanent <= 0x1p52) || !all_integers(values)) return FilteredSign::Unsure;
  return filtered(sign_of(e.det));
}

}  // namespace plumb::rung
