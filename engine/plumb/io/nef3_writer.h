// Writes complexes in space as `.nef` (docs/formats.md, ".nef").
#pragma once

#include <iosfwd>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Writes a complex without loss: read_nef3() returns the same complex from the written text.
/// Planes and points that the complex does not use are not written. The planes and points that the
/// complex uses are written in this order:
///   1. the planes of the axes
///   2. the planes of the frame, if at least one of them is used
///   3. all other planes
///   4. the input points
///   5. the constructed points
/// Within each of these groups, planes or points keep the order of their ids. The output is
/// deterministic: equal complexes whose tables of planes and points are equal give equal bytes. The
/// writer calls Context::checkpoint() after each 64 kB. Exceptions of `out` reach the caller. Cost:
/// O(n) for n cells, planes and points, plus the computation of one greatest common divisor for
/// each plane.
void write_nef3(std::ostream& out, const SpaceComplex& complex,
                Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
