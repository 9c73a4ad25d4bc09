// The table of points of the plane, and the predicates on its points and on crossings.
//
// A point that doubles do not hold has homogeneous integer coordinates in a pool of limbs, and its
// nearest doubles; the two parts below decide signs about such points and about crossings of lines
// through any points. Each predicate asks, in this order: equal indices, a filter with error
// bounds, integers of a fixed width if all points are doubles (point2_exact.cpp), and GMP.
//
// docs/design/numbers.md (Crossings in the plane) proves the bounds of the filters, which hold in
// any rounding mode and with subnormal numbers flushed to zero.
//
// Tested by tests/predicates/point_table2_test.cpp and tests/predicates/rung_reach_test.cpp.

#include "plumb/predicates/point_table2.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <initializer_list>
#include <limits>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/plane/point2_exact.h"
#include "plumb/predicates/rounding.h"

namespace plumb {

namespace {

/// Returns 0.0 for -0.0, and every other number unchanged. The function examines the bits, because
/// under DAZ every comparison and every sum would read a subnormal number as zero.
double without_negative_zero(double v) {
  constexpr std::uint64_t kNegativeZero = std::uint64_t{1} << 63;
  return std::bit_cast<std::uint64_t>(v) == kNegativeZero ? 0.0 : v;
}

}  // namespace

void PointTable2::reserve(std::size_t points) { points_.reserve(points); }

void PointTable2::push_back(Point2 p) {
  points_.push_back({without_negative_zero(p.x), without_negative_zero(p.y)});
  if (!slot_.empty()) slot_.push_back(kNoSlot);
}

/// Slots are made only when the first point is added that doubles cannot represent.
void PointTable2::push_back(const Rational& x, const Rational& y) {
  const RoundedDouble rx = round_to_double(x);
  const RoundedDouble ry = round_to_double(y);
  if (rx.error == Sign::Zero && ry.error == Sign::Zero) {
    push_back(Point2{rx.value, ry.value});
    return;
  }
  slot_.resize(points_.size(), kNoSlot);
  slot_.push_back(static_cast<std::uint32_t>(entries_.size()));
  points_.push_back({clamped_to_finite(rx.value), clamped_to_finite(ry.value)});
  const Integer w = lcm(denominator(x), denominator(y));
  const Integer px = numerator(x) * (w / denominator(x));
  const Integer py = numerator(y) * (w / denominator(y));
  Entry entry{limbs_.size(), 0, 0, 0};
  entry.x_size = append_limbs(px.mpz());
  entry.y_size = append_limbs(py.mpz());
  entry.w_size = append_limbs(w.mpz());
  entries_.push_back(entry);
}

/// Appends |value| to the pool. Returns the number of limbs. As in GMP, this number is negative if
/// the value is negative.
std::int32_t PointTable2::append_limbs(mpz_srcptr value) {
  const mp_limb_t* limbs = mpz_limbs_read(value);
  limbs_.insert(limbs_.end(), limbs, limbs + mpz_size(value));
  const auto size = static_cast<std::int32_t>(mpz_size(value));
  return mpz_sgn(value) < 0 ? -size : size;
}

/// Appends point i of `other`. Requires that doubles cannot represent the point.
void PointTable2::append_entry(const PointTable2& other, std::uint32_t i) {
  Entry entry = other.entries_[other.slot_[i]];
  const std::size_t length = static_cast<std::size_t>(std::abs(entry.x_size)) +
                             static_cast<std::size_t>(std::abs(entry.y_size)) +
                             static_cast<std::size_t>(std::abs(entry.w_size));
  const auto first = other.limbs_.begin() + static_cast<std::ptrdiff_t>(entry.begin);
  entry.begin = limbs_.size();
  limbs_.insert(limbs_.end(), first, first + static_cast<std::ptrdiff_t>(length));
  slot_.resize(points_.size(), kNoSlot);
  slot_.push_back(static_cast<std::uint32_t>(entries_.size()));
  points_.push_back(other.points_[i]);
  entries_.push_back(entry);
}

void PointTable2::append(const PointTable2& other) {
  if (other.all_double()) {
    points_.insert(points_.end(), other.points_.begin(), other.points_.end());
    if (!slot_.empty()) slot_.resize(points_.size(), kNoSlot);
    return;
  }
  for (std::uint32_t i = 0; i < other.size(); ++i) {
    if (other.is_double(i)) {
      push_back(other.points_[i]);
    } else {
      append_entry(other, i);
    }
  }
}

PointTable2 PointTable2::subset(std::span<const std::uint8_t> keep) const {
  PointTable2 kept;
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (keep[i] == 0) continue;
    if (is_double(i)) {
      kept.push_back(points_[i]);
    } else {
      kept.append_entry(*this, i);
    }
  }
  return kept;
}

