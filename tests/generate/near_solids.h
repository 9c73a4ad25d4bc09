// Solids of space that are nearly in the same places, so that rounding their Booleans is hard:
// corners some units of the last digit apart, boxes turned by tiny angles, flat tetrahedra.
//
// A scene is made from bytes: records of kNearSolidRecord bytes {how, angle, corners ...}. Bit 0 of
// `how` selects a box or a tetrahedron, bits 1 and 2 the operation, bits 3 and 4 the output, and
// bit 5 whether the next operation has the written mesh as its operand.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/space/nef3.h"
#include "plumb/space/rounded_mesh.h"
#include "plumb/space/to_mesh.h"
#include "plumb/testing/dice.h"

namespace plumb::testing {

inline constexpr std::size_t kNearSolidRecord = 14;

/// How a scene is written after an operation.
struct NearSolidOutput {
  CoordinateType type;
  MeshFaces faces;
  bool is_read_again;
};

NearSolidOutput near_solid_output(std::span<const std::uint8_t> record);

/// Returns the regularized result of the operation of a record. A tetrahedron without volume
/// changes nothing.
Nef3 apply_near_solid(const Nef3& set, std::span<const std::uint8_t> record);

/// Returns bytes of a scene of so many solids.
std::vector<std::uint8_t> random_near_solids(Dice& dice, std::size_t solids);

}  // namespace plumb::testing
