// Conversions between the exact numbers of plumb and the exact numbers of Boost.Multiprecision. The
// conversions are meant for programs that use both libraries. This header includes 200000 lines of
// Boost's headers. Therefore no other file of plumb includes it.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/gmp.hpp>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <vector>

#include "plumb/predicates/rational.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Converts x to `Number`, which is Boost's mpz_int or cpp_int.
template <class Number>
requires std::same_as<Number, boost::multiprecision::mpz_int> ||
    std::same_as<Number, boost::multiprecision::cpp_int>
        Number to_boost(const Integer& x) {
  Number result;
  if constexpr (std::same_as<Number, boost::multiprecision::mpz_int>) {
    mpz_set(result.backend().data(), x.mpz());
  } else if (!x.is_zero()) {
    std::vector<unsigned char> bytes((mpz_sizeinbase(x.mpz(), 2) + 7) / 8);
    mpz_export(bytes.data(), nullptr, 1, 1, 0, 0, x.mpz());
    import_bits(result, bytes.begin(), bytes.end(), 8);
    if (x.sign() < 0) result = -result;
  }
  return result;
}

/// Converts x to `Number`, which is Boost's mpq_rational or cpp_rational.
template <class Number>
requires std::same_as<Number, boost::multiprecision::mpq_rational> ||
    std::same_as<Number, boost::multiprecision::cpp_rational>
        Number to_boost(const Rational& x) {
  if constexpr (std::same_as<Number, boost::multiprecision::mpq_rational>) {
    Number result;
    mpq_set(result.backend().data(), x.mpq());
    return result;
  } else {
    using boost::multiprecision::cpp_int;
    return Number(to_boost<cpp_int>(numerator(x)), to_boost<cpp_int>(denominator(x)));
  }
}

/// Converts an integer of Boost to an Integer of plumb.
inline Integer from_boost(const boost::multiprecision::mpz_int& x) {
  return Integer(x.backend().data());
}

/// Converts an integer of Boost to an Integer of plumb.
inline Integer from_boost(const boost::multiprecision::cpp_int& x) {
  std::vector<unsigned char> bytes;
  export_bits(boost::multiprecision::cpp_int(abs(x)), std::back_inserter(bytes), 8);
  Integer result;
  mpz_import(result.mpz(), bytes.size(), 1, 1, 0, 0, bytes.data());
  return x < 0 ? -result : result;
}

/// Converts a fraction of Boost to a Rational of plumb.
inline Rational from_boost(const boost::multiprecision::mpq_rational& x) {
  return Rational(x.backend().data());
}

/// Converts a fraction of Boost to a Rational of plumb.
inline Rational from_boost(const boost::multiprecision::cpp_rational& x) {
  using boost::multiprecision::cpp_int;
  return Rational(from_boost(cpp_int(numerator(x))), from_boost(cpp_int(denominator(x))));
}

}  // namespace plumb
#pragma GCC visibility pop
