// Where two segments meet, by rationals.
#pragma once

#include <optional>
#include <vector>

#include "plumb/testing/exact.h"

namespace plumb::testing {

/// Points with all coordinates multiplied by one common denominator.
struct IntegerPoint {
  BigInt x;
  BigInt y;
  friend bool operator==(const IntegerPoint&, const IntegerPoint&) = default;
};
bool operator<(const IntegerPoint& a, const IntegerPoint& b);

struct IntegerPoints {
  std::vector<IntegerPoint> points;
  BigInt denominator = 1;
};
IntegerPoints over_common_denominator(const std::vector<ExactPoint>& points);

/// (b - a) x (d - c)
BigInt cross(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c,
             const IntegerPoint& d);

/// The common points of two closed segments: nothing, one point (first == last) or a segment,
/// its ends in lexicographic order. Segments may have length zero.
struct Meeting {
  ExactPoint first;
  ExactPoint last;
};
std::optional<Meeting> meet(const IntegerPoint& p, const IntegerPoint& q, const IntegerPoint& r,
                            const IntegerPoint& s);

/// Order of directions b - a and d - c by angle in [0, 2 pi); both nonzero.
bool angle_less(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c,
                const IntegerPoint& d);

}  // namespace plumb::testing
