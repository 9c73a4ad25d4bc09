// The same predicates on points with rational coordinates. Exact; a common denominator and
// integers, no filter: for readers, tests and output, not for inner loops. Signs as in
// input_predicates.h.
#pragma once

#include "plumb/predicates/rational.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Positive for a left turn.
Sign orient2d(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c);
/// The sign of (b - a) x (d - c).
Sign cross_sign(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
                const RationalPoint2& d);
/// Positive when d is below the plane in which a, b, c look counter-clockwise from above.
Sign orient3d(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
              const RationalPoint3& d);
/// Positive inside, for a, b, c counter-clockwise.
Sign incircle(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
              const RationalPoint2& d);
/// Positive inside, for a, b, c, d positively oriented.
Sign insphere(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
              const RationalPoint3& d, const RationalPoint3& e);

}  // namespace plumb
#pragma GCC visibility pop
