// How much memory a complex takes, and complexes without unused planes and points.
#pragma once

#include <cstddef>

#include "plumb/space/space_complex.h"

namespace plumb {

/// Returns the bytes of the arrays of a complex and of its tables; for the index over planes it is
/// an estimate. Copies of a set share all of it. O(planes).
std::size_t memory_bytes(const SpaceComplex& complex);

/// Returns the bytes of the arrays alone, for a complex that shares its tables with others. O(1).
std::size_t array_bytes(const SpaceComplex& complex);

/// The bytes that a set takes besides its arrays and its tables.
inline constexpr std::size_t kBytesPerSet = 2500;

// Complexes whose tables contain only planes and points that the complex uses.

/// Returns the complex with tables that have the planes and points in use, and no others. O(size of
/// the tables).
SpaceComplex with_used_tables(SpaceComplex complex);

/// Returns the same if that saves at least about half of the planes, or three quarters of the
/// points; else the complex as it is.
SpaceComplex with_tidy_tables(SpaceComplex complex);

}  // namespace plumb
