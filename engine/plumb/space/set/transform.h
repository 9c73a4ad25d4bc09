// Affine images of complexes.
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The image under an invertible map. Planes are transformed exactly, points stay what they are:
/// input points where doubles hold the image, else points of three planes. Numbers grow with every
/// map that is not a dyadic one, by no more than the map's own.
///
/// O(n); of a framed complex, besides, up to twelve cuts by planes (frame.h): none for a shift of a
/// set that meets the cube in general position, or for maps that permute axes. Throws
/// Error{BadArgument} when the matrix is singular.
SpaceComplex transformed(const SpaceComplex& complex, const AffineMap3& map, Context& context);

}  // namespace plumb
