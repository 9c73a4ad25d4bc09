// Predicates of points of which some are no doubles, and the Big rung.
//
// Filter bounds, for any rounding mode and under FTZ/DAZ; eps = 2^-52, M <= 2^303 the largest
// |approximation|. An approximation is off by at most h = eps M / 2 (and 2^-1074, a subnormal one),
// so a difference of two is off by eps |d'| + 2 h + 2^-1020 = eps (|d'| + M) + 2^-1020. A cross
// product w of two, P its permanent and S the sum of the four |d'|:
//     |w' - w| <= 4 eps P + eps M S + 2 eps^2 (|d'| + M)^2 terms <= 4 eps P + eps M S + 18 eps^2
//     M^2
// plus flushes below 2^-700. The computed bound is twice that.
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "plumb/predicates/decompose.h"
#include "plumb/predicates/homogeneous2.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/rung_counters.h"

namespace plumb {

namespace {

using detail::Scratch2;
using detail::sign_of_mpz;

constexpr double kEps = 0x1p-52;

double reach(const Point2& p) { return std::max(std::fabs(p.x), std::fabs(p.y)); }

/// Sign of (b - a) x (d - c) for approximations.
FilteredSign cross_filter(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double m = std::max(std::max(reach(a), reach(b)), std::max(reach(c), reach(d)));
  const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x, vy = d.y - c.y;
  const double left = ux * vy;
  const double right = uy * vx;
  const double det = left - right;
  const double permanent = std::fabs(left) + std::fabs(right);
  const double sum = std::fabs(ux) + std::fabs(uy) + std::fabs(vx) + std::fabs(vy);
  const double bound = kEps * (8 * permanent + 2 * m * (sum + 18 * kEps * m)) + 0x1p-600;
  if (!(m <= 0x1p303) || !(std::fabs(det) > bound)) return FilteredSign::Unsure;
  return det > 0 ? FilteredSign::Positive : FilteredSign::Negative;
}

bool are_doubles(const PointTable2& points, std::initializer_list<std::uint32_t> indices) {
  return std::all_of(indices.begin(), indices.end(),
                     [&](std::uint32_t i) { return points.is_double(i); });
}

}  // namespace

FilteredSign rung::orient2d_filter(const PointTable2& points, std::uint32_t i, std::uint32_t j,
                                   std::uint32_t k) {
  return cross_filter(points.approx(i), points.approx(j), points.approx(i), points.approx(k));
}

FilteredSign rung::cross_sign_filter(const PointTable2& points, std::uint32_t a, std::uint32_t b,
                                     std::uint32_t c, std::uint32_t d) {
  return cross_filter(points.approx(a), points.approx(b), points.approx(c), points.approx(d));
}

Sign detail::compare_xy_unsure(const PointTable2& points, std::uint32_t i, std::uint32_t j) {
  const bool is_big = !are_doubles(points, {i, j});
  count_rung(Predicate::ComparePoints2, is_big ? Rung::Big : Rung::Exact);
  if (is_big) return rung::compare_xy_big(points, i, j);
  const Point2 p = points.approx(i);
  const Point2 q = points.approx(j);
  const Sign by_x = compare(p.x, q.x);
  return by_x != Sign::Zero ? by_x : compare(p.y, q.y);
}

Sign detail::orient2d_mixed(const PointTable2& points, std::uint32_t i, std::uint32_t j,
                            std::uint32_t k) {
  if (are_doubles(points, {i, j, k})) {
    return orient2d(points.approx(i), points.approx(j), points.approx(k));
  }
  const FilteredSign f = rung::orient2d_filter(points, i, j, k);
  if (is_decided(f)) return decide(Predicate::Orient2d, Rung::Filter, f);
  count_rung(Predicate::Orient2d, Rung::Big);
  return rung::orient2d_big(points, i, j, k);
}

Sign detail::cross_sign_mixed(const PointTable2& points, std::uint32_t a, std::uint32_t b,
                              std::uint32_t c, std::uint32_t d) {
  if (are_doubles(points, {a, b, c, d})) {
    return cross_sign(points.approx(a), points.approx(b), points.approx(c), points.approx(d));
  }
  const FilteredSign f = rung::cross_sign_filter(points, a, b, c, d);
  if (is_decided(f)) return decide(Predicate::CrossSign, Rung::Filter, f);
  count_rung(Predicate::CrossSign, Rung::Big);
  return rung::cross_sign_big(points, a, b, c, d);
}

Sign rung::compare_xy_big(const PointTable2& points, std::uint32_t i, std::uint32_t j) {
  Scratch2& scratch = Scratch2::fresh();
  return scratch.compare_xy(scratch.point(points, i), scratch.point(points, j));
}

Sign rung::orient2d_big(const PointTable2& points, std::uint32_t i, std::uint32_t j,
                        std::uint32_t k) {
  Scratch2& scratch = Scratch2::fresh();
  return scratch.dot_sign(scratch.line(points, i, j), scratch.point(points, k));
}

Sign rung::cross_sign_big(const PointTable2& points, std::uint32_t a, std::uint32_t b,
                          std::uint32_t c, std::uint32_t d) {
  Scratch2& scratch = Scratch2::fresh();
  return sign_of_mpz(scratch.cross(scratch.line(points, a, b), scratch.line(points, c, d)).w);
}

}  // namespace plumb
