// Numbers of MPFR that round as doubles do: 53 bits, and the exponent range of doubles.
//
// mpfr_subnormalize() uses the direction of a first rounding to 53 bits to round to subnormal
// numbers as if there had been only one rounding. The bits of the double are assembled from
// integers, because arithmetic on subnormal numbers would depend on FTZ and DAZ. Only sources
// include this header.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#define MPFR_USE_INTMAX_T
#include <mpfr.h>

namespace plumb {

constexpr std::uint64_t kSignBit = std::uint64_t{1} << 63;
constexpr int kFractionBits = 52;
constexpr std::uint64_t kHiddenBit = std::uint64_t{1} << kFractionBits;

/// Gives MPFR the exponent range of doubles during its lifetime, and restores range and flags.
/// (MPFR writes numbers as 0.1xxx * 2^e, so the least subnormal number 2^-1074 has e = -1073.)
class DoubleRange {
 public:
  DoubleRange() : emin_(mpfr_get_emin()), emax_(mpfr_get_emax()), flags_(mpfr_flags_save()) {
    mpfr_set_emin(-1073);
    mpfr_set_emax(1024);
  }
  ~DoubleRange() {
    mpfr_set_emin(emin_);
    mpfr_set_emax(emax_);
    mpfr_flags_restore(flags_, MPFR_FLAGS_ALL);
  }
  DoubleRange(const DoubleRange&) = delete;
  DoubleRange& operator=(const DoubleRange&) = delete;

 private:
  mpfr_exp_t emin_, emax_;
  mpfr_flags_t flags_;
};

/// A 53-bit number on the stack.
class Mpfr53 {
 public:
  Mpfr53() {
    mpfr_custom_init(limbs_, 53);
    mpfr_custom_init_set(value_, MPFR_ZERO_KIND, 0, 53, limbs_);
  }
  mpfr_ptr get() { return value_; }

 private:
  static constexpr std::size_t kLimbs = (53 + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS;
  mp_limb_t limbs_[kLimbs];
  mpfr_t value_;
};

/// Returns the bits of |v| as a double. Requires v = m * 2^(e - 53) with 2^52 <= m < 2^53 that a
/// double holds. A subnormal number counts units of 2^-1074, so it is m * 2^(e + 1021), and the
/// bits that are shifted out are zeros.
inline std::uint64_t magnitude_bits(mpfr_ptr v) {
  const auto e = mpfr_get_exp(v);
  mpfr_setsign(v, v, 0, MPFR_RNDN);
  mpfr_set_exp(v, 53);
  const std::uint64_t m = mpfr_get_uj(v, MPFR_RNDZ);
  if (e < -1021) return m >> (-1021 - e);
  return (static_cast<std::uint64_t>(e + 1022) << kFractionBits) | (m & (kHiddenBit - 1));
}

/// Returns v as a double. mpfr_get_d() would multiply doubles on its way to a subnormal number,
/// which FTZ makes wrong.
inline double to_double(mpfr_ptr v) {
  if (mpfr_zero_p(v)) return 0.0;
  const std::uint64_t sign = mpfr_signbit(v) ? kSignBit : 0;
  if (mpfr_inf_p(v)) {
    return std::bit_cast<double>(
        std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity()) | sign);
  }
  return std::bit_cast<double>(magnitude_bits(v) | sign);
}

}  // namespace plumb
