// Expressions over sets of the plane from bytes (set_program.h): any bytes are an expression and
// neighbouring bytes are similar ones. A point is a byte, x its low and y its high four bits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generate/curve_scenes.h"
#include "generate/set_program.h"
#include "oracle/plane_set.h"

namespace plumb::testing {

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
