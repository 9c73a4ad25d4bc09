// Many half-spaces in little memory.
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

/// a x + b y + c z + d < 0 or <= 0: four doubles and a byte for each, and what is no double beside them. Append-only.
class HalfSpaceList {
 public:
  static constexpr std::size_t kBytes = 4 * sizeof(double) + 1;  ///< of a half-space of doubles

  /// Room for so many.
  void reserve(std::size_t count);
  /// The next of a, b, c, d. Throws Error{NotFinite}; nothing is added then.
  void add_number(double value);
  void add_number(Rational value);  ///< As above; any number.
  /// After four numbers.
  void end(Boundary boundary);

  std::size_t size() const { return is_open_.size(); }  ///< How many.
  /// A copy, made now. O(log n).
  HalfSpace3 operator[](std::size_t i) const;

 private:
  Rational number(std::size_t k) const;

  std::vector<double> numbers_;  ///< four for each; 0 where it is no double
  std::vector<std::uint8_t> is_open_;
  std::deque<std::pair<std::uint64_t, Rational>> exact_;  ///< by their places in numbers_
};

/// Nef3::intersection() of them.
Nef3 intersection_of(const HalfSpaceList& half_spaces, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
