// Finds a shorter definition of a point that is the common point of three planes. The function is
// implemented in point3_exact.cpp.
#pragma once

#include "plumb/predicates/space/point3_table.h"

#pragma GCC visibility push(default)
namespace plumb::exact3 {

/// Returns a definition of the same point that needs fewer and smaller products, or `source`
/// itself. Suppose that two of the three planes are defined by triangles, and that these triangles
/// have two common input points. Then the point is the intersection of the line through these two
/// points with the third plane. This is typical of neighbouring triangles of a mesh. The function
/// returns this definition, unless the third plane belongs to the frame.
PointSource as_line(const PlaneTable& planes, const PointSource& source);

}  // namespace plumb::exact3
#pragma GCC visibility pop
