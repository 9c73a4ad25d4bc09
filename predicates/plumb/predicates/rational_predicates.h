// Predicates on points with rational coordinates. They bring all coordinates to a common
// denominator and evaluate in integers, without a filter, so every result is exact. They are meant
// for readers, tests and output, not for inner loops. The sign conventions are those of
// input_predicates.h.
#pragma once

#include "plumb/predicates/rational.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the orientation of three points: Positive if a, b, c make a left turn, Zero if they are
/// collinear.
Sign orient2d(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c);
/// Returns the sign of the cross product (b - a) x (d - c).
Sign cross_sign(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
                const RationalPoint2& d);
/// Returns Positive if d lies below the plane of a, b, c, where a, b, c appear counter-clockwise
/// from above; Zero if the points are coplanar.
Sign orient3d(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
              const RationalPoint3& d);
/// Returns Positive if d lies inside the circle of a, b, c, Zero if d lies on it, provided that a,
/// b, c are counter-clockwise. If they are clockwise, Positive and Negative are exchanged.
Sign incircle(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
              const RationalPoint2& d);
/// Returns Positive if e lies inside the sphere of a, b, c, d, Zero if e lies on it, provided that
/// orient3d(a, b, c, d) is Positive. If it is Negative, Positive and Negative are exchanged.
Sign insphere(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
              const RationalPoint3& d, const RationalPoint3& e);

}  // namespace plumb
#pragma GCC visibility pop
