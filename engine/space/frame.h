// The symbolic cube around unbounded sets: added before an operation that needs it, dropped when
// nothing reaches it.
#pragma once

#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Is there a frame?
bool has_frame(const SpaceComplex& complex);

/// Per volume: does it reach to infinity? The beyond of a frame does, too. O(n).
std::vector<std::uint8_t> unbounded_volumes(const SpaceComplex& complex);

/// The same set inside the cube. `tables` hold at least what the complex's do, under the same ids. Requires no frame.
SpaceComplex with_frame(const SpaceComplex& complex, std::shared_ptr<SpaceTables> tables,
                        Context& context);

/// Without the frame, if no facet or edge of the set reaches it. O(n).
SpaceComplex without_idle_frame(SpaceComplex complex, Context& context);

}  // namespace plumb
