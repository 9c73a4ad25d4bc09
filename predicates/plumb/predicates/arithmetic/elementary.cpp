// Elementary functions by MPFR with 53 bits, which rounds each of them correctly.
//
// MPFR stores pi for each thread in which a function has needed it. A thread does not release this
// memory when it ends, so each call releases it. For the precision of doubles, computing pi takes
// less time than the function itself.
//
// Tested by tests/predicates/elementary_test.cpp.
#include "plumb/predicates/arithmetic/elementary.h"

#include <array>
#include <cstddef>

#include "plumb/predicates/arithmetic/mpfr53.h"

namespace plumb {
namespace {

/// Calls `function(result, direction of rounding)`, and returns its result as a double.
template <class Function>
double rounded_value(const Function& function) {
  const DoubleRange range;
  Mpfr53 result;
  const int inexact = function(result.get(), MPFR_RNDN);
  mpfr_subnormalize(result.get(), inexact, MPFR_RNDN);
  mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE);
  return to_double(result.get());
}

/// A double as a number for MPFR.
class Argument {
 public:
  explicit Argument(double x) { mpfr_set_d(number_.get(), x, MPFR_RNDN); }
  mpfr_srcptr get() { return number_.get(); }

 private:
  Mpfr53 number_;
};

}  // namespace

double sine(double angle) {
  Argument a(angle);
  return rounded_value([&](mpfr_ptr r, mpfr_rnd_t mode) { return mpfr_sin(r, a.get(), mode); });
}

double cosine(double angle) {
  Argument a(angle);
  return rounded_value([&](mpfr_ptr r, mpfr_rnd_t mode) { return mpfr_cos(r, a.get(), mode); });
}

Point2 direction_at(double angle) {
  Argument a(angle);
  Mpfr53 cosine;
  int of_cosine = 0;
  const double y = rounded_value([&](mpfr_ptr r, mpfr_rnd_t mode) {
    const int inexact = mpfr_sin_cos(r, cosine.get(), a.get(), mode);
    // The lower two bits belong to the sine, the next two bits to the cosine: 1 if the result is
    // above the exact value, 2 if it is below.
    constexpr std::array kDirection{0, 1, -1};
    of_cosine = kDirection[static_cast<std::size_t>(inexact >> 2)];
    return kDirection[static_cast<std::size_t>(inexact & 3)];
  });
  const DoubleRange range;
  mpfr_subnormalize(cosine.get(), of_cosine, MPFR_RNDN);
  return {to_double(cosine.get()), y};
}

double tangent(double angle) {
  Argument a(angle);
  return rounded_value([&](mpfr_ptr r, mpfr_rnd_t mode) { return mpfr_tan(r, a.get(), mode); });
}

double arc_cosine(double x) {
  Argument a(x);
  return rounded_value([&](mpfr_ptr r, mpfr_rnd_t mode) { return mpfr_acos(r, a.get(), mode); });
}

double arc_tangent(double y, double x) {
  Argument a(y), b(x);
  return rounded_value(
      [&](mpfr_ptr r, mpfr_rnd_t mode) { return mpfr_atan2(r, a.get(), b.get(), mode); });
}

}  // namespace plumb
