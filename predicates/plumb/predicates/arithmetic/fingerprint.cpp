#include "plumb/predicates/arithmetic/fingerprint.h"

#include <algorithm>

namespace plumb {

Residue Residue::of(const Integer& value) {
  if constexpr (sizeof(unsigned long) == sizeof(std::uint64_t)) {
    return raw(mpz_fdiv_ui(value.mpz(), static_cast<unsigned long>(kModulus)));
  }
  // On Windows, and if words have 32 bits, the functions of GMP for built-in integers take integers
  // that are too short.
  const Integer modulus(kModulus);
  Integer remainder;
  mpz_fdiv_r(remainder.mpz(), value.mpz(), modulus.mpz());
  return raw(static_cast<std::uint64_t>(remainder));
}

namespace {

/// Returns x^(2^k).
Residue square_times(Residue x, int k) {
  for (int i = 0; i < k; ++i) x = x * x;
  return x;
}

}  // namespace

/// By Fermat's little theorem the inverse is x^(q - 2), and q - 2 = 2^61 - 3 = 4 (2^59 - 1) + 1.
/// With t_k = x^(2^k - 1), t_(j + k) = t_j^(2^k) t_k.
Residue Residue::inverse() const {
  const Residue t1 = *this;
  const Residue t2 = square_times(t1, 1) * t1;
  const Residue t4 = square_times(t2, 2) * t2;
  const Residue t8 = square_times(t4, 4) * t4;
  const Residue t16 = square_times(t8, 8) * t8;
  const Residue t32 = square_times(t16, 16) * t16;
  const Residue t48 = square_times(t32, 16) * t16;
  const Residue t56 = square_times(t48, 8) * t8;
  const Residue t58 = square_times(t56, 2) * t2;
  const Residue t59 = square_times(t58, 1) * t1;
  return square_times(t59, 2) * t1;
}

/// A single inversion is enough (Montgomery's trick): scratch[i] is the product of the nonzero
/// values before i. (P. L. Montgomery, Speeding the Pollard and elliptic curve methods of
/// factorization, Mathematics of Computation 48, 1987.)
void invert_all(std::span<Residue> values, std::span<Residue> scratch) {
  Residue product = Residue::of(std::uint64_t{1});
  for (std::size_t i = 0; i < values.size(); ++i) {
    scratch[i] = product;
    if (!values[i].is_zero()) product = product * values[i];
  }
  Residue inverse = product.inverse();
  for (std::size_t i = values.size(); i-- > 0;) {
    if (values[i].is_zero()) continue;
    const Residue here = inverse * scratch[i];
    inverse = inverse * values[i];
    values[i] = here;
  }
}

IntegerRow primitive(const IntegerRow& row) {
  Integer divisor = 0;
  for (const Integer& x : row) {
    divisor = gcd(divisor, x);
    if (divisor == 1) return row;
  }
  IntegerRow result = row;
  for (Integer& x : result) x /= divisor;
  return result;
}

Fingerprint fingerprint(const IntegerRow& row) {
  const auto residues = [](const IntegerRow& r) {
    return ResidueRow{Residue::of(r[0]), Residue::of(r[1]), Residue::of(r[2]), Residue::of(r[3])};
  };
  const ResidueRow direct = residues(row);
  const bool usable = !leading(direct).is_zero();
  return fingerprint(usable ? direct : residues(primitive(row)));
}

}  // namespace plumb
