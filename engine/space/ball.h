// Numbers known up to an error: what filters of constructed quantities compute with.
//
// eps = 2^-52, right in every rounding mode. kTiny pays for what flushing takes: an operand read as 0
// changes by less than 2^-1022, a result flushed to 0 by as much; an operand's error is at least
// kTiny, so a product with a flushed operand is within |other| * error too. kUp pays for the
// roundings of the error itself. Infinities and NaNs end in no sign.
#pragma once

#include <cmath>
#include <limits>

#include "plumb/predicates/sign.h"

namespace plumb {

/// |value - mid| <= error.
struct Ball {
  static constexpr double kEps = 0x1p-52;
  static constexpr double kUp = 1 + 0x1p-48;
  static constexpr double kTiny = 0x1p-1020;

  double mid = 0;
  double error = 0;

  static Ball about(double value, double radius = 0) { return {value, radius * kUp + kTiny}; }
  static Ball unknown() { return {0, std::numeric_limits<double>::infinity()}; }

  FilteredSign sign() const {
    if (mid > error) return FilteredSign::Positive;
    return mid < -error ? FilteredSign::Negative : FilteredSign::Unsure;
  }
  double upper() const { return mid + error + kEps * (std::fabs(mid) + error); }

  friend Ball operator-(Ball a) { return {-a.mid, a.error}; }
  friend Ball operator+(Ball a, Ball b) { return rounded(a.mid + b.mid, a.error + b.error); }
  friend Ball operator-(Ball a, Ball b) { return rounded(a.mid - b.mid, a.error + b.error); }
  friend Ball operator*(Ball a, Ball b) {
    return rounded(a.mid * b.mid,
                   std::fabs(a.mid) * b.error + std::fabs(b.mid) * a.error + a.error * b.error);
  }
  /// |a/b - m| <= (ea + |m| eb) / (|b| - eb) for the quotient m of the centres.
  friend Ball operator/(Ball a, Ball b) {
    if (!(b.error <= std::fabs(b.mid) / 2)) return unknown();
    const double m = a.mid / b.mid;
    return rounded(m, 2 * (a.error + std::fabs(m) * b.error) / std::fabs(b.mid));
  }

 private:
  static Ball rounded(double mid, double error) {
    return {mid, (error + kEps * std::fabs(mid) + kTiny) * kUp};
  }
};

}  // namespace plumb
