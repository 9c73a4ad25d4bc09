// The shortest source of a point of three planes. Implemented in point3_exact.cpp.
#pragma once

#include "plumb/predicates/space/point3_table.h"

#pragma GCC visibility push(default)
namespace plumb::exact3 {

/// Returns the same point as that of a line and a plane, which takes fewer and smaller products, if
/// two of its planes go through two common input points, as those of neighbours in a mesh do, and
/// the third is not of the frame. Otherwise returns the source itself.
PointSource as_line(const PlaneTable& planes, const PointSource& source);

}  // namespace plumb::exact3
#pragma GCC visibility pop
