// The predicates on input doubles.
//
// A predicate returns the exact sign of a determinant of its points' coordinates: for every finite
// double (subnormals, +-DBL_MAX, any spread of exponents), in whatever rounding mode and with
// flush-to-zero and denormals-are-zero set however the caller left them. Requires finite
// coordinates; nothing is checked here. No call throws (but std::bad_alloc, from the Big rung) and
// all are safe to call from several threads.
//
// The ladder, the same for all, every rung callable on its own:
//
//   Filter  rung::X_filter   input_filters.h  doubles; sign or Unsure
//   Small   rung::X_small    small_rung.h     doubles once more, for small integers; sign or Unsure
//   Exact   rung::X_exact    exact_rung.h     integers of fixed width; sign or Unsure
//   Big     rung::X_big      big_rung.h       GMP integers; always a sign
//
// Rungs that decide agree. The sign conventions are those of J. R. Shewchuk's predicates ("Adaptive
// Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", DCG 18, 1997).
#pragma once

#include "plumb/predicates/decompose.h"
#include "plumb/predicates/input_filters.h"
#include "plumb/predicates/point.h"
#include "plumb/predicates/rung_counters.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

namespace rung {

// Small: Unsure unless all coordinates are integers below 2^51 and the determinant's terms add up
// to no more than 2^52 in magnitude.
FilteredSign orient2d_small(const Point2& a, const Point2& b, const Point2& c);
FilteredSign cross_sign_small(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
FilteredSign orient3d_small(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
FilteredSign incircle_small(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
FilteredSign insphere_small(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                            const Point3& e);

// Exact: Unsure exactly when the coordinates, as integers on their common grid (orient2d,
// cross_sign, orient3d: one grid an axis), need more than kExactBits bits.
inline constexpr int kExactBits = 125;

FilteredSign orient2d_exact(const Point2& a, const Point2& b, const Point2& c);
FilteredSign cross_sign_exact(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
FilteredSign orient3d_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
/// The same of points on a grid that is known, a third of the cost where that has 61 bits at most.
FilteredSign orient3d_exact(const Grid& grid, const Point3& a, const Point3& b, const Point3& c,
                            const Point3& d);
FilteredSign incircle_exact(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
FilteredSign insphere_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                            const Point3& e);

Sign orient2d_big(const Point2& a, const Point2& b, const Point2& c);
Sign cross_sign_big(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign orient3d_big(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
Sign incircle_big(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign insphere_big(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                  const Point3& e);

// Small, Exact, then Big: what a predicate does when its filter is Unsure.
Sign orient2d_beyond_filter(const Point2& a, const Point2& b, const Point2& c);
Sign cross_sign_beyond_filter(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign orient3d_beyond_filter(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
Sign incircle_beyond_filter(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign insphere_beyond_filter(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                            const Point3& e);

}  // namespace rung

/// Positive when a, b, c turn left (lie counter-clockwise), Zero when they are on one line.
/// det [a-c; b-c]. A swap of two points flips the sign, a cyclic shift keeps it.
inline Sign orient2d(const Point2& a, const Point2& b, const Point2& c) {
  const FilteredSign s = rung::orient2d_filter(a, b, c);
  if (!is_decided(s)) [[unlikely]]
    return rung::orient2d_beyond_filter(a, b, c);
  return decide(Predicate::Orient2d, Rung::Filter, s);
}

/// Sign of the cross product (b - a) x (d - c): Positive when the direction of cd is to the left of
/// that of ab. A swap of a and b, of c and d, or of the two pairs flips the sign.
inline Sign cross_sign(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const FilteredSign s = rung::cross_sign_filter(a, b, c, d);
  if (!is_decided(s)) [[unlikely]]
    return rung::cross_sign_beyond_filter(a, b, c, d);
  return decide(Predicate::CrossSign, Rung::Filter, s);
}

/// Positive when d lies below the plane of a, b, c, "below" being the side from which they appear
/// clockwise; Zero when the four are on one plane. det [a-d; b-d; c-d]. A swap of two points flips
/// the sign.
inline Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const FilteredSign s = rung::orient3d_filter(a, b, c, d);
  if (!is_decided(s)) [[unlikely]]
    return rung::orient3d_beyond_filter(a, b, c, d);
  return decide(Predicate::Orient3d, Rung::Filter, s);
}

/// For a, b, c counter-clockwise: Positive when d lies inside their circle, Zero when on it. For a,
/// b, c clockwise the signs are swapped; for a, b, c on one line it is the sign of the determinant
/// below. det [a-d, |a-d|^2; b-d, |b-d|^2; c-d, |c-d|^2]. A swap of two points flips the sign.
inline Sign incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const FilteredSign s = rung::incircle_filter(a, b, c, d);
  if (!is_decided(s)) [[unlikely]]
    return rung::incircle_beyond_filter(a, b, c, d);
  return decide(Predicate::Incircle, Rung::Filter, s);
}

/// For orient3d(a, b, c, d) Positive: Positive when e lies inside the sphere of a, b, c, d, Zero
/// when on it. For orient3d Negative the signs are swapped; for Zero it is the sign of the
/// determinant det [a-e, |a-e|^2; ...; d-e, |d-e|^2]. A swap of two points flips the sign.
inline Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                     const Point3& e) {
  const FilteredSign s = rung::insphere_filter(a, b, c, d, e);
  if (!is_decided(s)) [[unlikely]]
    return rung::insphere_beyond_filter(a, b, c, d, e);
  return decide(Predicate::Insphere, Rung::Filter, s);
}

}  // namespace plumb
#pragma GCC visibility pop
