// Sums of many rationals, without the quadratic cost of adding them one by one.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "plumb/predicates/rational.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Adds terms in a balanced tree. The sum of n fractions without a common denominator is n times as
/// long as one of them, so adding them one by one would cost n^2.
class RationalSum {
 public:
  /// Adds a term.
  void add(Rational term);
  /// Returns the sum so far.
  Rational total() const;

 private:
  std::vector<Rational> partial_;  ///< Entry i is 0 or the sum of 2^i terms.
  std::uint64_t count_ = 0;
};

/// Returns the sum of fractions whose denominators have only small factors in common, as those of
/// crossings of many lines. There the greatest common divisors of long numbers, which RationalSum
/// computes, would cost more than all else, and GMP cannot be interrupted in one. Factors that a
/// denominator shares with any other are split off first; sums of the rest are in lowest terms
/// without a gcd. Calls `watch` between long operations. O(M(n) log n) for n digits with products
/// in M(n), unless long factors are shared.
///
/// Shared factors are found by trees of products and remainders. Source: D. J. Bernstein, How to
/// find smooth parts of integers (2004).
Rational sum_of_fractions(const std::vector<Rational>& terms, const std::function<void()>& watch);

}  // namespace plumb
#pragma GCC visibility pop
