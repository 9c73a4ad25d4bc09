#include "plumb/predicates/rational_sum.h"

#include <utility>

namespace plumb {

void RationalSum::add(Rational term) {
  std::size_t level = 0;
  for (std::uint64_t carry = count_; (carry & 1U) != 0; carry >>= 1U) {
    term += partial_[level];
    partial_[level++] = 0;
  }
  if (level == partial_.size()) partial_.emplace_back(0);
  partial_[level] = std::move(term);
  ++count_;
}

Rational RationalSum::total() const {
  Rational sum = 0;
  for (const Rational& p : partial_) sum += p;
  return sum;
}

}  // namespace plumb
