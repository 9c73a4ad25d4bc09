// A compact list of half-spaces, from which the intersection of many half-spaces is computed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>
#include <vector>

#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// An append-only list of half-spaces a x + b y + c z + d < 0 (open) or a x + b y + c z + d <= 0
/// (closed). Each half-space takes four doubles and one byte. Coefficients that are not doubles are
/// stored in an additional list.
class HalfSpaceList {
 public:
  static constexpr std::size_t kBytes =
      4 * sizeof(double) + 1;  ///< Bytes for a half-space with four double coefficients.

  /// Reserves memory for `count` half-spaces with double coefficients.
  void reserve(std::size_t count);
  /// Appends the next coefficient. The four coefficients of a half-space are appended in the order
  /// a, b, c, d. If `value` is not finite, throws Error{NotFinite} and appends nothing.
  void add_number(double value);
  void add_number(Rational value);  ///< Appends the next coefficient, which is stored exactly.
  /// Completes a half-space. Requires that exactly four coefficients were appended since the
  /// previous call of end().
  void end(Boundary boundary);

  std::size_t size() const { return is_open_.size(); }  ///< Returns the number of half-spaces.
  /// Returns half-space i by value. O(log n).
  HalfSpace3 operator[](std::size_t i) const;

 private:
  Rational number(std::size_t k) const;

  /// Four numbers for each half-space. A number that is not a double is stored in exact_, and its
  /// entry in this array is 0.
  std::vector<double> numbers_;
  std::vector<std::uint8_t> is_open_;
  std::deque<std::pair<std::uint64_t, Rational>>
      exact_;  ///< Pairs of an index in numbers_ and a value, in ascending order.
};

/// Returns the intersection of the half-spaces. Throws what Nef3::intersection() throws.
Nef3 intersection_of(const HalfSpaceList& half_spaces, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
