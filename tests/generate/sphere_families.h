// Sets of the sphere of any size, by rule.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/sphere/nef_sphere.h"

namespace plumb::testing {

/// Closed triangles, none near another: 3 arcs each, 1 / sqrt(count) long or so. Made without an
/// overlay, in O(count).
NefSphere scattered_triangles(std::size_t count);

/// A polygon around the z axis whose n corners lie in turn at two heights above a circle of radius
/// 1; n even. `turn`: by how many corners it is turned.
NefSphere crown(std::size_t n, double turn, double low, double high);
/// Any directions, none on a plane through two axes.
std::vector<SphereVector> any_directions(std::size_t count, std::uint64_t seed);

}  // namespace plumb::testing
