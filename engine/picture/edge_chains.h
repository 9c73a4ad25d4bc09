// Edges of a complex joined into long paths, so that dashes run on over vertices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/picture/svg_text.h"
#include "plumb/plane/plane_complex.h"

namespace plumb {

/// Every edge e with kind[e] = `kind`, once. Chains end where other than two such edges meet. `at`
/// are the places of the vertices; requires no such edge to lead to infinity. Stops after
/// `max_points`; returns the number of edges left out. O(edges + vertices).
std::size_t append_chains(const PlaneComplex& complex, std::span<const std::uint8_t> kind,
                          std::uint8_t wanted, std::span<const Point2> at, std::size_t max_points,
                          PathData& path);

/// The total length of these edges.
double total_length(const PlaneComplex& complex, std::span<const std::uint8_t> kind,
                    std::uint8_t wanted, std::span<const Point2> at);

}  // namespace plumb
