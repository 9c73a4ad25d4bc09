// Random numbers of the generators.
#pragma once

#include <cstdint>
#include <random>

namespace plumb::testing {

/// Uniform enough for test data, and the same with every standard library.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  /// A number in [low, high].
  std::int64_t between(std::int64_t low, std::int64_t high) {
    const auto width = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<std::int64_t>(engine_() % width);
  }
  /// A number in [0, size).
  std::uint32_t below(std::size_t size) { return static_cast<std::uint32_t>(engine_() % size); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace plumb::testing
