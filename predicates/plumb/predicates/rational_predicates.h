// Predicates on points with rational coordinates. These predicates convert all coordinates to a
// common denominator and compute with integers, so every result is exact. These predicates have no
// filter and are therefore slow. They are meant for file readers, tests and output, but not for
// inner loops. The signs follow the same conventions as in input_predicates.h.
#pragma once

#include "plumb/predicates/rational.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the orientation of three points: Positive if a, b, c make a left turn, Negative if they
/// make a right turn, and Zero if they are collinear.
Sign orient2d(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c);
/// Returns the sign of the cross product (b - a) x (d - c).
Sign cross_sign(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
                const RationalPoint2& d);
/// Returns Positive if d lies below the plane of a, b, c, and Zero if the points are coplanar.
/// "Below" means on the side from which a, b, c appear clockwise.
Sign orient3d(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
              const RationalPoint3& d);
/// If a, b, c are in counter-clockwise order, the function returns Positive for a point d inside
/// their circle, and Zero for a point d on the circle. If a, b, c are in clockwise order, Positive
/// and Negative are exchanged.
Sign incircle(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
              const RationalPoint2& d);
/// Suppose that orient3d(a, b, c, d) is Positive. Then the function returns Positive if e lies
/// inside the sphere of a, b, c, d, and Zero if e lies on the sphere. If orient3d(a, b, c, d) is
/// Negative, the results Positive and Negative are exchanged.
Sign insphere(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
              const RationalPoint3& d, const RationalPoint3& e);

}  // namespace plumb
#pragma GCC visibility pop
