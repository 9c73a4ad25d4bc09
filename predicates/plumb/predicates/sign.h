// Signs, the results of all predicates.
#pragma once

#include <cstdint>

#pragma GCC visibility push(default)
namespace plumb {

/// The sign of an exact quantity, or the result of a three-way comparison. In a comparison of a
/// with b, Negative means that a is less than b.
enum class Sign : std::int8_t { Negative = -1, Zero = 0, Positive = 1 };

/// The result of a filter stage: one of the three signs, or Unsure if the stage cannot decide.
enum class FilteredSign : std::int8_t { Negative = -1, Zero = 0, Positive = 1, Unsure = 2 };

/// Returns the sign of the negated quantity.
constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }

/// Returns the sign of the product of two quantities with the signs s and t.
constexpr Sign operator*(Sign s, Sign t) {
  return static_cast<Sign>(static_cast<int>(s) * static_cast<int>(t));
}

/// Returns the sign of a value of any type that can be compared with 0.
template <class Number>
constexpr Sign sign_of(const Number& value) {
  return value < 0 ? Sign::Negative : (value > 0 ? Sign::Positive : Sign::Zero);
}

/// Whether s is one of the three signs.
constexpr bool is_decided(FilteredSign s) { return s != FilteredSign::Unsure; }

/// Returns s as a Sign. Requires is_decided(s).
constexpr Sign decided(FilteredSign s) { return static_cast<Sign>(s); }

/// Returns s as a FilteredSign.
constexpr FilteredSign filtered(Sign s) { return static_cast<FilteredSign>(s); }

}  // namespace plumb
#pragma GCC visibility pop
