// Complexes with no more planes and points in their tables than they use.
#pragma once

#include "plumb/space/space_complex.h"

namespace plumb {

/// With the planes and points in use, and no others.
SpaceComplex with_used_tables(SpaceComplex complex);

/// The same where that saves at least half, else as it is.
SpaceComplex with_tidy_tables(SpaceComplex complex);

}  // namespace plumb
