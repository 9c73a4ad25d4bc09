// Do the volumes of pieces add up to that of their set? Exact.
//
// Main flow of do_volumes_add_up():
//  1. gather   the sides of all facets between inside and outside, each with its facet's plane
//  2. cancel   a side that a facet of the other side of a cut has as well
//  3. sum      the rest, in fractions. A facet of the plane n.x + d = 0 adds -d / (3 n_k) times its
//              area seen along axis k, and an area is a sum over sides
//
// Most of the corners that cuts made are gone after 2: fractions are left for the set's own
// boundary. Cost: O(n log n), and some rational terms for each side that is left.
#pragma once

#include <optional>
#include <span>

#include "plumb/base/context.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// None where the set's volume is infinite.
std::optional<bool> do_volumes_add_up(const Nef3& set, std::span<const Nef3> pieces,
                                      Context& context);

}  // namespace plumb
