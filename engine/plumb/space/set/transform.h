// Affine images of complexes.
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Returns the image under an invertible map. Planes are transformed exactly. An image of a point
/// is an input point if its coordinates are doubles, and otherwise a point of three planes. Every
/// map that is not dyadic makes numbers longer, by at most the length of the numbers in the map.
///
/// O(n); for a framed complex up to twelve cuts by planes besides (frame.h): none for a shift of a
/// set that meets the cube in general position, or for maps that permute axes. Throws
/// Error{BadArgument} if the matrix is singular, and the errors of the Context.
SpaceComplex transformed(const SpaceComplex& complex, const AffineMap3& map, Context& context);

}  // namespace plumb
