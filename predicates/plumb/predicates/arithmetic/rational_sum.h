// Sums of many rationals.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "plumb/predicates/rational.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Adds terms in a balanced tree: the sum of n fractions without common denominator is n times as
/// long as one of them, and adding them one by one would cost n^2.
class RationalSum {
 public:
  void add(Rational term);
  Rational total() const;

 private:
  std::vector<Rational> partial_;  ///< entry i is 0 or the sum of 2^i terms
  std::uint64_t count_ = 0;
};

/// The same where denominators have but small factors in common, as those of crossings of many
/// lines: there the greatest common divisors of long numbers, which RationalSum finds, cost more
/// than all else, and no one can interrupt GMP in one. Factors that a denominator shares with any
/// other are split off first; what is left is lowest terms without them. `watch` is called between
/// long operations. O(M(n) log n) for n digits and products in M(n), unless long factors are
/// shared.
///
/// Source of the search for shared factors: Bernstein, "How to find the coprime parts of integers"
/// (2004), by trees of products and remainders.
Rational sum_of_fractions(const std::vector<Rational>& terms, const std::function<void()>& watch);

}  // namespace plumb
#pragma GCC visibility pop
