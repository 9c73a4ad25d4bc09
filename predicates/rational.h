// The public exact coordinate.
#pragma once

#include <boost/multiprecision/gmp.hpp>

#pragma GCC visibility push(default)
namespace plumb {

/// Exact rational and integer numbers, always in lowest terms (GMP underneath).
/// Never used inside a hot path: predicates work on doubles, fixed-width integers and raw mpz.
using Rational = boost::multiprecision::mpq_rational;
using Integer = boost::multiprecision::mpz_int;  ///< Exact integer numbers.

}  // namespace plumb
#pragma GCC visibility pop
