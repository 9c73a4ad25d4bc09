// Fingerprints of planes, lines and points. A fingerprint is a hash value in a 64-bit word. A row
// is the list of the exact coefficients of an object, such as (a, b, c, d) for a plane or (x, y, z,
// w) for a point. Equal objects have equal fingerprints, even if their rows differ by a common
// factor.
//
// To compute a fingerprint, the row is reduced modulo the prime q = 2^61 - 1 and divided by its
// first nonzero residue. The result is the same for every multiple of the row, and no greatest
// common divisor (gcd) is needed. Hence
//
//   different fingerprints  prove that the objects differ;
//   equal fingerprints      mean that the objects are very likely equal. An exact comparison must
//                           confirm the equality, because different numbers, such as 1 and 2^61,
//                           can have the same residue.
//
// If the common factor of a row is a multiple of q, all residues of the row are 0. Such a row is
// first divided by its gcd; the result has a nonzero residue.
//
// Cost: a product in F_q takes about 2 ns. A single inversion takes 150 ns. In a batch, each
// inversion takes as long as 3 products. Dividing the row by its gcd instead would take 700 ns.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "plumb/predicates/rational.h"

#pragma GCC visibility push(default)
namespace plumb {

/// An element of the field F_q with q = 2^61 - 1, always reduced to [0, q).
class Residue {
 public:
  static constexpr int kBits = 61;
  static constexpr std::uint64_t kModulus = (std::uint64_t{1} << kBits) - 1;

  constexpr Residue() = default;
  /// Returns `value` modulo q.
  static constexpr Residue of(std::uint64_t value) {
    return reduced((value & kModulus) + (value >> kBits));
  }
  /// Returns the exact residue of a finite double m * 2^e. The exponent e may have any value. Since
  /// 2^61 = 1 in F_q, the factor 2^e rotates the 61-bit word of m. The result is right under FTZ
  /// and DAZ, because the function uses bit operations only.
  static constexpr Residue of(double value);
  static Residue of(const Integer& value);
  /// Returns 2^exponent, for any exponent.
  static constexpr Residue power_of_two(int exponent) {
    return raw(std::uint64_t{1} << modulo_bits(exponent));
  }

  constexpr std::uint64_t value() const { return value_; }
  constexpr bool is_zero() const { return value_ == 0; }
  /// Returns the inverse. The inverse of zero is defined as zero.
  Residue inverse() const;

  friend constexpr Residue operator+(Residue a, Residue b) { return reduced(a.value_ + b.value_); }
  friend constexpr Residue operator-(Residue a, Residue b) {
    return reduced(a.value_ + kModulus - b.value_);
  }
  friend constexpr Residue operator-(Residue a) { return reduced(kModulus - a.value_); }
  friend constexpr Residue operator*(Residue a, Residue b);
  // The following two functions return a b - c d and a b + c d + e f. Each function reduces modulo
  // q only once.
  friend constexpr Residue cross_product(Residue a, Residue b, Residue c, Residue d);
  friend constexpr Residue sum_of_products(Residue a, Residue b, Residue c, Residue d, Residue e,
                                           Residue f);
  friend constexpr bool operator==(Residue, Residue) = default;

 private:
  static constexpr Residue raw(std::uint64_t value) {
    Residue r;
    r.value_ = value;
    return r;
  }
  /// Requires value <= 2 q.
  static constexpr Residue reduced(std::uint64_t value) {
    return raw(value >= kModulus ? value - kModulus : value);
  }
  /// Returns exponent mod 61, in [0, 61). The function first adds 61 * 2^20, which makes every
  /// exponent that occurs positive.
  static constexpr unsigned modulo_bits(int exponent) {
    return static_cast<unsigned>(exponent + kBits * (1 << 20)) % kBits;
  }

  std::uint64_t value_ = 0;
};

constexpr Residue Residue::of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto field = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  const std::uint64_t m = fraction | (static_cast<std::uint64_t>(field != 0) << 52);
  // m 2^(max(field, 1) - 1075), and -1075 = 23 modulo 61.
  const unsigned turn = static_cast<unsigned>(field + static_cast<int>(field == 0) + 23) % kBits;
  // Since m < 2^53, not all 61 bits are set, and the rotated word is less than q.
  const std::uint64_t r = ((m << turn) & kModulus) | (m >> (kBits - turn));
  return (bits >> 63) != 0 ? -raw(r) : raw(r);
}

#ifdef PLUMB_PORTABLE
/// Multiplies without 128-bit products. Let a = a1 2^31 + a0 and b = b1 2^31 + b0 with a1, b1 <
/// 2^30. The product is a1 b1 2^62 + (a1 b0 + a0 b1) 2^31 + a0 b0. In F_q, 2^62 = 2. The factor of
/// the middle term is written as h 2^30 + l with l < 2^30, so that (h 2^30 + l) 2^31 = h + l 2^31.
/// The sum of all terms is below 2^61 + 2^32 + 2^61 + 2^62 < 2^64.
constexpr Residue operator*(Residue a, Residue b) {
  constexpr std::uint64_t kLow31 = (std::uint64_t{1} << 31) - 1;
  constexpr std::uint64_t kLow30 = (std::uint64_t{1} << 30) - 1;
  const std::uint64_t a1 = a.value_ >> 31, a0 = a.value_ & kLow31;
  const std::uint64_t b1 = b.value_ >> 31, b0 = b.value_ & kLow31;
  const std::uint64_t middle = a1 * b0 + a0 * b1;
  return Residue::of(2 * a1 * b1 + (middle >> 30) + ((middle & kLow30) << 31) + a0 * b0);
}

