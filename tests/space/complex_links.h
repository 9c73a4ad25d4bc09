// The links of a complex held against the definitions in space_complex.h, in rationals. Not the
// engine's audit: another way to say the same.
#pragma once

#include <string>

#include "plumb/space/space_complex.h"

namespace plumb::testing {

/// The first link that is not as defined, or "". Facets may have holes; volumes are not looked at.
/// Vertices, edges and uses that lie on each other without being linked are not found.
std::string broken_link(const SpaceComplex& complex);

/// Six times the volume to the negative side of all facets, each counted -jump times: what a closed
/// mesh encloses.
Rational enclosed_volume(const SpaceComplex& complex, std::span<const std::int32_t> jump);

}  // namespace plumb::testing
