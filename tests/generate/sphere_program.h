// Sets of the sphere from bytes, in the engine and in its twin: a little stack machine, so that any
// bytes are a program and neighbouring bytes are similar ones.
//
// Records of eight bytes. The first is {values, ...}; each other one pushes a set or operates on
// the sets pushed: {what, how, six vectors}. A vector is a byte, with coordinates from -2 to 2.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "oracle/sphere_check.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {

inline constexpr std::size_t kSphereRecord = 8;

/// What small coordinates are turned into. Circles stay circles, except under Tenths.
enum class SphereValues : std::uint8_t {
  Plain,
  Tenths,  ///< times 0.1, rounded: fewer circles through one point
  Thirds,  ///< divided by 3: no doubles
  Large,   ///< times 2^1000
  Uneven,  ///< x times 2^-500, z times 2^500
  Long,    ///< x times (10^30 + 1) / (10^30 + 7)
};
inline constexpr int kSphereValues = 6;

/// Runs a program with the twin beside it; stops where it would need more than `max_circles`
/// circles. Every set made is compared, the last one deeply. Empty, or the first difference and how
/// the set was made.
std::string disagreement_on_sphere(std::span<const std::uint8_t> program, std::size_t max_circles);

/// The sets left in the end, without any comparison.
std::vector<NefSphere> sets_on_sphere(std::span<const std::uint8_t> program,
                                      std::size_t max_circles);

/// Most coordinates from -1 to 1.
std::vector<std::uint8_t> random_sphere_program(Dice& dice, SphereValues values,
                                                std::size_t records);
/// Random bytes.
std::vector<std::uint8_t> wild_sphere_program(Dice& dice, std::size_t records);

}  // namespace plumb::testing
