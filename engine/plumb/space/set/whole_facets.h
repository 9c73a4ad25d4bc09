// Facets that need no overlay with source triangles. Internal.
#pragma once

#include "plumb/space/set/cut_state.h"
#include "plumb/space/to_mesh.h"

namespace plumb {

/// Adds the region of a facet if it needs no overlay: if its plane has no source triangle, or one
/// that contains the facet, or if the facet is a face of a source. Otherwise returns false.
bool add_without_overlay(CutState& state, const FacetSide& side);

/// If a face of a source gets vertices inside of its edges and has channels, divides it into its
/// triangles, because a polygon with additional corners may be triangulated in another way.
bool add_triangles_of_cut_face(CutState& state, const Region& region);

}  // namespace plumb
