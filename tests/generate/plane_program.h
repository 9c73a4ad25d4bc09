// Expressions over sets of the plane from bytes: a little stack machine, so that any bytes are an
// expression and neighbouring bytes are similar ones.
//
// Records of eight bytes. The first is {values, last operation, ...}; each other one pushes a set or
// operates on the sets pushed: {what, how, six points}. A point is a byte, x its low and y its high
// four bits. In the end all sets left are combined.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generate/curve_scenes.h"
#include "generate/dice.h"
#include "oracle/plane_set.h"

namespace plumb::testing {

inline constexpr std::size_t kProgramRecord = 8;

/// What coordinates 0 to 7, some with a half or a third, are turned into. Lines stay lines, except
/// under Tenths.
enum class ProgramValues : std::uint8_t {
  Plain,
  Tenths,  ///< times 0.1, rounded: nothing is collinear any more
  Thirds,  ///< no doubles
  Far,     ///< plus 2^60: no doubles, and their nearest ones are all the same
  Large,   ///< times 2^1000
  Small,   ///< times 2^-1060: subnormal
  Uneven,  ///< x times 2^-500, y times 2^500, z as it is
  Long,    ///< times (10^30 + 1) / (10^30 + 7)
};
inline constexpr int kProgramValues = 8;

/// Of axis 0, 1 or 2.
BigRational program_value(ProgramValues values, const BigRational& v, int axis);

ExactPoint program_point(ProgramValues values, std::uint8_t byte);

/// Stops at a record that would take the expression beyond `max_lines` lines.
PlaneSetPointer set_of_program(std::span<const std::uint8_t> program, std::size_t max_lines);

/// A scene of curves from bytes: a first record {values, ...}, then one for each curve or point,
/// {what, how, six points}. Stops after `max_curves`.
CurveScene scene_of_program(std::span<const std::uint8_t> program, std::size_t max_curves);

/// Most points on a grid of 4 x 4.
std::vector<std::uint8_t> random_program(Dice& dice, ProgramValues values, std::size_t records);
/// Random bytes.
std::vector<std::uint8_t> wild_program(Dice& dice, std::size_t records);

}  // namespace plumb::testing
