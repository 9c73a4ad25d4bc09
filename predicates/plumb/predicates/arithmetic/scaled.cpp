#include "plumb/predicates/arithmetic/scaled.h"

#include <span>

namespace plumb {

Scaled scaled(const Integer& x) {
  if (x.is_zero()) return {};
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, x.mpz());  // The mantissa is truncated.
  return {mantissa, static_cast<int>(exponent)};
}

void append_limbs(const Integer& x, std::size_t count, std::vector<std::uint64_t>& limbs) {
  const std::size_t first = limbs.size();
  limbs.resize(first + count, 0);
  mpz_export(limbs.data() + first, nullptr, -1, sizeof(std::uint64_t), 0, 0, x.mpz());
  if (x.sign() >= 0) return;
  std::uint64_t carry = 1;
  for (std::uint64_t& limb : std::span(limbs).subspan(first)) {
    limb = ~limb + carry;
    carry = static_cast<std::uint64_t>(carry != 0 && limb == 0);
  }
}

Integer integer_from_limbs(const std::uint64_t* limbs, std::size_t count) {
  Integer result;
  mpz_import(result.mpz(), count, -1, sizeof(std::uint64_t), 0, 0, limbs);
  if (static_cast<std::int64_t>(limbs[count - 1]) < 0) {
    result -= shifted(Integer(1), static_cast<int>(64 * count));
  }
  return result;
}

}  // namespace plumb
