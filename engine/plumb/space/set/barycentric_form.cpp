#include "plumb/space/set/barycentric_form.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/nearest_quotient.h"
#include "plumb/predicates/arithmetic/scaled.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

using Row3 = std::array<Integer, 3>;

Row3 seen(const FlatView& view, const IntegerRow& point) {
  return {point[view.coordinate(0)], point[view.coordinate(1)], point[3]};
}

Integer dot(const Row3& a, const Row3& b) {
  Integer sum = a[0] * b[0];
  mpz_addmul(sum.mpz(), a[1].mpz(), b[1].mpz());
  mpz_addmul(sum.mpz(), a[2].mpz(), b[2].mpz());
  return sum;
}

Row3 cross(const Row3& a, const Row3& b) {
  Row3 result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    result[i] = a[j] * b[k];
    mpz_submul(result[i].mpz(), a[k].mpz(), b[j].mpz());
  }
  return result;
}

/// The leading 192 bits of the absolute value of a number, or slightly fewer, times 2^scale. The
/// function top_bits() uses 106 of them.
struct Leading {
  Fixed<4> limbs;
  int scale;
};

Leading leading_of(const Integer& number) {
  static_assert(GMP_NUMB_BITS == 64 || GMP_NUMB_BITS == 32);
  constexpr std::size_t kParts = 64 / GMP_NUMB_BITS, kTaken = 3 * kParts;
  const std::size_t size = mpz_size(number.mpz());
  const std::size_t first = size > kTaken ? size - kTaken : 0;
  std::array<std::uint64_t, 4> limbs{};
  for (std::size_t i = first; i < size; ++i) {
    const std::uint64_t limb = mpz_getlimbn(number.mpz(), static_cast<mp_size_t>(i));
    limbs[(i - first) / kParts] |= limb << ((i - first) % kParts * GMP_NUMB_BITS);
  }
  return {Fixed<4>::from_limbs(limbs.data()), static_cast<int>(first * GMP_NUMB_BITS)};
}

/// Returns the double that is nearest to a quotient. The numbers are passed to a Rational without
/// removing common factors, which does not matter for the division.
double nearest_by_division(Integer numerator, Integer denominator) {
  Rational lent;
  mpz_swap(mpq_numref(lent.mpq()), numerator.mpz());
  mpz_swap(mpq_denref(lent.mpq()), denominator.mpz());
  const double result = nearest_double(lent);
  mpz_swap(mpq_numref(lent.mpq()), numerator.mpz());
  mpz_swap(mpq_denref(lent.mpq()), denominator.mpz());
  return result;
}

}  // namespace

void BarycentricWeights::move_inside() {
  denominator = 0;
  for (Integer& n : numerator) {
    if (n.sign() < 0) n = 0;
    denominator += n;
  }
}

std::array<double, 3> BarycentricWeights::rounded() const {
  std::array<double, 3> result{};
  const bool has_filter = rounds_to_nearest();
  const Leading below = leading_of(denominator);
  const TwofoldScaled divisor = top_bits(below.limbs);
  for (std::size_t i = 0; i < 3; ++i) {
    if (numerator[i].is_zero()) continue;
    // The quotient of the leading bits is sufficient in nearly all cases.
    if (has_filter) {
      const Leading above = leading_of(numerator[i]);
      result[i] = nearest_quotient(above.limbs, divisor, above.scale - below.scale);
      if (numerator[i].sign() < 0) result[i] = -result[i];
    }
    if (result[i] == 0) result[i] = nearest_by_division(numerator[i], denominator);
  }
  return result;
}

std::array<Rational, 3> BarycentricWeights::exact() const {
  return {Rational(numerator[0], denominator), Rational(numerator[1], denominator),
          Rational(numerator[2], denominator)};
}

BarycentricWeights weights_on_edge(const std::array<const Point3*, 3>& corners, std::size_t i,
                                   const IntegerRow& point) {
  const std::size_t j = (i + 1) % 3;
  const std::array<double, 3> p{corners[i]->x, corners[i]->y, corners[i]->z};
  const std::array<double, 3> q{corners[j]->x, corners[j]->y, corners[j]->z};
  std::size_t axis = 0;
  while (p[axis] == q[axis]) ++axis;
  const int low = std::min({decompose(p[axis]).exponent, decompose(q[axis]).exponent, 0});
  const Integer from = to_integer(p[axis], low), to = to_integer(q[axis], low);
  // With X the coordinate of the point times w, the weight of corner j is (X - w p) / (w (q - p)).
  BarycentricWeights weights;
  weights.denominator = point[3] * (to - from);
  weights.numerator[j] = shifted(point[axis], -low);
  mpz_submul(weights.numerator[j].mpz(), point[3].mpz(), from.mpz());
  if (weights.denominator.sign() < 0) {
    weights.denominator.negate();
    weights.numerator[j].negate();
  }
  weights.numerator[i] = weights.denominator - weights.numerator[j];
  return weights;
}

BarycentricForm::BarycentricForm(FlatView view, const std::array<IntegerRow, 3>& corners)
    : view_(view) {
  const std::array<Row, 3> c{seen(view, corners[0]), seen(view, corners[1]),
                             seen(view, corners[2])};
  for (std::size_t i = 0; i < 2; ++i) form_[i] = cross(c[i + 1], c[(i + 2) % 3]);
  area_ = dot(c[0], form_[0]);
  const bool is_negative = area_.sign() < 0;
  if (is_negative) area_.negate();
  for (std::size_t i = 0; i < 2; ++i) {
    for (Integer& factor : form_[i]) {
      factor *= c[i][2];
      if (is_negative) factor.negate();
    }
  }
}

BarycentricWeights BarycentricForm::at(const IntegerRow& point) const {
  const Row x = seen(view_, point);
  BarycentricWeights weights;
  weights.denominator = x[2] * area_;
  weights.numerator[2] = weights.denominator;
  for (std::size_t i = 0; i < 2; ++i) {
    weights.numerator[i] = dot(form_[i], x);
    weights.numerator[2] -= weights.numerator[i];
  }
  return weights;
}

}  // namespace plumb
