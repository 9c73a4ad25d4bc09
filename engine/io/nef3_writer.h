// Writes complexes in space as `.nef` (docs/formats.md, ".nef").
#pragma once

#include <ostream>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Lossless: read_nef3() of the text gives the same complex, on tables that hold what it uses alone: the
/// planes of the axes, those of the frame if one is used, the others, input points, constructed ones, each
/// in the order of the ids. Equal complexes on equal tables give equal bytes. Throws what `out` throws.
/// Cost: O(n); a gcd a plane.
void write_nef3(std::ostream& out, const SpaceComplex& complex);
/// The same, with a checkpoint each 64 kB.
void write_nef3(std::ostream& out, const SpaceComplex& complex, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