HomogeneousView2 PointTable2::homogeneous(std::uint32_t i) const {
  const Entry& e = entries_[slot_[i]];
  const mp_limb_t* x = limbs_.data() + e.begin;
  const mp_limb_t* y = x + std::abs(e.x_size);
  const mp_limb_t* w = y + std::abs(e.y_size);
  HomogeneousView2 view;
  mpz_roinit_n(view.x, x, e.x_size);
  mpz_roinit_n(view.y, y, e.y_size);
  mpz_roinit_n(view.w, w, e.w_size);
  return view;
}

RationalPoint2 PointTable2::exact(std::uint32_t i) const {
  if (is_double(i)) return {exact_rational(points_[i].x), exact_rational(points_[i].y)};
  const HomogeneousView2 h = homogeneous(i);
  const Integer w(h.w);
  return {Rational(Integer(h.x), w), Rational(Integer(h.y), w)};
}

// Predicates on points of which some are no doubles, and the GMP stage of predicates on points.
//
// Bounds of the filter, for any rounding mode and under FTZ/DAZ. eps = 2^-52, and M <= 2^303 is the
// largest |approximation|. An approximation is off by at most h = eps M / 2 (and by 2^-1074 if it
// is subnormal), so a difference of two is off by eps |d'| + 2 h + 2^-1020 = eps (|d'| + M) +
// 2^-1020. Let w be a cross product of two differences, P its permanent and S the sum of the four
// |d'|. Then
//
//     |w' - w| <= 4 eps P + eps M S + terms 2 eps^2 (|d'| + M)^2
//              <= 4 eps P + eps M S + 18 eps^2 M^2
//
// and flushes below 2^-700. The computed bound is twice that.

namespace {

using detail::Scratch2;
using detail::sign_of_mpz;

constexpr double kEps = 0x1p-52;

double largest_coordinate(const Point2& p) { return std::max(std::fabs(p.x), std::fabs(p.y)); }

/// Returns the sign of (b - a) x (d - c) from approximations of the four points.
FilteredSign cross_filter(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double m = std::max(std::max(largest_coordinate(a), largest_coordinate(b)),
                            std::max(largest_coordinate(c), largest_coordinate(d)));
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

// Crossings: their boxes, the filters that read these, and the stages of each predicate.
//
// Notation and bounds, for any rounding mode and under FTZ/DAZ. A prime marks what was computed.
//
//   eps = 2^-52   Every operation is off by at most eps times its result, and by 2^-1022 more if it
//                 is flushed; a subnormal input may be read as 0, which is another 2^-1022.
//   M             The largest |coordinate|, at most 2^200; beyond that no box is made.
//   h             Differences of points are off by at most h besides their rounding: 0 if all
//                 points are doubles, otherwise eps M.
//   a + t u       The crossing: u = b - a, v = d - c, s = c - a, t = num / den, num = s x v,
//                 den = u x v.
//
// A difference d of coordinates:
//     |d' - d| <= eps |d'| + h + 2^-1020.
// A cross product w of two differences, with P its permanent and S the sum of the four |d'|: the
// errors of the factors give 2 eps P + (h + 2^-1020) S and terms (eps d' + h + 2^-1020)^2, its own
// operations 2 eps P. Taken is
//     |w' - w| <= E(w) = 8 eps P + 2 h (S + h) + 2^-800,
// nearly twice what is needed in each term; 2^-800 covers 2^-1020 S < 2^-815 and every flush.
// The quotient, with D = 0.99 (|den'| - E(den)) <= |den|:
//     |t' - t| <= T = (|t'| E(den) + E(num)) / D + 2 eps |t'|.
// The sum, with r = max(|u'x|, |u'y|), is off by at most
//     (r + h) T + |t'| (eps r + h) + h + 2 eps |t' r| + eps |result| + tiny,
// where tiny is below 2^-900 for |t'| <= 2^100. (2^-1020 T is covered by r T, as D > 0 needs
// r > 2^-1003.)

namespace {

using detail::Scratch2;
using detail::sign_of_mpz;
using detail::to_rational;
using detail::Triple;

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

/// A computed value and a bound of its error, which is infinite if there is none.
struct Approximation {
  double value;
  double error;
};

/// Returns t' and T.
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

/// Returns the box of a + t u. The factor 1.01 covers the rounding of the bound itself.
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

/// Whether i and j are the indices of one of the two lines that define the crossing.
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

/// Decides by det = u x w with u = j - i and w = p - i. Every point is taken to be off by h = eps
/// M, where M <= 2^303 is the largest coordinate, the crossing's included. So |u' - u| <= eps |u'|
/// + 2 h and |w' - w| <= eps |w'| + 2 h + radius, and flushes add less than 2^-700 in all:
///     |det' - det| <= 4 eps P + |u| (radius + 2 h) + 2 h |w| + 2 h (radius + 2 h) + 2^-700,
/// with P the permanent and | | the sum of the sizes of the coordinates. The computed bound is
/// twice that, which pays for its own rounding.
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
  // A sweep computes the same crossing many times, so equal indices are tested before any
  // arithmetic.
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
