// The filters of the predicates on points with double coordinates. Each filter consists of one
// expression, one semi-static error bound and one range test. The filters are inline, because they
// decide most calls. The proof below is also in docs/design/numbers.md (Filters of input points).
//
// Notation
//   eps     2^-52. In *every* rounding mode, |fl(x) - x| <= eps |x| and |fl(x) - x| <= eps |fl(x)|,
//           if there is no underflow or overflow. (If rounding to nearest were the only allowed
//           mode, eps could be 2^-53.)
//   M       2^m, a bound that a filter tests (the gate). If the magnitudes of all computed
//           differences are at most M, nothing overflows.
//   flush   2^-1021. This bounds the error that underflow causes in one operation. A result below
//           2^-1022 may become 0 when it is computed (FTZ) or when it is read (DAZ).
//   Delta   2^-1020. This bounds the error that underflow causes in a difference of two inputs.
//           Each input may be read as 0 (DAZ), which is a change below 2^-1022, and the difference
//           may be flushed.
//
// Each filter relies on this theorem: the sign of the computed determinant det' is right if
//
//     |det'| > C P' + F
//
// Here P' is the computed permanent: the sum of the absolute values of the terms of the
// determinant. C P' bounds the rounding errors, and F bounds the errors by underflow.
//
// The factor C. Follow one term of the determinant through the expression. The relative error of a
// difference is eps. The relative error of a product is the sum of the errors of its factors, plus
// eps. The relative error of a sum is the larger error of its two parts, plus eps. The error of the
// last sum is eps |det'|. The error of the term, divided by the computed permanent, is k eps to
// first order. The comment of each constant states k. The remaining errors are of second order.
// There are fewer than 32 operations, and k <= 16. Therefore all errors of second order together
// change k by less than 2000 eps. (They arise in the term, in the computed P', in C P' + F and in
// the last sum.) C is at least k + 1 (in units of eps), and the additional 1 is far more than 2000
// eps. A fused multiply-add omits one of the counted roundings, so contraction does no harm.
//
// The bound F. Let the determinant be a sum of T products of n differences. An error of Delta in a
// difference is multiplied by the other n - 1 differences, whose product is at most M^(n-1).
// Together these errors are at most T n Delta M^(n-1). A flush of an intermediate result of degree
// j >= 2 is multiplied by at most 3 M^(n-2). The factor 3 comes from the lift of a point, a sum of
// up to three squares. All these flushes together are smaller than the bound T n Delta M^(n-1) by a
// factor of 2^100. So twice this bound covers the errors Delta, all these flushes, and the rounding
// of F itself:
//
//     F >= 2 T n 2^-1020 M^(n-1)
//
// Flushes in P' are multiplied by C and are negligible compared with F. The exponent m is chosen so
// that the range of exponents for which the filter decides is about symmetric around 0. For points
// with coordinates of about 2^-m, det' is about F.
#pragma once

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>

#include "plumb/predicates/point.h"
#include "plumb/predicates/sign.h"

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__)
#error "plumb's predicates need IEEE arithmetic: no -ffast-math, no -fassociative-math"
#endif
static_assert(FLT_EVAL_METHOD == 0,
              "plumb's predicates need double arithmetic in double precision");

