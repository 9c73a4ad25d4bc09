// Many small regions, spread evenly over the sphere.
#pragma once

#include <cstddef>

#include "plumb/sphere/nef_sphere.h"

namespace plumb::testing {

/// Closed triangles, none near another: 3 arcs each, 1 / sqrt(count) long or so. Made without an overlay, in
/// O(count).
NefSphere scattered_triangles(std::size_t count);

}  // namespace plumb::testing
