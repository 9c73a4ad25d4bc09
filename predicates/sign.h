// The answer of every predicate.
#pragma once

#include <cstdint>

#pragma GCC visibility push(default)
namespace plumb {

/// Sign of an exact quantity. Also the answer of three-way comparisons: Negative = less.
enum class Sign : std::int8_t { Negative = -1, Zero = 0, Positive = 1 };

/// Answer of a filter rung: the three signs, or "this rung cannot tell".
enum class FilteredSign : std::int8_t { Negative = -1, Zero = 0, Positive = 1, Unsure = 2 };

/// The sign of the negative.
constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }

/// The sign of the product.
constexpr Sign operator*(Sign s, Sign t) {
  return static_cast<Sign>(static_cast<int>(s) * static_cast<int>(t));
}

/// Sign of any signed arithmetic value (or anything comparable with 0).
template <class Number>
constexpr Sign sign_of(const Number& value) {
  return value < 0 ? Sign::Negative : (value > 0 ? Sign::Positive : Sign::Zero);
}

/// Is it one of the three signs?
constexpr bool is_decided(FilteredSign s) { return s != FilteredSign::Unsure; }

/// Requires is_decided(s).
constexpr Sign decided(FilteredSign s) { return static_cast<Sign>(s); }

constexpr FilteredSign filtered(Sign s) {
  return static_cast<FilteredSign>(s);
}  ///< The same sign.

}  // namespace plumb
#pragma GCC visibility pop