#pragma GCC visibility push(default)
namespace plumb::rung {

namespace constants {

inline constexpr double kEpsilon = 0x1p-52;

// For each predicate, the comments below state the relative errors of the parts of its expression,
// in units of eps, and then k.
//
// orient2d, cross: difference 1, product 1+1+1 = 3: k = 3. T = 2, n = 2: F >= 2^3 2^-1020 2^340.
inline constexpr double kOrient2dError = 4 * kEpsilon;
inline constexpr double kOrient2dGate = 0x1p340;
inline constexpr double kOrient2dFloor = 0x1p-675;

// orient3d: minor 3+1 = 4, times a difference 4+1+1 = 6, first sum 7: k = 7.
// T = 6, n = 3: F >= 36 2^-1020 2^400.
inline constexpr double kOrient3dError = 8 * kEpsilon;
inline constexpr double kOrient3dGate = 0x1p200;
inline constexpr double kOrient3dFloor = 0x1p-612;

// incircle: minor 4, lift 3+1 = 4, product 4+4+1 = 9, first sum 10: k = 10. T = 12, n = 4: F >= 96
// 2^-1020 2^432. The gate is tested for the computed lifts (lift'), not for the differences d. This
// is enough: d^2 (1 - eps) <= lift' <= 2^(2m-1), so |d| <= 2^m = M.
inline constexpr double kIncircleError = 12 * kEpsilon;
inline constexpr double kIncircleLiftGate = 0x1p287;
inline constexpr double kIncircleFloor = 0x1p-578;

// insphere: minor 4, times a difference 6, two sums 8; lift 3+2 = 5; product 8+5+1 = 14, first sum
// 15: k = 15. T = 72, n = 5: F >= 720 2^-1020 2^448. The gate is tested as for incircle, with m =
// 112.
inline constexpr double kInsphereError = 18 * kEpsilon;
inline constexpr double kInsphereLiftGate = 0x1p223;
inline constexpr double kInsphereFloor = 0x1p-560;

}  // namespace constants

namespace detail {

inline double reach(double a, double b) { return std::max(std::abs(a), std::abs(b)); }
inline double reach(double a, double b, double c) { return std::max(reach(a, b), std::abs(c)); }

/// A determinant evaluated in doubles, its permanent, and whether the range test (the gate) holds.
struct Evaluation {
  double det;
  double permanent;
  bool in_gate;
};

/// Returns the sign of the determinant if its magnitude exceeds the bound. Otherwise returns
/// Unsure. If the range test fails, infinities and then a NaN can arise. The result for a NaN is
/// Unsure. A determinant whose magnitude exceeds the bound is not subnormal, so its sign bit is
/// right.
inline FilteredSign certify(const Evaluation& e, double error, double floor) {
  if (e.in_gate && std::abs(e.det) > error * e.permanent + floor) [[likely]] {
    return static_cast<FilteredSign>((std::bit_cast<std::int64_t>(e.det) >> 63) | 1);
  }
  return FilteredSign::Unsure;
}

/// Two doubles in one register. g++ and clang support this type on every target. With this type,
/// orient2d takes a quarter less time.
typedef double Pair __attribute__((vector_size(16)));
typedef std::int64_t PairBits __attribute__((vector_size(16)));

inline Pair abs(Pair v) {
  constexpr std::int64_t kMagnitude = std::numeric_limits<std::int64_t>::max();
  return (Pair)((PairBits)v & PairBits{kMagnitude, kMagnitude});
}

inline Pair difference(const Point2& p, const Point2& q) { return Pair{p.x, p.y} - Pair{q.x, q.y}; }

/// Evaluates u[0] v[1] - u[1] v[0] for differences u and v of inputs. The gate is tested on the sum
/// of the magnitudes of the four differences. This sum is at least as large as each magnitude.
inline Evaluation cross(Pair u, Pair v) {
  const Pair products = u * Pair{v[1], v[0]};
  const Pair sizes = abs(products);
  const Pair reach = abs(u) + abs(v);
  return {products[0] - products[1], sizes[0] + sizes[1],
          reach[0] + reach[1] <= constants::kOrient2dGate};
}

inline Evaluation orient2d(const Point2& a, const Point2& b, const Point2& c) {
  return cross(difference(a, c), difference(b, c));
}

inline Evaluation cross_sign(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  return cross(difference(b, a), difference(d, c));
}

inline Evaluation orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
  const double adx = a.x - d.x, ady = a.y - d.y, adz = a.z - d.z;
  const double bdx = b.x - d.x, bdy = b.y - d.y, bdz = b.z - d.z;
  const double cdx = c.x - d.x, cdy = c.y - d.y, cdz = c.z - d.z;
  const double bc = bdx * cdy, cb = cdx * bdy;
  const double ca = cdx * ady, ac = adx * cdy;
  const double ab = adx * bdy, ba = bdx * ady;
  const double det = adz * (bc - cb) + bdz * (ca - ac) + cdz * (ab - ba);
  const double permanent = std::abs(adz) * (std::abs(bc) + std::abs(cb)) +
                           std::abs(bdz) * (std::abs(ca) + std::abs(ac)) +
                           std::abs(cdz) * (std::abs(ab) + std::abs(ba));
  const double all = reach(reach(adx, ady, adz), reach(bdx, bdy, bdz), reach(cdx, cdy, cdz));
  return {det, permanent, all <= constants::kOrient3dGate};
}

inline Evaluation incircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double adx = a.x - d.x, ady = a.y - d.y;
  const double bdx = b.x - d.x, bdy = b.y - d.y;
  const double cdx = c.x - d.x, cdy = c.y - d.y;
  const double bc = bdx * cdy, cb = cdx * bdy;
  const double ca = cdx * ady, ac = adx * cdy;
  const double ab = adx * bdy, ba = bdx * ady;
  const double a_lift = adx * adx + ady * ady;
  const double b_lift = bdx * bdx + bdy * bdy;
  const double c_lift = cdx * cdx + cdy * cdy;
  const double det = a_lift * (bc - cb) + b_lift * (ca - ac) + c_lift * (ab - ba);
  const double permanent = a_lift * (std::abs(bc) + std::abs(cb)) +
                           b_lift * (std::abs(ca) + std::abs(ac)) +
                           c_lift * (std::abs(ab) + std::abs(ba));
  return {det, permanent, reach(a_lift, b_lift, c_lift) <= constants::kIncircleLiftGate};
}

