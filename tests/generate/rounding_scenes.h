// Subdivisions of the plane whose rounding to doubles is hard: crossings within one unit in the
// last place, thin spikes, nearly parallel long edges, huge ranges of coordinates, subnormals.
//
// A scene is made from bytes: records of kRoundingRecord bytes {how, x0, y0, x1, y1, face}. Each
// record is a segment between doubles. The low bits of `how` select how a byte becomes a
// coordinate; bit 6 marks the segment as a line of the set, bit 7 marks one end as a point.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/plane/plane_complex.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {

inline constexpr std::size_t kRoundingRecord = 6;

/// Returns the arrangement of the segments. Marks come from the bytes; the marked cells need not be
/// closed.
PlaneComplex rounding_scene(std::span<const std::uint8_t> program);

/// Returns bytes of a scene of so many segments, in which segments are alike more often than not.
std::vector<std::uint8_t> random_rounding_program(Dice& dice, std::size_t segments);

}  // namespace plumb::testing
