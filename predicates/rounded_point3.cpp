#include "plumb/predicates/rounded_point3.h"

#include "plumb/predicates/point3_exact.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

/// Rounding divides; that a common factor is left in numerator and denominator does not matter there.
RoundedDouble round_quotient(Integer& numerator, Integer& denominator, Rational& scratch) {
  mpq_ptr q = scratch.backend().data();
  mpz_swap(mpq_numref(q), numerator.backend().data());
  mpz_swap(mpq_denref(q), denominator.backend().data());
  const RoundedDouble result = round_to_double(scratch);
  mpz_swap(mpq_numref(q), numerator.backend().data());
  mpz_swap(mpq_denref(q), denominator.backend().data());
  return result;
}

}  // namespace

RoundedPoint3 rounded(const Point3Table& points, SpacePoint x) {
  if (x.is_input()) return {points.planes().point(x.input()), true};
  IntegerRow row = exact3::integer_row(exact3::operand(points, x));
  if (row[3] < 0) {
    for (Integer& c : row) c = -c;
  }
  Rational scratch;
  std::array<RoundedDouble, 3> c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = round_quotient(row[i], row[3], scratch);
  const auto is_exact = [&](std::size_t i) { return c[i].error == Sign::Zero; };
  return {{c[0].value, c[1].value, c[2].value}, is_exact(0) && is_exact(1) && is_exact(2)};
}

}  // namespace plumb
