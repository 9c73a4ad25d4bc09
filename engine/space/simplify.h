// Bringing a complex into minimal form after marks were changed: items that do not differ from what is
// around them go.
//
// Main flow of simplified():
//  1. look      is it minimal already? Flat passes over facets, edges and vertices; sphere maps are made only
//               of vertices with exactly two half-edges, which may be places inside an edge
//  2. carry     else the map of every vertex is simplified and put into a draft (vertex_carrier.h)
//  3. join      (space_draft.h)
#pragma once

#include "plumb/base/context.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The same set in minimal form. O(n); a minimal complex is given back as it is.
SpaceComplex simplified(SpaceComplex complex, Context& context);

}  // namespace plumb
