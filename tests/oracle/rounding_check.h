// Is a rounded subdivision valid, near and consistent? By brute force: every pair of edges, and
// exact distances.
#pragma once

#include <span>
#include <string>

#include "plumb/plane/plane_complex.h"
#include "plumb/plane/plane_rounding.h"

namespace plumb::testing {

/// Returns the first way in which a subdivision is not a valid one of doubles, or "". Looks at
/// every pair of edges, and at every pair of an edge and a vertex.
std::string invalid_doubles(const PlaneComplex& complex);

/// Returns the first way in which a result of rounding is wrong, or "": it is invalid; a vertex or
/// the middle of an edge is further from the exact edges than the report says; an exact edge is
/// further from the result although nothing was left out; a point that is further from all exact
/// edges has another face than before; neighbours stand for the same face.
std::string rounding_disagreement(const PlaneComplex& exact, const RoundedSubdivision& rounded);

/// Rounds a scene of bytes (generate/rounding_scenes.h) to doubles and to a grid, as a subdivision
/// and as a set, and rounds the results again. Returns the first thing that is wrong, or "".
std::string rounding_of_program_disagreement(std::span<const std::uint8_t> program);

}  // namespace plumb::testing
