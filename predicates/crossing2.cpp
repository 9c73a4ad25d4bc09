// Crossing2: the Filter rung (make_crossing and the certificates from its box) and the ladders.
//
// Notation and bounds, for any rounding mode and under FTZ/DAZ. A hat marks what was computed.
//   eps = 2^-52   every operation is off by at most eps times its result, and by 2^-1022 more
//                 when it is flushed; a subnormal input may be read as 0, another 2^-1022
//   M             largest |coordinate|, at most 2^200 (else no box is made)
//   h             |approx - exact| <= h for the points: 0 when all are doubles, else eps M
//   a + t u       the crossing: u = b - a, v = d - c, s = c - a, t = num / den, num = s x v, den =
//   u x v
//
// A difference d of coordinates:  |d' - d| <= eps |d'| + h + 2^-1020.
// A cross product w of two of them, P its permanent, S the sum of the four |d'|: the errors of the
// factors give 2 eps P + (h + 2^-1020) S + (eps d' + h + 2^-1020)^2 terms, its own operations 2 eps
// P.
//     |w' - w| <= E(w) = 8 eps P + 2 h (S + h) + 2^-800,
// generous by nearly a factor of 2 in each term; 2^-1020 S < 2^-815 and every flush go with 2^-800.
// The quotient, with D = 0.99 (|den'| - E(den)) <= |den|:
//     |t' - t| <= (|t'| E(den) + E(num)) / D + 2 eps |t'| =: T.
// The sum, r = max(|u'x|, |u'y|): its error is at most
//     (r + h) T + |t'| (eps r + h) + h + 2 eps |t' r| + eps |result| + tiny,
// and with |t'| <= 2^100 tiny is below 2^-900. (2^-1020 T is covered by r T: D > 0 needs r >
// 2^-1003.)
#include <algorithm>
#include <cmath>
#include <limits>

#include "plumb/predicates/homogeneous2.h"
#include "plumb/predicates/point_table2.h"
#include "plumb/predicates/rung_counters.h"

