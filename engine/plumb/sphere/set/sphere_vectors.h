// The conversion of vectors to planes and directions of a table, and back. Internal to
// engine/sphere.
#pragma once

#include "plumb/sphere/nef_sphere.h"

namespace plumb {

/// Returns the circle whose positive side is around the normal. Throws Error{BadArgument} for zero.
OrientedPlane intern_circle(PlaneTable& planes, const SphereVector& normal);

/// Returns two planes that define a direction. Throws Error{BadArgument} for zero.
SphereDirection intern_direction(PlaneTable& planes, const SphereVector& direction);

/// Returns the normal of a circle as integers without a common factor.
SphereVector exact_normal(const PlaneTable& planes, PlaneId circle);
/// Returns a direction as integers without a common factor.
SphereVector exact_direction(const PlaneTable& planes, SphereDirection u);

/// Returns a table of the planes to which the map refers, each moved to the centre, and makes the
/// map refer to them.
std::shared_ptr<const PlaneTable> centred(const PlaneTable& planes, SphereMap& map);

}  // namespace plumb
