// The same predicates on points with rational coordinates. Exact; a common denominator and
// integers, no filter: for readers, tests and output, not for inner loops. Signs as in
// input_predicates.h.
#pragma once

#include "plumb/predicates/rational.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/sign.h"

namespace plumb {

Sign orient2d(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c);
Sign cross_sign(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
                const RationalPoint2& d);
Sign orient3d(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
              const RationalPoint3& d);
Sign incircle(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
              const RationalPoint2& d);
Sign insphere(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
              const RationalPoint3& d, const RationalPoint3& e);

}  // namespace plumb
