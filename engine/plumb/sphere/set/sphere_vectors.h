// Vectors as planes and directions of a table, and back. Internal to engine/sphere.
#pragma once

#include "plumb/sphere/nef_sphere.h"

namespace plumb {

/// The circle with its positive side around the normal. Throws Error{BadArgument} for zero.
OrientedPlane intern_circle(PlaneTable& planes, const SphereVector& normal);

/// Names a direction by two planes. Throws Error{BadArgument} for zero.
SphereDirection intern_direction(PlaneTable& planes, const SphereVector& direction);

/// In lowest terms.
SphereVector exact_normal(const PlaneTable& planes, PlaneId circle);
SphereVector exact_direction(const PlaneTable& planes, SphereDirection u);

/// A table of the planes that the map names, with planes through the centre in their place.
std::shared_ptr<const PlaneTable> centred(const PlaneTable& planes, SphereMap& map);

}  // namespace plumb
