// Sums of many rationals.
#pragma once

#include <cstdint>
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

}  // namespace plumb
#pragma GCC visibility pop
