// The rows of planes in doubles, with proved error bounds.
//
// The analysis holds for any rounding mode and under FTZ/DAZ (docs/design/numbers.md, Planes).
// eps = 2^-52 bounds the relative error of one operation in every mode, eta = 2^-1022 what flushing
// a subnormal operand or result loses.
//
// fast_row() admits |coordinates| <= 2^300 and max |n| >= 2^-600.
//
// - u = q - p and v = r - p: the relative error is eps, and flushing adds 3 eta (two operands and
// one
//   result).
// - n_x = u_y v_z - u_z v_y: with t = |u_y v_z| + |u_z v_y| as computed, the relative errors of u,
// v,
//   the product and the subtraction add up to at most (1 + eps)^4 - 1 < 4.1 eps of the exact t,
//   which is less than 5 eps t. Flushing adds 2 * 3 eta * 2^302 + 4 eta < 2^-716. So |n - exact| <=
//   e with e = 6 eps max t + 2^-700, where eps max t pays for the roundings of t and e.
// - Scaling by s = 2^-k makes max |n| lie in [1/2, 1). The row has normal_error = 2 (e s) + 2^-48.
// - d = -n.p is off by |n - exact| |p|_1 + 3 eps |p|_1 + 4 eta, as max |n| < 1. With E = e s the
// row
//   has offset_error = 2 (E + 2^-49) |p|_1, at least 2^-126, which is more than twice the error.
//
// A computed zero may be an underflow. So a component counts as zero only if each of its products
// has a factor that is the difference of equal numbers.
//
// Tested by tests/predicates/plane_row_test.cpp.

#include "plumb/predicates/space/plane_row.h"

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cmath>
#include <limits>

namespace plumb {

float rounded_up(double x) {
  // One rounding to float loses at most 2^-23 in any rounding mode.
  const double widened = x * (1 + 0x1p-20);
  if (!(widened < static_cast<double>(FLT_MAX))) return std::numeric_limits<float>::infinity();
  return static_cast<float>(std::max(widened, static_cast<double>(FLT_MIN)));
}

namespace {

constexpr double coordinate(const Point3& p, std::size_t axis) {
  return axis == 0 ? p.x : (axis == 1 ? p.y : p.z);
}

constexpr double kLargest = 0x1p300;
constexpr double kLeastNormal = 0x1p-600;
constexpr double kAbsolute = 0x1p-700;
constexpr double kSixEps = 6 * 0x1p-52;

double max_abs(const Point3& p) {
  return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
}

/// Returns 2^-k such that x 2^-k is in [1/2, 1). Requires a normal x in [2^-1000, 2^1000].
double normalizer(double x) {
  const auto field = (std::bit_cast<std::uint64_t>(x) >> 52) & 0x7ff;
  return std::bit_cast<double>((std::uint64_t{2045} - field) << 52);
}

struct Component {
  double value;
  double terms;
};

Component cross_component(double a, double b, double c, double d) {
  const double left = a * b, right = c * d;
  return {left - right, std::fabs(left) + std::fabs(right)};
}

/// Whether component i of (q - p) x (r - p) is zero because each of its products has a factor that
/// is the difference of equal numbers.
bool is_plainly_zero(const Point3& p, const Point3& q, const Point3& r, std::size_t i) {
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  const auto same = [](const Point3& a, const Point3& b, std::size_t axis) {
    return is_equal(coordinate(a, axis), coordinate(b, axis));
  };
  return (same(p, q, j) || same(p, r, k)) && (same(p, q, k) || same(p, r, j));
}

/// Returns the sign of the first nonzero component of n = (q - p) x (r - p); 0 if doubles do not
/// determine it.
int leading_sign(const std::array<Component, 3>& n, double error, const Point3& p, const Point3& q,
                 const Point3& r) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (n[i].value > error) return 1;
    if (n[i].value < -error) return -1;
    if (n[i].terms != 0 || !is_plainly_zero(p, q, r, i)) return 0;
  }
  return 0;
}

}  // namespace

FastRow fast_row(const Point3& p, const Point3& q, const Point3& r) {
  FastRow result{};
  if (!(std::max({max_abs(p), max_abs(q), max_abs(r)}) <= kLargest)) return result;
  const double ux = q.x - p.x, uy = q.y - p.y, uz = q.z - p.z;
  const double vx = r.x - p.x, vy = r.y - p.y, vz = r.z - p.z;
  const std::array<Component, 3> n = {cross_component(uy, vz, uz, vy),
                                      cross_component(uz, vx, ux, vz),
                                      cross_component(ux, vy, uy, vx)};
  const double largest =
      std::max({std::fabs(n[0].value), std::fabs(n[1].value), std::fabs(n[2].value)});
  const double error = kSixEps * std::max({n[0].terms, n[1].terms, n[2].terms}) + kAbsolute;
  if (!(largest >= kLeastNormal && error <= 0x1p-37 * largest)) return result;
  const int sign = leading_sign(n, error, p, q, r);
  if (sign == 0) return result;
  const double s = normalizer(largest), toward = sign < 0 ? -s : s, scaled_error = error * s;
  PlaneRow& row = result.row;
  row.n = {n[0].value * toward, n[1].value * toward, n[2].value * toward};
  row.d = -(row.n[0] * p.x + row.n[1] * p.y + row.n[2] * p.z);
  row.normal_error = rounded_up(2 * scaled_error + 2 * kUnitError);
  row.offset_error = rounded_up(2 * (scaled_error + kUnitError) *
                                (std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z)));
  result.is_good = true;
  result.is_flipped = sign < 0;
  return result;
}

namespace {

/// Returns s.mantissa 2^(s.exponent - lower). Values below 2^-200 become 0, which is an absolute
/// error of 2^-200.
double lowered(const Scaled& s, int lower) {
  const int exponent = s.exponent - lower;
  return exponent < -200 ? 0 : s.mantissa * power_of_two(exponent);
}

/// Sets the offset and its error. An offset above 2^900 becomes 0 with an infinite error. An offset
/// below 2^-900 becomes 0 with the least error.
void set_offset(const Scaled& s, std::int64_t exponent, PlaneRow& row) {
  if (exponent > 900) {
    row.d = 0;
    row.offset_error = std::numeric_limits<float>::infinity();
    return;
  }
  row.d = exponent < -900 ? 0 : s.mantissa * power_of_two(static_cast<int>(exponent));
  row.offset_error = rounded_up(2 * kUnitError * std::fabs(row.d));
}

}  // namespace

/// scaled() loses less than 2^-51 of each coefficient, which is less than kUnitError / 2.
template <class Plane>
PlaneRow exact_row(const Plane& plane) {
  const std::array<Scaled, 3> n = {scaled(plane.n[0]), scaled(plane.n[1]), scaled(plane.n[2])};
  int top = INT_MIN;
  for (const Scaled& s : n) top = s.mantissa != 0 ? std::max(top, s.exponent) : top;
  PlaneRow row{};
  for (std::size_t i = 0; i < 3; ++i) row.n[i] = n[i].mantissa == 0 ? 0 : lowered(n[i], top);
  row.normal_error = rounded_up(2 * kUnitError);
  const Scaled d = scaled(plane.d);
  if (d.mantissa == 0) {
    row.offset_error = FLT_MIN;
  } else {
    set_offset(d, std::int64_t{d.exponent} - top + plane.scale, row);
  }
  return row;
}

template PlaneRow exact_row(const exact3::FixedPlane<exact3::Medium>&);
template PlaneRow exact_row(const exact3::LongPlane&);
template PlaneRow exact_row(const exact3::BigPlane&);

}  // namespace plumb
