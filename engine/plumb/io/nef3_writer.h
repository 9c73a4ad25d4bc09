// Writes complexes in space as `.nef` (docs/formats.md, ".nef").
#pragma once

#include <iosfwd>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Writes a complex without loss: read_nef3() of the text returns the same complex, on tables that
/// hold only what the complex uses. The order of the tables is: the planes of the axes, the planes
/// of the frame if one of them is used, all other planes, input points, constructed points; within
/// each group the order of the ids is kept. Equal complexes on equal tables give equal bytes. There
/// is a checkpoint after each 64 kB. Throws what `out` throws. Cost: O(n), with a gcd for each
/// plane.
void write_nef3(std::ostream& out, const SpaceComplex& complex,
                Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