constexpr Residue cross_product(Residue a, Residue b, Residue c, Residue d) {
  return a * b - c * d;
}
constexpr Residue sum_of_products(Residue a, Residue b, Residue c, Residue d, Residue e,
                                  Residue f) {
  return a * b + c * d + e * f;
}
#else
namespace detail {
__extension__ typedef unsigned __int128 WideProduct;
constexpr WideProduct wide_product(std::uint64_t a, std::uint64_t b) {
  return static_cast<WideProduct>(a) * b;  // < 2^122 for residues
}
/// Returns a number below 2 q + 8 that equals x modulo q. It is the sum of the three 61-bit digits
/// of x. Requires x < 2^125, so that the highest digit is below 8.
constexpr std::uint64_t folded(WideProduct x) {
  return (static_cast<std::uint64_t>(x) & Residue::kModulus) +
         (static_cast<std::uint64_t>(x >> Residue::kBits) & Residue::kModulus) +
         static_cast<std::uint64_t>(x >> (2 * Residue::kBits));
}
}  // namespace detail

constexpr Residue operator*(Residue a, Residue b) {
  const auto product = detail::wide_product(a.value_, b.value_);
  return Residue::reduced((static_cast<std::uint64_t>(product) & Residue::kModulus) +
                          static_cast<std::uint64_t>(product >> Residue::kBits));
}
constexpr Residue cross_product(Residue a, Residue b, Residue c, Residue d) {
  return Residue::of(detail::folded(detail::wide_product(a.value_, b.value_) +
                                    detail::wide_product(c.value_, Residue::kModulus - d.value_)));
}
constexpr Residue sum_of_products(Residue a, Residue b, Residue c, Residue d, Residue e,
                                  Residue f) {
  return Residue::of(detail::folded(detail::wide_product(a.value_, b.value_) +
                                    detail::wide_product(c.value_, d.value_) +
                                    detail::wide_product(e.value_, f.value_)));
}
#endif

/// Replaces every element by its inverse; zeros stay zero. Requires that `scratch` has at least as
/// many elements as `values`. Cost: one inversion in all, and three products for each element.
void invert_all(std::span<Residue> values, std::span<Residue> scratch);

/// A hash value of an object, as described above. Its low 61 bits are distributed uniformly enough
/// for use in hash tables.
using Fingerprint = std::uint64_t;

/// A homogeneous row modulo q.
using ResidueRow = std::array<Residue, 4>;

/// The six coordinates of a line modulo q.
using LineResidues = std::array<Residue, 6>;

/// Returns the first nonzero residue of a row, or zero if all residues are zero.
template <std::size_t N>
constexpr Residue leading(const std::array<Residue, N>& row) {
  for (const Residue r : row) {
    if (!r.is_zero()) return r;
  }
  return {};
}

/// Returns the fingerprint of a row, which is sum_i k_i (r_i / l). Here r_i are the residues of the
/// row, k_i are weights, and l is the leading residue, whose inverse the caller passes. The sum
/// equals (sum_i k_i r_i) / l, so one product with the inverse suffices. For random weights, two
/// different rows would have the same fingerprint with a probability of about 1/q. The weights of
/// this function are fixed.
constexpr Fingerprint fingerprint(const ResidueRow& row, Residue inverse_of_leading) {
  constexpr std::array<std::uint64_t, 4> kWeights = {0x0b7e151628aed2a6, 0x1f4bf70c11a8a4d1,
                                                     0x18a9e0a1d2c5b3f7, 0x046d1f2a9c83e5b1};
  const auto k = [&](std::size_t i) { return Residue::of(kWeights[i]); };
  const Residue sum = row[0] * k(0) + sum_of_products(row[1], k(1), row[2], k(2), row[3], k(3));
  return (sum * inverse_of_leading).value();
}

/// Returns the fingerprint of one row. Requires a nonzero leading residue. Cost: one inversion.
inline Fingerprint fingerprint(const ResidueRow& row) {
  return fingerprint(row, leading(row).inverse());
}

/// Returns the fingerprint of a line. Requires a nonzero leading residue. Cost: one inversion.
inline Fingerprint fingerprint(const LineResidues& row) {
  constexpr std::array<std::uint64_t, 6> kWeights = {0x12f8b1a9d3c7e645, 0x0d51c2e7f9a83b64,
                                                     0x1a6b93f08e2d4c57, 0x07c4e5d1b8f23a9d,
                                                     0x159e7a3c6d0b84f2, 0x0f3d28c6a1957e4b};
  const auto k = [&](std::size_t i) { return Residue::of(kWeights[i]); };
  const Residue sum = sum_of_products(row[0], k(0), row[1], k(1), row[2], k(2)) +
                      sum_of_products(row[3], k(3), row[4], k(4), row[5], k(5));
  return (sum * leading(row).inverse()).value();
}

/// An exact homogeneous row.
using IntegerRow = std::array<Integer, 4>;

/// Returns the row divided by the gcd of its elements, with unchanged signs. Requires a row that is
/// not zero.
IntegerRow primitive(const IntegerRow& row);

/// Returns the fingerprint of an exact row, even if all its residues are zero. Requires a row that
/// is not zero.
Fingerprint fingerprint(const IntegerRow& row);

}  // namespace plumb
#pragma GCC visibility pop
