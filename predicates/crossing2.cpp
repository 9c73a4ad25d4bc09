// Predicates of PointTable2 and Crossing2.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "plumb/predicates/homogeneous2.h"
#include "plumb/predicates/point_table2.h"

namespace plumb {

namespace {

using detail::integer_sign;
using detail::Triple;
using detail::triple;

Triple line(const PointTable2& points, std::uint32_t i, std::uint32_t j) {
  return join(triple(points, i), triple(points, j));
}

Triple crossing_triple(const PointTable2& points, const Crossing2& p) {
  return meet(line(points, p.a, p.b), line(points, p.c, p.d));
}

}  // namespace

Sign compare_xy(const PointTable2& points, std::uint32_t i, std::uint32_t j) {
  return compare_xy(triple(points, i), triple(points, j));
}

Sign orient2d(const PointTable2& points, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  return dot_sign(line(points, i, j), triple(points, k));
}

Sign cross_sign(const PointTable2& points, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                std::uint32_t d) {
  return integer_sign(meet(line(points, a, b), line(points, c, d)).w);
}

Crossing2 make_crossing(const PointTable2&, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                        std::uint32_t d) {
  return {a, b, c, d, 0, 0, std::numeric_limits<double>::infinity()};
}

Sign compare_xy(const PointTable2& points, const Crossing2& p, std::uint32_t i) {
  return compare_xy(crossing_triple(points, p), triple(points, i));
}

Sign compare_xy(const PointTable2& points, const Crossing2& p, const Crossing2& q) {
  return compare_xy(crossing_triple(points, p), crossing_triple(points, q));
}

Sign orient2d(const PointTable2& points, std::uint32_t i, std::uint32_t j, const Crossing2& p) {
  const Triple at = crossing_triple(points, p);
  return dot_sign(line(points, i, j), at) * integer_sign(at.w);
}

RationalPoint2 exact(const PointTable2& points, const Crossing2& p) {
  const Triple at = crossing_triple(points, p);
  return {Rational(at.x, at.w), Rational(at.y, at.w)};
}

}  // namespace plumb
