// Bringing a complex into minimal form after marks were changed: items that do not differ from what is
// around them go.
//
// Main flow of simplified():
//  1. look      flat passes over facets, edges and vertices: what goes?
//  2. merge     at most edges between facets of one plane, and places inside edges: joined as they lie in the arrays
//               (merge_coplanar.h)
//  3. carry     else the map of every vertex is simplified and put into a draft (vertex_carrier.h)
//  4. join      (space_draft.h)
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The same set in minimal form. O(n); a minimal complex is given back as it is.
SpaceComplex simplified(SpaceComplex complex, Context& context);

/// The same by steps 3 and 4 alone, whatever goes; several times as long where step 2 would do.
SpaceComplex simplified_by_maps(const SpaceComplex& complex, Context& context);

}  // namespace plumb
