// Computes sums of many rationals. The functions of this header avoid the quadratic cost of adding
// the rationals one by one.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "plumb/predicates/rational.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Adds terms in a balanced tree. If the denominators of n fractions have no common factors, the
/// sum has about n times as many digits as a single fraction. Therefore adding the fractions one by
/// one would take O(n^2) time.
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

/// Returns the sum of fractions whose denominators have only small common factors, such as the
/// coordinates of crossings of many lines. For such fractions, RationalSum would spend most of its
/// time on greatest common divisors (gcd) of long numbers. In addition, GMP cannot be interrupted
/// during a gcd. This function first splits each fraction into two parts, such that the factors
/// that its denominator shares with other denominators are in one part. The sums of the other parts
/// are always in lowest terms, so no gcd is needed for them. Between long operations, the function
/// calls `watch`, which may throw to stop the computation. Let n be the number of digits of all
/// terms, and M(n) the cost of a product of n digits. Cost: O(M(n) log n), unless the denominators
/// share long factors.
///
/// The shared factors are found by product trees and remainder trees. Source: D. J. Bernstein, How
/// to find smooth parts of integers (2004).
Rational sum_of_fractions(const std::vector<Rational>& terms, const std::function<void()>& watch);

}  // namespace plumb
#pragma GCC visibility pop
