// Tests exactly whether the volumes of pieces add up to the volume of their set.
//
// Main flow of do_volumes_add_up():
//  1. gather   collects the sides of all facets between inside and outside, each with its facet's
//              plane
//  2. cancel   cancels each side that a facet of the other side of a cut has as well
//  3. sum      adds up the rest as fractions. A facet of the plane n.x + d = 0 contributes -d / (3
//              n_k) times its area seen along axis k, and an area is a sum over sides
//
// Most corners that cuts made are gone after step 2, so fractions are computed for the set's own
// boundary only. Cost: O(n log n), and some rational terms for each side that is left.
#pragma once

#include <optional>
#include <span>

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// Whether the volumes of the pieces add up exactly to the volume of the set. Returns no value if
/// the volume of the set is infinite. Throws the errors of the Context.
std::optional<bool> do_volumes_add_up(const Nef3& set, std::span<const Nef3> pieces,
                                      Context& context);

}  // namespace plumb
