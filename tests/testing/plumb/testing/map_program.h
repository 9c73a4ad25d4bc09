// Maps from bytes: what a fuzzer mutates.
//
// A program is records of four bytes. The first chooses a map to begin with, {family, size, seed,
// ...}; each other one is an edit, {what, a, b, c}: a triangle more, a corner more or fewer, one of
// the defects of map_defects.h, tails of cycles exchanged, cycles reversed, removed or repeated,
// vertices moved or added, a change of scale. Every sequence of records is a program, so a mutator
// that keeps records whole (record_mutator.h) makes nothing but maps.
#pragma once

#include <cstdint>
#include <span>

#include "plumb/testing/test_map.h"

namespace plumb::testing {

inline constexpr std::size_t kMapRecord = 4;

/// Edits stop at the first that makes the map one that check_map must refuse, or one of more than
/// `max_corners` corners. Bytes beyond the last whole record are passed over; without one there is
/// no map.
TestMap map_of_program(std::span<const std::uint8_t> program, std::size_t max_corners);

}  // namespace plumb::testing
