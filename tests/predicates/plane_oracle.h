// Predicates of the plane the slow way: points scaled to integers of Boost cpp_int, crossings by
// Cramer's rule. Shares no arithmetic with the library.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <string>
#include <vector>

#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/rounding.h"
#include "plumb/predicates/sign.h"

namespace plumb {

using OracleInteger = boost::multiprecision::cpp_int;
using OracleRational = boost::multiprecision::cpp_rational;

/// (x / w, y / w), w > 0.
struct OraclePoint {
  OracleInteger x, y, w;
};

inline OracleInteger oracle_integer(const Integer& n) { return OracleInteger(n.str()); }

/// All points on one common denominator, so that W is the same positive number for all of them.
class PlaneOracle {
 public:
  explicit PlaneOracle(const std::vector<RationalPoint2>& points) {
    Integer w = 1;
    for (const RationalPoint2& p : points) w = lcm(w, lcm(denominator(p.x), denominator(p.y)));
    for (const RationalPoint2& p : points) {
      points_.push_back({scaled(p.x, w), scaled(p.y, w), oracle_integer(w)});
    }
  }

  const OraclePoint& point(std::size_t i) const { return points_[i]; }

  /// Of (b - a) x (d - c), times W^2.
  OracleInteger cross(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
    const OraclePoint &p = points_[a], &q = points_[b], &r = points_[c], &s = points_[d];
    return (q.x - p.x) * (s.y - r.y) - (q.y - p.y) * (s.x - r.x);
  }

  Sign orient2d(std::size_t i, std::size_t j, std::size_t k) const {
    return sign_of(cross(i, j, i, k));
  }

  /// Requires cross(a, b, c, d) != 0.
  OraclePoint meet(std::size_t a, std::size_t b, std::size_t c, std::size_t d) const {
    OracleInteger num = cross(a, c, c, d);
    OracleInteger den = cross(a, b, c, d);
    if (den < 0) {
      num = -num;
      den = -den;
    }
    const OraclePoint &p = points_[a], &q = points_[b];
    return {p.x * den + (q.x - p.x) * num, p.y * den + (q.y - p.y) * num, p.w * den};
  }

  /// Of (j - i) x (p - i).
  Sign orient2d(std::size_t i, std::size_t j, const OraclePoint& p) const {
    const OraclePoint &a = points_[i], &b = points_[j];
    const OracleInteger det =
        (b.x - a.x) * (p.y * a.w - a.y * p.w) - (b.y - a.y) * (p.x * a.w - a.x * p.w);
    return sign_of(det);
  }

 private:
  static OracleInteger scaled(const Rational& v, const Integer& w) {
    return oracle_integer(numerator(v) * (w / denominator(v)));
  }

  std::vector<OraclePoint> points_;
};

inline Sign compare_xy(const OraclePoint& p, const OraclePoint& q) {
  const OracleInteger by_x = p.x * q.w - q.x * p.w;
  return sign_of(by_x != 0 ? by_x : OracleInteger(p.y * q.w - q.y * p.w));
}

}  // namespace plumb
