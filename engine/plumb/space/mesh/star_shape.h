// Closed meshes that are star-shaped: from some point inside, each ray meets the surface once. Such
// a mesh does not cross itself, and it is one surface around one volume, so three later steps have
// nothing to find: components, fans and crossings. All convex meshes are star-shaped.
#pragma once

#include <span>

#include "plumb/predicates/sign.h"
#include "plumb/predicates/space/point3_table.h"
#include "plumb/space/mesh/mesh_facets.h"

namespace plumb {

/// Returns the sign of the volume of a mesh that is seen to be star-shaped around a mean of its
/// vertices; Zero if it is not seen to be so. Requires that is_plainly_closed() holds
/// (link_facets.h), that `point` has the place of each vertex in `points`, and that no two vertices
/// have equal places. O(corners), and much less for most meshes that are not star-shaped: the first
/// facet that is seen from its other side ends the test.
Sign star_orientation(const MeshFacets& facets, std::span<const SpacePoint> point,
                      const Point3Table& points);

}  // namespace plumb
