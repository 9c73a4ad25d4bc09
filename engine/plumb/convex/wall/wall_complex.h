// A complex cut by walls, and its volumes as sets of their own (internal to walls).
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/wall/wall_sight.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// Returns the complex with the walls inside its marked volumes as facets with mark kBeyond and
/// facet_origin kWallOrigin; their edges and vertices have mark kBeyond too. Walls may cross,
/// overlap, and reach out of the volumes. Parts of walls that lie in no marked volume are left out.
/// Steps: equal points become one vertex; the walls are arranged among themselves
/// (mesh_arrangement.h); the result is combined with the complex once. Requires that the polygons
/// refer to `tables`, which are the tables of the complex. Cost: O((n + c) log(n + c)) for c
/// contacts. Throws the errors of the Context.
SpaceComplex with_walls(SpaceComplex complex, const std::shared_ptr<SpaceTables>& tables,
                        const std::vector<WallPolygon>& walls, Context& context);

/// Returns the marked volumes of a complex, each with the marked cells of its boundary that no
/// volume before it has, in minimal form. Cost: O(n log n).
std::vector<Nef3> volumes_as_sets(const SpaceComplex& complex, Context& context);

/// Returns the set of the points that lie on the boundary of no marked volume.
Nef3 without_volumes(const Nef3& set, Context& context);

}  // namespace plumb
