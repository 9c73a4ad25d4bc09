// Affine images of complexes.
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The image under an invertible map of a complex without frame. Planes are transformed exactly, points
/// stay what they are: input points where doubles hold the image, else points of three planes.
/// Numbers grow with every map that is not a dyadic one. O(n). Throws Error{BadArgument} when the matrix is
/// singular.
SpaceComplex transformed(const SpaceComplex& complex, const AffineMap3& map, Context& context);

}  // namespace plumb