namespace plumb {

namespace {

using detail::Scratch2;
using detail::sign_of_mpz;
using detail::to_rational;
using detail::Triple;

constexpr double kEps = 0x1p-52;
constexpr double kLargest = 0x1p200;
constexpr double kLargestParameter = 0x1p100;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Vector2 {
  double x;
  double y;
};

Vector2 difference(const Point2& from, const Point2& to) { return {to.x - from.x, to.y - from.y}; }

double reach(const Vector2& v) { return std::max(std::fabs(v.x), std::fabs(v.y)); }
double reach(const Point2& p) { return reach(Vector2{p.x, p.y}); }

/// A computed cross product and E(w).
struct Cross {
  double value;
  double error;
};

Cross cross(const Vector2& u, const Vector2& v, double h) {
  const double left = u.x * v.y;
  const double right = u.y * v.x;
  const double permanent = std::fabs(left) + std::fabs(right);
  const double sum = std::fabs(u.x) + std::fabs(u.y) + std::fabs(v.x) + std::fabs(v.y);
  return {left - right, 8 * kEps * permanent + 2 * h * (sum + h) + 0x1p-800};
}

/// A computed value and a bound on its error, +inf when there is none.
struct Approximation {
  double value;
  double error;
};

/// t' and T.
Approximation parameter(const Cross& num, const Cross& den) {
  const double least = 0.99 * (std::fabs(den.value) - den.error);
  if (!(least > 0)) return {0, kInfinity};
  const double t = num.value / den.value;
  const double size = std::fabs(t);
  if (!(size <= kLargestParameter)) return {0, kInfinity};
  return {t, (size * den.error + num.error) / least + 2 * kEps * size};
}

struct Box {
  double x, y, radius;
};

/// The box of a + t u; the factor 1.01 pays for rounding the bound itself.
Box box_at(const Point2& a, const Vector2& u, const Approximation& t, double h) {
  const double x = a.x + t.value * u.x;
  const double y = a.y + t.value * u.y;
  const double r = reach(u);
  const double along = (r + h) * t.error + std::fabs(t.value) * (3 * kEps * r + h);
  const double radius = 1.01 * (along + h + kEps * reach(Vector2{x, y})) + 0x1p-300;
  if (!(radius < 0x1p300)) return {0, 0, kInfinity};
  return {x, y, radius};
}

Box crossing_box(const Point2& a, const Point2& b, const Point2& c, const Point2& d, double h) {
  const Vector2 u = difference(a, b);
  const Vector2 v = difference(c, d);
  return box_at(a, u, parameter(cross(difference(a, c), v, h), cross(u, v, h)), h);
}

/// One of the two lines that define the crossing, by the same indices?
bool is_own_line(std::uint32_t i, std::uint32_t j, const Crossing2& p) {
  return (i == p.a && j == p.b) || (i == p.b && j == p.a) || (i == p.c && j == p.d) ||
         (i == p.d && j == p.c);
}

}  // namespace

Crossing2 make_crossing(const PointTable2& points, std::uint32_t a, std::uint32_t b,
                        std::uint32_t c, std::uint32_t d) {
  const Point2 pa = points.approx(a), pb = points.approx(b);
  const Point2 pc = points.approx(c), pd = points.approx(d);
  const double m = std::max(std::max(reach(pa), reach(pb)), std::max(reach(pc), reach(pd)));
  Box box{0, 0, kInfinity};
  if (m <= kLargest) {
    const bool doubles =
        points.is_double(a) && points.is_double(b) && points.is_double(c) && points.is_double(d);
    box = crossing_box(pa, pb, pc, pd, doubles ? 0 : kEps * m);
  }
  return {a, b, c, d, box.x, box.y, box.radius};
}

/// det = u x w with u = j - i, w = p - i. Every point is taken to be h = eps M off (M <= 2^303 the
/// largest coordinate, the crossing's included), so |u' - u| <= eps |u'| + 2 h and
/// |w' - w| <= eps |w'| + 2 h + radius; flushes add less than 2^-700 in all:
///     |det' - det| <= 4 eps P + |u| (radius + 2 h) + 2 h |w| + 2 h (radius + 2 h) + 2^-700,
/// P the permanent and | | the sum of the coordinates' sizes. Doubled, it pays for its own
/// rounding.
FilteredSign rung::orient2d_filter(const PointTable2& points, std::uint32_t i, std::uint32_t j,
                                   const Crossing2& p) {
  const Point2 a = points.approx(i);
  const Point2 b = points.approx(j);
  const double m = std::max(std::max(reach(a), reach(b)), reach(Vector2{p.x, p.y}));
  const Vector2 u = difference(a, b);
  const Vector2 w = difference(a, Point2{p.x, p.y});
  const Cross det = cross(u, w, 0);
  const double off = 2 * kEps * m;
  const double size_u = std::fabs(u.x) + std::fabs(u.y);
  const double size_w = std::fabs(w.x) + std::fabs(w.y);
  const double bound =
      det.error + 2 * (size_u * (p.radius + off) + off * (size_w + p.radius + off)) + 0x1p-600;
  if (!(m <= 0x1p303) || !(std::fabs(det.value) > bound)) return FilteredSign::Unsure;
  return det.value > 0 ? FilteredSign::Positive : FilteredSign::Negative;
}

Sign orient2d(const PointTable2& points, std::uint32_t i, std::uint32_t j, const Crossing2& p) {
  if (is_own_line(i, j, p)) {
    return decide(Predicate::SideOfCrossing2, Rung::Identity, FilteredSign::Zero);
  }
  const FilteredSign filter = rung::orient2d_filter(points, i, j, p);
  if (is_decided(filter)) return decide(Predicate::SideOfCrossing2, Rung::Filter, filter);
  const FilteredSign exact = rung::orient2d_exact(points, i, j, p);
  if (is_decided(exact)) return decide(Predicate::SideOfCrossing2, Rung::Exact, exact);
  count_rung(Predicate::SideOfCrossing2, Rung::Big);
  return rung::orient2d_big(points, i, j, p);
}

Sign detail::compare_xy_unsure(const PointTable2& points, const Crossing2& p, std::uint32_t i) {
  const FilteredSign f = rung::compare_xy_exact(points, p, i);
  if (is_decided(f)) return decide(Predicate::CompareCrossings2, Rung::Exact, f);
  count_rung(Predicate::CompareCrossings2, Rung::Big);
  return rung::compare_xy_big(points, p, i);
}

Sign detail::compare_xy_unsure(const PointTable2& points, const Crossing2& p, const Crossing2& q) {
  // A sweep finds the same crossing again and again: identity before arithmetic.
  if (p.a == q.a && p.b == q.b && p.c == q.c && p.d == q.d) {
    return decide(Predicate::CompareCrossings2, Rung::Identity, FilteredSign::Zero);
  }
  const FilteredSign f = rung::compare_xy_exact(points, p, q);
  if (is_decided(f)) return decide(Predicate::CompareCrossings2, Rung::Exact, f);
  count_rung(Predicate::CompareCrossings2, Rung::Big);
  return rung::compare_xy_big(points, p, q);
}

Sign rung::compare_xy_big(const PointTable2& points, const Crossing2& p, std::uint32_t i) {
  Scratch2& scratch = Scratch2::fresh();
  return scratch.compare_xy(scratch.point(points, p), scratch.point(points, i));
}

Sign rung::compare_xy_big(const PointTable2& points, const Crossing2& p, const Crossing2& q) {
  Scratch2& scratch = Scratch2::fresh();
  return scratch.compare_xy(scratch.point(points, p), scratch.point(points, q));
}

Sign rung::orient2d_big(const PointTable2& points, std::uint32_t i, std::uint32_t j,
                        const Crossing2& p) {
  Scratch2& scratch = Scratch2::fresh();
  const Triple at = scratch.point(points, p);
  return scratch.dot_sign(scratch.line(points, i, j), at) * sign_of_mpz(at.w);
}

RationalPoint2 exact(const PointTable2& points, const Crossing2& p) {
  Scratch2& scratch = Scratch2::fresh();
  const Triple at = scratch.point(points, p);
  return {to_rational(at.x, at.w), to_rational(at.y, at.w)};
}

}  // namespace plumb
