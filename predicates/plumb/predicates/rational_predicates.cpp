#include "plumb/predicates/rational_predicates.h"

#include <array>
#include <cstddef>
#include <initializer_list>

#include "plumb/predicates/input/determinants.h"
#include "plumb/predicates/input/rung_counters.h"

namespace plumb {

namespace {

/// Returns the least positive integer whose product with each of the `values` is an integer.
Integer common_denominator(std::initializer_list<const Rational*> values) {
  Integer common = 1;
  for (const Rational* v : values) common = lcm(common, Integer(denominator(*v)));
  return common;
}

Integer times(const Rational& value, const Integer& common) {
  return numerator(value) * (common / denominator(value));
}

/// Returns one coordinate of the points minus the coordinate of an origin, times `common`.
template <class... Rationals>
std::array<Integer, sizeof...(Rationals)> differences(const Integer& common, const Rational& origin,
                                                      const Rationals&... values) {
  const Integer o = times(origin, common);
  return {Integer(times(values, common) - o)...};
}

/// Returns the same differences times the common denominator of this coordinate alone.
template <class... Rationals>
auto axis_differences(const Rational& origin, const Rationals&... values) {
  return differences(common_denominator({&origin, &values...}), origin, values...);
}

}  // namespace

Sign cross_sign(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
                const RationalPoint2& d) {
  count_rung(Predicate::CrossSign, Rung::Big);
  const Rational ux = b.x - a.x, uy = b.y - a.y;
  const Rational vx = d.x - c.x, vy = d.y - c.y;
  const Rational zero;
  return rung::big_cross(axis_differences(zero, ux, vx), axis_differences(zero, uy, vy));
}

Sign orient2d(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c) {
  count_rung(Predicate::Orient2d, Rung::Big);
  return rung::big_cross(axis_differences(c.x, a.x, b.x), axis_differences(c.y, a.y, b.y));
}

Sign orient3d(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
              const RationalPoint3& d) {
  count_rung(Predicate::Orient3d, Rung::Big);
  return rung::big_orient3d(axis_differences(d.x, a.x, b.x, c.x),
                            axis_differences(d.y, a.y, b.y, c.y),
                            axis_differences(d.z, a.z, b.z, c.z));
}

Sign incircle(const RationalPoint2& a, const RationalPoint2& b, const RationalPoint2& c,
              const RationalPoint2& d) {
  count_rung(Predicate::Incircle, Rung::Big);
  const Integer common = common_denominator({&a.x, &a.y, &b.x, &b.y, &c.x, &c.y, &d.x, &d.y});
  return rung::big_incircle(differences(common, d.x, a.x, b.x, c.x),
                            differences(common, d.y, a.y, b.y, c.y));
}

Sign insphere(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
              const RationalPoint3& d, const RationalPoint3& e) {
  count_rung(Predicate::Insphere, Rung::Big);
  const Integer common = common_denominator(
      {&a.x, &a.y, &a.z, &b.x, &b.y, &b.z, &c.x, &c.y, &c.z, &d.x, &d.y, &d.z, &e.x, &e.y, &e.z});
  return rung::big_insphere(differences(common, e.x, a.x, b.x, c.x, d.x),
                            differences(common, e.y, a.y, b.y, c.y, d.y),
                            differences(common, e.z, a.z, b.z, c.z, d.z));
}

}  // namespace plumb
