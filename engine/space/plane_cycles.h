// Boundary cycles of facets in their plane: which run around a facet, which around a hole.
#pragma once

#include "plumb/space/space_complex.h"

namespace plumb {

/// The sign of the sine of the corner of the use: Positive below half a turn, Negative above, Zero at
/// half a turn and at a full one (at the end of a slit).
Sign corner_sign(const SpaceComplex& complex, UseId u);

/// Does the cycle bound its facet from outside (rather than a hole)? Decided at its least vertex: there
/// a corner of more than half a turn belongs to a hole. O(length).
bool is_outer(const SpaceComplex& complex, UseId cycle);

/// The sign l in n_r x n_s = l (n_p x n_q), of pairs of planes that share the direction of their lines. Not Zero.
Sign same_direction(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

}  // namespace plumb