struct Vector {
  double x, y, z;
  double lift() const { return x * x + y * y + z * z; }
};

inline Vector difference(const Point3& p, const Point3& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}

/// A minor and its permanent.
struct Minor {
  double value;
  double size;
};

inline Minor minor_xy(const Vector& u, const Vector& v) {
  const double left = u.x * v.y, right = v.x * u.y;
  return {left - right, std::abs(left) + std::abs(right)};
}

/// Returns det(u, v, w) from 2 x 2 minors of the x and y coordinates.
inline Minor minor_xyz(double uz, const Minor& vw, double vz, const Minor& uw, double wz,
                       const Minor& uv) {
  return {uz * vw.value - vz * uw.value + wz * uv.value,
          std::abs(uz) * vw.size + std::abs(vz) * uw.size + std::abs(wz) * uv.size};
}

inline Evaluation insphere(const Point3& pa, const Point3& pb, const Point3& pc, const Point3& pd,
                           const Point3& pe) {
  const Vector a = difference(pa, pe), b = difference(pb, pe);
  const Vector c = difference(pc, pe), d = difference(pd, pe);
  const Minor ab = minor_xy(a, b), bc = minor_xy(b, c), cd = minor_xy(c, d);
  const Minor ad = minor_xy(a, d), ac = minor_xy(a, c), bd = minor_xy(b, d);
  const Minor abc = minor_xyz(a.z, bc, b.z, ac, c.z, ab);
  const Minor bcd = minor_xyz(b.z, cd, c.z, bd, d.z, bc);
  const Minor abd = minor_xyz(a.z, bd, b.z, ad, d.z, ab);
  const Minor acd = minor_xyz(a.z, cd, c.z, ad, d.z, ac);
  const double a_lift = a.lift(), b_lift = b.lift(), c_lift = c.lift(), d_lift = d.lift();
  const double det =
      (d_lift * abc.value - c_lift * abd.value) + (b_lift * acd.value - a_lift * bcd.value);
  const double permanent =
      (d_lift * abc.size + c_lift * abd.size) + (b_lift * acd.size + a_lift * bcd.size);
  const double all = std::max(reach(a_lift, b_lift), reach(c_lift, d_lift));
  return {det, permanent, all <= constants::kInsphereLiftGate};
}

}  // namespace detail

inline FilteredSign orient2d_filter(const Point2& a, const Point2& b, const Point2& c) {
  return detail::certify(detail::orient2d(a, b, c), constants::kOrient2dError,
                         constants::kOrient2dFloor);
}

inline FilteredSign cross_sign_filter(const Point2& a, const Point2& b, const Point2& c,
                                      const Point2& d) {
  return detail::certify(detail::cross_sign(a, b, c, d), constants::kOrient2dError,
                         constants::kOrient2dFloor);
}

inline FilteredSign orient3d_filter(const Point3& a, const Point3& b, const Point3& c,
                                    const Point3& d) {
  return detail::certify(detail::orient3d(a, b, c, d), constants::kOrient3dError,
                         constants::kOrient3dFloor);
}

inline FilteredSign incircle_filter(const Point2& a, const Point2& b, const Point2& c,
                                    const Point2& d) {
  return detail::certify(detail::incircle(a, b, c, d), constants::kIncircleError,
                         constants::kIncircleFloor);
}

inline FilteredSign insphere_filter(const Point3& a, const Point3& b, const Point3& c,
                                    const Point3& d, const Point3& e) {
  return detail::certify(detail::insphere(a, b, c, d, e), constants::kInsphereError,
                         constants::kInsphereFloor);
}

}  // namespace plumb::rung
#pragma GCC visibility pop
