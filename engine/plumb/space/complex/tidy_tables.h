// How much memory a complex takes.
#pragma once

#include <cstddef>

#include "plumb/space/space_complex.h"

namespace plumb {

/// The arrays of a complex and its tables in bytes; of the index over planes, an estimate. Copies
/// of a set share all of it. O(planes).
std::size_t memory_bytes(const SpaceComplex& complex);

/// The arrays alone, of a complex that shares its tables with others. O(1).
std::size_t array_bytes(const SpaceComplex& complex);

/// What a set takes besides its arrays and its tables.
inline constexpr std::size_t kBytesPerSet = 2500;

// Complexes with no more planes and points in their tables than they use.

/// With the planes and points in use, and no others.
SpaceComplex with_used_tables(SpaceComplex complex);

/// The same where that saves at least half, else as it is.
SpaceComplex with_tidy_tables(SpaceComplex complex);

}  // namespace plumb
