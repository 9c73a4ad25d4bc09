// The Small rung (internal): the filter's own evaluation, when it is exact.
//
// If all coordinates are integers below 2^51 and the computed permanent is at most 2^52, the
// evaluation makes no rounding error, in any rounding mode: differences of such integers are exact;
// every later intermediate is an integer that is either at most the permanent in magnitude, hence
// exact (the true permanent is below 2^53, the computed one having a relative error far below 1),
// or multiplied by an exact zero, hence without effect. So the sign of the determinant is its sign,
// zero included. This is what makes exactly degenerate small integers cheap.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "plumb/predicates/input_filters.h"
#include "plumb/predicates/sign.h"

namespace plumb::rung {

/// Are all values integers of [-2^51, 2^51)? Adding 1.5 * 2^52 rounds to an integer, in whatever
/// direction; subtracting it is exact. Comparing bits, not doubles, tells a subnormal from the zero
/// it is read as under DAZ; the sign bit is left out for -0.
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

/// The evaluation's sign if it is exact.
template <std::size_t N>
FilteredSign small_sign(const detail::Evaluation& e, const std::array<double, N>& values) {
  if (!(e.permanent <= 0x1p52) || !all_integers(values)) return FilteredSign::Unsure;
  return filtered(sign_of(e.det));
}

}  // namespace plumb::rung
