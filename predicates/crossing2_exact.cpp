// Crossing2's Exact rung: integers of L limbs per coordinate, widths proved below.
//
// Each axis has its own grid (scaling an axis by a power of two changes no sign here). Coordinates
// have at most 64 L - 2 bits, so with n = 64 L a difference d of two is below 2^(n-1) in size, and:
//   w   = d d - d d                a cross product             below 2 * 2^(2n-2) = 2^(2n-1)   2 L
//   limbs q   = d w + d w                a coordinate times den      below 2^(3n-1) 3 L det = w w +
//   w w                orient2d with a crossing    below 2^(4n-1)                  4 L q w - q w
//   compare two crossings       2^(5n-2) + 2^(5n-3) < 2^(5n-1)  5 L
// (in the last line one q is a single product d w, below 2^(3n-2)). Signed, each fits its limbs.
#include <algorithm>
#include <initializer_list>

#include "plumb/predicates/decompose.h"
#include "plumb/predicates/fixed.h"
#include "plumb/predicates/point_table2.h"

namespace plumb::rung {

namespace {

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

/// The crossing a + (num / den) u.
template <int L>
struct Meeting {
  Vector<L> a;
  Vector<L> u;
  Fixed<2 * L> num;
  Fixed<2 * L> den;
};

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

/// Order of a coordinate of the crossing and i, by den (a - i) + num u.
template <int L>
Sign compare_axis(const Meeting<L>& p, Fixed<L> Vector<L>::*axis, const Fixed<L>& i) {
  const Fixed<3 * L> q = multiply(p.a.*axis - i, p.den) + multiply(p.u.*axis, p.num);
  return q.sign() * p.den.sign();
}

/// Order of a coordinate of two crossings: p = a + u n / w against q = b + v m / z, by
/// ((a - b) w + u n) z - (v m) w.
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

/// (j - i) x (a + (num / den) u - i), by den ((j - i) x (a - i)) + num ((j - i) x u).
template <int L>
Sign orient2d_in(const Grids& grids, const Point2& i, const Point2& j, const Corners& corners) {
  const Meeting<L> p = meet<L>(grids, corners);
  const Vector<L> from = lift<L>(grids, i);
  const Vector<L> line = lift<L>(grids, j) - from;
  const Fixed<4 * L> det =
      multiply(p.den, cross(line, p.a - from)) + multiply(p.num, cross(line, p.u));
  return det.sign() * p.den.sign();
}

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

/// The narrowest integers that hold `bits` per coordinate.
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
