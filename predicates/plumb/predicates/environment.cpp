#include "plumb/predicates/environment.h"

#include <bit>
#include <cfloat>
#include <cstdint>

#include "plumb/predicates/input_predicates.h"

namespace plumb {

namespace {

/// Returns v after it was written to memory and read again, so that no compiler evaluates a probe.
/// Results are compared by their bits, because under DAZ a comparison of doubles reads subnormal
/// numbers as zeros.
double opaque(double v) {
  volatile double memory = v;
  return memory;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(opaque(a)) == std::bit_cast<std::uint64_t>(opaque(b));
}

/// Whether a*b+c is computed as a fused multiply-add. In this case, (1 + 2^-52)(1 - 2^-52) - 1 is
/// -2^-104. If the product is rounded first, the result is 0 or -2^-53.
bool contracts() {
  const double a = opaque(1 + DBL_EPSILON), b = opaque(1 - DBL_EPSILON), c = opaque(-1.0);
  return same_bits(a * b + c, -0x1p-104);
}

/// Whether sums are reassociated, or kept with more bits. In double precision, 1 + 2^60 is rounded
/// to a multiple of 2^8 in every rounding mode, so (1 + 2^60) - 2^60 is 1 only in these two cases.
bool reassociates() {
  const double big = opaque(0x1p60), small = opaque(1.0);
  return same_bits((small + big) - big, 1.0);
}

bool rounds_to_nearest() {
  const double tiny = opaque(0x1p-60);
  return same_bits(opaque(1.0) + tiny, 1.0) && same_bits(opaque(1.0) - tiny, 1.0) &&
         same_bits(opaque(-1.0) - tiny, -1.0) && same_bits(opaque(-1.0) + tiny, -1.0);
}

bool flushes_to_zero() { return !same_bits(opaque(DBL_MIN) * opaque(0.5), 0x1p-1023); }

bool reads_denormals_as_zero() {
  const double denormal = opaque(0x1p-1074), scale = opaque(0x1p100);
  return !same_bits(denormal * scale, 0x1p-974);
}

bool check_orient2d() {
  // The example of L. Kettner et al., Classroom examples of robustness problems in geometric
  // computations, ESA 2004: points one ulp beside the diagonal.
  constexpr double u = 0x1p-53;
  return orient2d({0.5 + u, 0.5}, {12, 12}, {24, 24}) == Sign::Negative &&
         orient2d({0.5, 0.5 + u}, {12, 12}, {24, 24}) == Sign::Positive &&
         orient2d({0.5, 0.5}, {12, 12}, {24, 24}) == Sign::Zero &&
         orient2d({0x1p-1074, 0}, {0, 0x1p-1074}, {0, 0}) == Sign::Positive &&
         orient2d({DBL_MAX, -DBL_MAX}, {-DBL_MAX, DBL_MAX}, {0, 0x1p-1074}) == Sign::Negative;
}

bool check_orient3d() {
  const Point3 x{DBL_MAX, 0, 0}, y{0, 1, 0}, z{0, 0, 0x1p-1074}, o{0, 0, 0};
  return orient3d(x, y, z, o) == Sign::Positive && orient3d(y, x, z, o) == Sign::Negative &&
         orient3d({1, 1, 0}, {3, 3, 0}, {0, 0, 1}, {-7, -7, 9}) == Sign::Zero;
}

bool check_round() {
  const double u = 0x1p-52;
  const Point2 a{1, 0}, b{0, 1}, c{-1, 0};
  return incircle(a, b, c, {0, -1}) == Sign::Zero &&
         incircle(a, b, c, {0, -1 + u}) == Sign::Positive &&
         incircle(a, b, c, {0, -1 - u}) == Sign::Negative &&
         insphere({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}) == Sign::Zero &&
         insphere({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1 + u, 0}) ==
             orient3d({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0});
}

}  // namespace

SelfTestReport self_test() {
  SelfTestReport r;
  const auto fail_if = [&r](bool bad, const char* what) {
    if (bad) r.failures.emplace_back(what);
  };
  const auto note_if = [&r](bool seen, const char* what) {
    if (seen) r.notes.emplace_back(what);
  };
  fail_if(reassociates(), "sums are reassociated or kept in extended precision");
  fail_if(!check_orient2d(), "orient2d gives a wrong sign");
  fail_if(!check_orient3d(), "orient3d gives a wrong sign");
  fail_if(!check_round(), "incircle or insphere gives a wrong sign");
  note_if(!rounds_to_nearest(), "the rounding mode is not to nearest");
  note_if(flushes_to_zero(), "subnormal results are flushed to zero");
  note_if(reads_denormals_as_zero(), "subnormal operands are read as zero");
  note_if(contracts(), "a*b+c is contracted to a fused multiply-add");
  r.ok = r.failures.empty();
  return r;
}

}  // namespace plumb
