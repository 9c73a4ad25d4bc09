// Predicates on points with double coordinates.
//
// A predicate returns the exact sign of a determinant that is computed from the coordinates of its
// points. The sign is exact for all finite doubles, including subnormals, +-DBL_MAX and any spread
// of exponents. The sign is exact in every rounding mode. The sign is exact whether flush-to-zero
// and denormals-are-zero are on or off. Every function requires finite coordinates, but does not
// check that they are finite. The only exception that a function can throw is std::bad_alloc, and
// only the Big stage can throw it. Several threads may call all functions at the same time.
//
// Main flow of every predicate: the predicate runs the following stages in turn until a stage
// decides. Tests and benchmarks can also call each stage on its own, in namespace rung.
//  1. Filter  X_filter  (input_filters.h)  evaluates in doubles; returns a sign or Unsure
//  2. Small   X_small (determinants.h) evaluates in doubles again, and is exact if the coordinates
//                       are small integers; returns a sign or Unsure
//  3. Exact   X_exact   (determinants.h)   evaluates in integers of fixed width; returns a sign or
//                       Unsure
//  4. Big     X_big     (determinants.h)   evaluates in GMP integers; always returns a sign
//
// If several stages decide, they return the same sign. The page docs/design/numbers.md proves this.
// The signs follow the conventions of J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic
// and Fast Robust Geometric Predicates, Discrete & Computational Geometry 18 (1997).
#pragma once

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/input/input_filters.h"
#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/point.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

namespace rung {

// The Small stage decides under two conditions. All coordinates must be integers below 2^51 in
// magnitude. The magnitudes of the determinant's terms must have a sum of at most 2^52. Otherwise
// the stage returns Unsure.
FilteredSign orient2d_small(const Point2& a, const Point2& b, const Point2& c);
FilteredSign cross_sign_small(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
FilteredSign orient3d_small(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
FilteredSign incircle_small(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
FilteredSign insphere_small(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                            const Point3& e);

// The Exact stage converts the coordinates to integers on a common grid. (orient2d, cross_sign and
// orient3d use one grid for each axis.) The stage returns Unsure if and only if one of these
// integers needs more than kExactBits bits.

/// Largest number of bits of a grid integer that the Exact stage accepts.
inline constexpr int kExactBits = 125;

FilteredSign orient2d_exact(const Point2& a, const Point2& b, const Point2& c);
FilteredSign cross_sign_exact(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
FilteredSign orient3d_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
/// Does the same as the function above for points on the common grid `grid`. If the grid integers
/// have at most 61 bits, this function takes a third of the time of the function above.
FilteredSign orient3d_exact(const Grid& grid, const Point3& a, const Point3& b, const Point3& c,
                            const Point3& d);
FilteredSign incircle_exact(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
FilteredSign insphere_exact(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                            const Point3& e);

// The Big stage always decides.
Sign orient2d_big(const Point2& a, const Point2& b, const Point2& c);
Sign cross_sign_big(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign orient3d_big(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
Sign incircle_big(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign insphere_big(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                  const Point3& e);

// Each of the following functions runs the stages Small, Exact and Big in turn until a stage
// decides. A predicate calls its function if its filter returns Unsure.
Sign orient2d_beyond_filter(const Point2& a, const Point2& b, const Point2& c);
Sign cross_sign_beyond_filter(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign orient3d_beyond_filter(const Point3& a, const Point3& b, const Point3& c, const Point3& d);
Sign incircle_beyond_filter(const Point2& a, const Point2& b, const Point2& c, const Point2& d);
Sign insphere_beyond_filter(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                            const Point3& e);

}  // namespace rung

/// Returns the orientation of three points, which is the sign of det [a-c; b-c]. The orientation is
/// Positive if a, b, c make a left turn, that is, if they are in counter-clockwise order. It is
/// Negative if they make a right turn, and Zero if they are collinear. Swapping two points flips
/// the sign; a cyclic shift of the points does not change the sign.
inline Sign orient2d(const Point2& a, const Point2& b, const Point2& c) {
  const FilteredSign s = rung::orient2d_filter(a, b, c);
  if (!is_decided(s)) [[unlikely]]
    return rung::orient2d_beyond_filter(a, b, c);
  return decide(Predicate::Orient2d, Rung::Filter, s);
}

/// Returns the sign of the cross product (b - a) x (d - c). The sign is Positive if the vector from
/// c to d points to the left of the vector from a to b. The sign is Zero if the vectors are
/// parallel or one of the vectors is zero. The sign flips if a and b are swapped, if c and d are
/// swapped, or if the pair a, b is swapped with the pair c, d.
inline Sign cross_sign(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const FilteredSign s = rung::cross_sign_filter(a, b, c, d);
  if (!is_decided(s)) [[unlikely]]
    return rung::cross_sign_beyond_filter(a, b, c, d);
  return decide(Predicate::CrossSign, Rung::Filter, s);
}

/// Returns the orientation of four points, which is the sign of det [a-d; b-d; c-d]. The
/// orientation is Positive if d lies below the plane of a, b, c. "Below" means on the side from
/// which a, b, c appear clockwise. The orientation is Zero if the points are coplanar. Swapping two
/// points flips the sign.
inline Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const FilteredSign s = rung::orient3d_filter(a, b, c, d);
  if (!is_decided(s)) [[unlikely]]
    return rung::orient3d_beyond_filter(a, b, c, d);
  return decide(Predicate::Orient3d, Rung::Filter, s);
}

/// Returns the sign of det [a-d, |a-d|^2; b-d, |b-d|^2; c-d, |c-d|^2]. If a, b, c are in
/// counter-clockwise order, the result is Positive for a point d inside their circle, and Zero for
/// a point d on the circle. If a, b, c are in clockwise order, Positive and Negative are exchanged.
/// Collinear a, b, c are allowed. Swapping two points flips the sign.
inline Sign incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const FilteredSign s = rung::incircle_filter(a, b, c, d);
  if (!is_decided(s)) [[unlikely]]
    return rung::incircle_beyond_filter(a, b, c, d);
  return decide(Predicate::Incircle, Rung::Filter, s);
}

/// Returns the sign of det [a-e, |a-e|^2; ...; d-e, |d-e|^2]. Suppose that orient3d(a, b, c, d) is
/// Positive. Then the result is Positive if e lies inside the sphere of a, b, c, d, and Zero if e
/// lies on the sphere. If orient3d(a, b, c, d) is Negative, the results Positive and Negative are
/// exchanged. Coplanar a, b, c, d are allowed. Swapping two points flips the sign.
inline Sign insphere(const Point3& a, const Point3& b, const Point3& c, const Point3& d,
                     const Point3& e) {
  const FilteredSign s = rung::insphere_filter(a, b, c, d, e);
  if (!is_decided(s)) [[unlikely]]
    return rung::insphere_beyond_filter(a, b, c, d, e);
  return decide(Predicate::Insphere, Rung::Filter, s);
}

}  // namespace plumb
#pragma GCC visibility pop
