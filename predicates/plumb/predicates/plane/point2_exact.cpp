// Exact arithmetic for points and crossings of the plane: integers of any length (Scratch2), and
// the stage of fixed-width integers of the predicates on crossings.
//
// The GMP part works on homogeneous triples of integers, as point2_exact.h describes. Each thread
// keeps one set of integers, so that a call allocates nothing once they are long enough.
//
// The fixed-width part serves crossings of lines through doubles. All coordinates of a question are
// brought onto one grid per axis and become integers of at most 64 L - 2 bits; each predicate is a
// polynomial in their differences. The widths are listed where that part begins, and proved in
// docs/design/numbers.md (Crossings in the plane).
//
// Tested by tests/predicates/point_table2_test.cpp and tests/predicates/plane_points_test.cpp.

#include "plumb/predicates/plane/point2_exact.h"

#include <algorithm>
#include <initializer_list>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/fixed.h"
#include "plumb/predicates/point_table2.h"

namespace plumb::detail {

Scratch2::Scratch2() {
  for (Slot& s : slots_) mpz_inits(s.x, s.y, s.w, nullptr);
  mpz_init(sum_);
}

Scratch2::~Scratch2() {
  for (Slot& s : slots_) mpz_clears(s.x, s.y, s.w, nullptr);
  mpz_clear(sum_);
}

Scratch2& Scratch2::fresh() {
  thread_local Scratch2 scratch;
  if (scratch.is_long_) scratch.shrink();
  scratch.used_ = 0;
  return scratch;
}

void Scratch2::shrink() {
  for (Slot& s : slots_) {
    for (mpz_ptr n : {s.x, s.y, s.w}) mpz_realloc2(n, GMP_NUMB_BITS);
  }
  mpz_realloc2(sum_, GMP_NUMB_BITS);
  is_long_ = false;
}

/// Both coordinates are multiplied by the least power of two that makes integers of them.
Triple Scratch2::point(Point2 p) {
  const Decomposed x = decompose(p.x);
  const Decomposed y = decompose(p.y);
  const int shift = std::max({0, -x.exponent, -y.exponent});
  const auto scale = [shift](mpz_ptr out, const Decomposed& d) {
    const int bits = d.exponent + shift;
    if constexpr (sizeof(long) == sizeof(std::int64_t)) {
      mpz_set_si(out, static_cast<long>(d.mantissa));
    } else {
      // The conversion is exact, because the number has at most 53 bits.
      mpz_set_d(out, static_cast<double>(d.mantissa));
    }
    mpz_mul_2exp(out, out, static_cast<mp_bitcnt_t>(bits));
  };
  Slot& s = next();
  scale(s.x, x);
  scale(s.y, y);
  scale(s.w, {1, 0});
  return own(s);
}

/// W is the product of the denominators and not their least common multiple, because a gcd would
/// cost more time than longer products.
Triple Scratch2::point(const RationalPoint2& p) {
  mpq_srcptr x = p.x.mpq();
  mpq_srcptr y = p.y.mpq();
  Slot& s = next();
  mpz_mul(s.x, mpq_numref(x), mpq_denref(y));
  mpz_mul(s.y, mpq_numref(y), mpq_denref(x));
  mpz_mul(s.w, mpq_denref(x), mpq_denref(y));
  for (mpz_srcptr n : {s.x, s.y, s.w}) note_length(n);
  return own(s);
}

Triple Scratch2::point(const PointTable2& points, std::uint32_t i) {
  if (points.is_double(i)) return point(points.approx(i));
  Slot& s = next();
  s.view = points.homogeneous(i);
  for (mpz_srcptr n : {s.view.x, s.view.y, s.view.w}) note_length(n);
  return {s.view.x, s.view.y, s.view.w};
}

/// Joins two points, or intersects two lines.
Triple Scratch2::cross(const Triple& p, const Triple& q) {
  const auto minor = [](mpz_ptr out, mpz_srcptr a, mpz_srcptr d, mpz_srcptr b, mpz_srcptr c) {
    mpz_mul(out, a, d);
    mpz_submul(out, b, c);
  };
  Slot& s = next();
  minor(s.x, p.y, q.w, p.w, q.y);
  minor(s.y, p.w, q.x, p.x, q.w);
  minor(s.w, p.x, q.y, p.y, q.x);
  return own(s);
}

Sign Scratch2::dot_sign(const Triple& l, const Triple& p) {
  mpz_mul(sum_, l.x, p.x);
  mpz_addmul(sum_, l.y, p.y);
  mpz_addmul(sum_, l.w, p.w);
  return sign_of_mpz(sum_);
}

/// p / pw - q / qw = (p qw - q pw) / (pw qw), and a quotient has the sign of the product.
Sign Scratch2::compare_quotients(mpz_srcptr p, mpz_srcptr pw, mpz_srcptr q, mpz_srcptr qw) {
  mpz_mul(sum_, p, qw);
  mpz_submul(sum_, q, pw);
  return sign_of_mpz(sum_) * sign_of_mpz(pw) * sign_of_mpz(qw);
}

Sign Scratch2::compare_xy(const Triple& p, const Triple& q) {
  const Sign by_x = compare_quotients(p.x, p.w, q.x, q.w);
  return by_x != Sign::Zero ? by_x : compare_quotients(p.y, p.w, q.y, q.w);
}

Rational to_rational(mpz_srcptr n, mpz_srcptr d) { return Rational(Integer(n), Integer(d)); }

}  // namespace plumb::detail

