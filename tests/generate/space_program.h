// Sets of space from bytes (set_program.h): any sequence of bytes is an expression, and one with
// fewer records is a simpler one. For random tests and the fuzz target. A point is a byte, two bits
// for each of x, y, z and two that move it between the grid points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generate/set_program.h"
#include "oracle/space_set.h"

namespace plumb::testing {

/// Coordinates 0 to 3, x and y some by a half, z some by a third more.
ExactPoint3 space_program_point(ProgramValues values, std::uint8_t byte);

/// Stops at a record that would take the expression beyond `max_planes` planes.
SpaceSetPointer space_set_of_program(std::span<const std::uint8_t> program, std::size_t max_planes);

/// Points on a grid of 4 x 4 x 4, most of them.
std::vector<std::uint8_t> random_space_program(Dice& dice, ProgramValues values,
                                               std::size_t records);

}  // namespace plumb::testing
