#include "plumb/predicates/arithmetic/rational_sum.h"

#include <cstddef>
#include <utility>

namespace plumb {
namespace {

using Watch = std::function<void()>;

Integer odd_part(const Integer& value) { return value >> lsb(value); }

/// Returns the tree of products. Level 0 contains the numbers. Each entry of a higher level is the
/// product of two entries of the level below. If that level has an odd number of entries, the last
/// one is copied.
std::vector<std::vector<Integer>> product_tree(std::vector<Integer> numbers, const Watch& watch) {
  std::vector<std::vector<Integer>> levels = {std::move(numbers)};
  while (levels.back().size() > 1) {
    const std::vector<Integer>& below = levels.back();
    std::vector<Integer> level;
    for (std::size_t i = 0; i < below.size(); i += 2) {
      watch();
      level.push_back(i + 1 < below.size() ? Integer(below[i] * below[i + 1]) : below[i]);
    }
    levels.push_back(std::move(level));
  }
  return levels;
}

/// Returns, for each number w, the product of all other numbers modulo w. This is the product of
/// all numbers modulo w^2, divided by w. The remainders are computed down the tree.
std::vector<Integer> others_modulo(const std::vector<Integer>& numbers, const Watch& watch) {
  std::vector<std::vector<Integer>> levels = product_tree(numbers, watch);
  std::vector<Integer> remainders = std::move(levels.back());
  for (levels.pop_back(); !levels.empty(); levels.pop_back()) {
    std::vector<Integer> below;
    for (std::size_t i = 0; i < levels.back().size(); ++i) {
      watch();
      const Integer& w = levels.back()[i];
      below.push_back(remainders[i / 2] % Integer(w * w));
    }
    remainders = std::move(below);
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) remainders[i] /= numbers[i];
  return remainders;
}

/// A fraction that is known to be in lowest terms.
struct Fraction {
  Integer above, below;
};

/// Returns a + b. Requires denominators without common factors, so that the sum is in lowest terms.
Fraction coprime_sum(const Fraction& a, const Fraction& b) {
  return {a.above * b.below + b.above * a.below, a.below * b.below};
}

/// Returns a / s and b / r in lowest terms such that n / (s r) = a / s + b / r. Requires that s and
/// r have no common factors, and that their product is the denominator of `term`.
std::pair<Rational, Fraction> split(const Rational& term, const Integer& s, const Integer& r) {
  Integer a = 0;
  if (s > 1) {
    mpz_invert(a.mpz(), Integer(r % s).mpz(), s.mpz());
    a = a * numerator(term) % s;
  }
  return {Rational(a, s), {(numerator(term) - a * r) / s, r}};
}

Fraction total_of(std::vector<Fraction> fractions, const Watch& watch) {
  while (fractions.size() > 1) {
    std::vector<Fraction> sums;
    for (std::size_t i = 0; i < fractions.size(); i += 2) {
      watch();
      const bool is_alone = i + 1 == fractions.size();
      sums.push_back(is_alone ? std::move(fractions[i])
                              : coprime_sum(fractions[i], fractions[i + 1]));
    }
    fractions = std::move(sums);
  }
  return fractions.empty() ? Fraction{0, 1} : std::move(fractions.front());
}

}  // namespace

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

Rational sum_of_fractions(const std::vector<Rational>& terms, const std::function<void()>& watch) {
  RationalSum shared;
  std::vector<const Rational*> others;  // These terms have denominators that are not powers of 2.
  std::vector<Integer> odd;
  for (const Rational& term : terms) {
    Integer part = odd_part(denominator(term));
    if (part == 1) {
      shared.add(term);
    } else {
      others.push_back(&term);
      odd.push_back(std::move(part));
    }
  }
  std::vector<Fraction> lone;
  const std::vector<Integer> rest = others_modulo(odd, watch);
  for (std::size_t i = 0; i < others.size(); ++i) {
    watch();
    Integer r = odd[i];
    for (Integer g = gcd(r, rest[i]); g > 1; g = gcd(r, g)) r /= g;
    auto [first, second] = split(*others[i], denominator(*others[i]) / r, r);
    shared.add(std::move(first));
    lone.push_back(std::move(second));
  }
  const Rational with_shared = shared.total();
  Fraction sum = coprime_sum(total_of(std::move(lone), watch),
                             {numerator(with_shared), denominator(with_shared)});
  // The parts are set separately, because the constructor would search for common factors.
  Rational result;
  mpz_swap(mpq_numref(result.mpq()), sum.above.mpz());
  mpz_swap(mpq_denref(result.mpq()), sum.below.mpz());
  return result;
}

}  // namespace plumb
