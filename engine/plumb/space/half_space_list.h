// A compact list of half-spaces, for intersections of many half-spaces.
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
/// (closed). Each half-space takes four doubles and a byte. Numbers that are not doubles are stored
/// separately.
class HalfSpaceList {
 public:
  static constexpr std::size_t kBytes =
      4 * sizeof(double) + 1;  ///< Size of a half-space of doubles.

  /// Reserves memory for `count` half-spaces of doubles.
  void reserve(std::size_t count);
  /// Appends the next of the numbers a, b, c, d. Throws Error{NotFinite} if `value` is not finite;
  /// then nothing is appended.
  void add_number(double value);
  void add_number(Rational value);  ///< Appends the next number, exactly.
  /// Completes a half-space. Requires that four numbers were appended since the previous
  /// half-space.
  void end(Boundary boundary);

  std::size_t size() const { return is_open_.size(); }  ///< Returns the number of half-spaces.
  /// Returns half-space i by value. O(log n).
  HalfSpace3 operator[](std::size_t i) const;

 private:
  Rational number(std::size_t k) const;

  /// Four for each half-space; 0 stands for a number that is not a double.
  std::vector<double> numbers_;
  std::vector<std::uint8_t> is_open_;
  std::deque<std::pair<std::uint64_t, Rational>>
      exact_;  ///< (Index in numbers_, value), ascending.
};

/// Returns the intersection of the half-spaces. Throws what Nef3::intersection() throws.
Nef3 intersection_of(const HalfSpaceList& half_spaces, Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