// The fixed-width stage of the predicates on Crossing2: integers of L limbs per coordinate.
//
// Each axis has its own grid: scaling an axis by a power of two changes no sign here. Coordinates
// have at most 64 L - 2 bits, so with n = 64 L a difference d of two is below 2^(n-1) in size, and:
//
//   w   = d d - d d   a cross product            below 2 * 2^(2n-2) = 2^(2n-1)         2 L limbs
//   q   = d w + d w   a coordinate times den     below 2 * 2^(3n-2) = 2^(3n-1)         3 L limbs
//   det = w w + w w   orient2d with a crossing   below 2 * 2^(4n-2) = 2^(4n-1)         4 L limbs
//   q w - q w         order of two crossings     below 2^(5n-2) + 2^(5n-3) < 2^(5n-1)  5 L limbs
//
// In the last line one q is a single product d w, below 2^(3n-2). With its sign each fits its
// limbs.
namespace plumb::rung {

namespace {

/// Each axis has its own grid, which contains all points that the predicate depends on.
struct Grids {
  Grid x;
  Grid y;
  void add(const Point2& p) {
    x.add(p.x);
    y.add(p.y);
  }
  int bits() const { return std::max(x.bits(), y.bits()); }
};

template <int L>
struct Vector {
  Fixed<L> x;
  Fixed<L> y;
  friend Vector operator-(const Vector& p, const Vector& q) { return {p.x - q.x, p.y - q.y}; }
};

template <int L>
Fixed<L> lift(const Grid& grid, double value) {
  if constexpr (L == 1) {
    return Fixed<1>(grid.to_int64(value));
  } else {
    return grid.to_fixed<L>(value);
  }
}

template <int L>
Vector<L> lift(const Grids& grids, const Point2& p) {
  return {lift<L>(grids.x, p.x), lift<L>(grids.y, p.y)};
}

template <int L>
Fixed<2 * L> cross(const Vector<L>& u, const Vector<L>& v) {
  return multiply(u.x, v.y) - multiply(u.y, v.x);
}

/// The crossing a + (num / den) u of the lines a b and c d.
template <int L>
struct Meeting {
  Vector<L> a;       ///< The first end of the first line.
  Vector<L> u;       ///< b - a.
  Fixed<2 * L> num;  ///< (c - a) x v with v = d - c.
  Fixed<2 * L> den;  ///< u x v. Not zero, as the lines are not parallel.
};

/// The four points that define a crossing.
struct Corners {
  Point2 a, b, c, d;
};

template <int L>
Meeting<L> meet(const Grids& grids, const Corners& p) {
  const Vector<L> a = lift<L>(grids, p.a);
  const Vector<L> c = lift<L>(grids, p.c);
  const Vector<L> u = lift<L>(grids, p.b) - a;
  const Vector<L> v = lift<L>(grids, p.d) - c;
  return {a, u, cross(c - a, v), cross(u, v)};
}

/// Returns the order of a coordinate of the crossing and i. The difference
/// a + (num / den) u - i has the sign of (den (a - i) + num u) den.
template <int L>
Sign compare_axis(const Meeting<L>& p, Fixed<L> Vector<L>::*axis, const Fixed<L>& i) {
  const Fixed<3 * L> q = multiply(p.a.*axis - i, p.den) + multiply(p.u.*axis, p.num);
  return q.sign() * p.den.sign();
}

/// Returns the order of a coordinate of two crossings, p = a + u n / w and q = b + v m / z. The
/// difference p - q has the sign of (((a - b) w + u n) z - (v m) w) w z.
template <int L>
Sign compare_axis(const Meeting<L>& p, const Meeting<L>& q, Fixed<L> Vector<L>::*axis) {
  const Fixed<3 * L> left = multiply(p.a.*axis - q.a.*axis, p.den) + multiply(p.u.*axis, p.num);
  const Fixed<3 * L> right = multiply(q.u.*axis, q.num);
  const Fixed<5 * L> det = multiply(left, q.den) - multiply(right, p.den);
  return det.sign() * p.den.sign() * q.den.sign();
}

template <int L>
Sign compare_xy_in(const Grids& grids, const Corners& corners, const Point2& i) {
  const Meeting<L> p = meet<L>(grids, corners);
  const Vector<L> q = lift<L>(grids, i);
  const Sign by_x = compare_axis(p, &Vector<L>::x, q.x);
  return by_x != Sign::Zero ? by_x : compare_axis(p, &Vector<L>::y, q.y);
}

template <int L>
Sign compare_xy_in(const Grids& grids, const Corners& first, const Corners& second) {
  const Meeting<L> p = meet<L>(grids, first);
  const Meeting<L> q = meet<L>(grids, second);
  const Sign by_x = compare_axis(p, q, &Vector<L>::x);
  return by_x != Sign::Zero ? by_x : compare_axis(p, q, &Vector<L>::y);
}

/// Returns the sign of (j - i) x (a + (num / den) u - i), which is that of
/// (den ((j - i) x (a - i)) + num ((j - i) x u)) den.
template <int L>
Sign orient2d_in(const Grids& grids, const Point2& i, const Point2& j, const Corners& corners) {
  const Meeting<L> p = meet<L>(grids, corners);
  const Vector<L> from = lift<L>(grids, i);
  const Vector<L> line = lift<L>(grids, j) - from;
  const Fixed<4 * L> det =
      multiply(p.den, cross(line, p.a - from)) + multiply(p.num, cross(line, p.u));
  return det.sign() * p.den.sign();
}

/// Whether all these points are doubles. Other points have no integers of a fixed width.
bool are_doubles(const PointTable2& points, std::initializer_list<std::uint32_t> indices) {
  if (points.all_double()) return true;
  return std::all_of(indices.begin(), indices.end(),
                     [&](std::uint32_t i) { return points.is_double(i); });
}

bool are_doubles(const PointTable2& points, const Crossing2& p) {
  return are_doubles(points, {p.a, p.b, p.c, p.d});
}

Corners corners(const PointTable2& points, const Crossing2& p, Grids& grids) {
  const Corners r{points.approx(p.a), points.approx(p.b), points.approx(p.c), points.approx(p.d)};
  for (const Point2& q : {r.a, r.b, r.c, r.d}) grids.add(q);
  return r;
}

/// Calls in_limbs<L>() with the narrowest integers that hold `bits` bits for each coordinate: 64 L
/// - 2 >= bits. Returns Unsure if two limbs are too few.
template <class InLimbs>
FilteredSign narrowest(int bits, const InLimbs& in_limbs) {
  if (bits <= 62) return filtered(in_limbs.template operator()<1>());
  if (bits <= 126) return filtered(in_limbs.template operator()<2>());
  return FilteredSign::Unsure;
}

}  // namespace

FilteredSign compare_xy_exact(const PointTable2& points, const Crossing2& p, std::uint32_t i) {
  if (!are_doubles(points, p) || !points.is_double(i)) return FilteredSign::Unsure;
  Grids grids;
  const Corners c = corners(points, p, grids);
  const Point2 q = points.approx(i);
  grids.add(q);
  return narrowest(grids.bits(), [&]<int L>() { return compare_xy_in<L>(grids, c, q); });
}

FilteredSign compare_xy_exact(const PointTable2& points, const Crossing2& p, const Crossing2& q) {
  if (!are_doubles(points, p) || !are_doubles(points, q)) return FilteredSign::Unsure;
  Grids grids;
  const Corners first = corners(points, p, grids);
  const Corners second = corners(points, q, grids);
  return narrowest(grids.bits(), [&]<int L>() { return compare_xy_in<L>(grids, first, second); });
}

FilteredSign orient2d_exact(const PointTable2& points, std::uint32_t i, std::uint32_t j,
                            const Crossing2& p) {
  if (!are_doubles(points, p) || !are_doubles(points, {i, j})) return FilteredSign::Unsure;
  Grids grids;
  const Corners c = corners(points, p, grids);
  const Point2 from = points.approx(i);
  const Point2 to = points.approx(j);
  grids.add(from);
  grids.add(to);
  return narrowest(grids.bits(), [&]<int L>() { return orient2d_in<L>(grids, from, to, c); });
}

}  // namespace plumb::rung
