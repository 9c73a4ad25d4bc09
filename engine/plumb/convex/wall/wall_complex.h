// A complex cut by walls, and its volumes as sets of their own (internal to walls).
#pragma once

#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/wall/wall_sight.h"
#include "plumb/space/nef3.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// The complex with the walls in its marked volumes as facets with mark kBeyond and facet_origin
/// kWallOrigin; their edges and vertices have mark kBeyond too. Walls may cross, overlap, and reach
/// out of the volumes: what is in no marked volume is left out.
///  1. unite    points that are equal become one vertex
///  2. arrange  (mesh_arrangement.h) the walls among themselves
///  3. combine  once with the complex
/// Requires polygons over `tables`, those of the complex. O((n + c) log(n + c)) for c contacts.
SpaceComplex with_walls(SpaceComplex complex, const std::shared_ptr<SpaceTables>& tables,
                        const std::vector<WallPolygon>& walls, Context& context);

/// The marked volumes of a complex, each with the marked items of its boundary that no volume
/// before it has, in minimal form. O(n log n).
std::vector<Nef3> volumes_as_sets(const SpaceComplex& complex, Context& context);

/// What is in the boundary of no marked volume.
Nef3 without_volumes(const Nef3& set, Context& context);

}  // namespace plumb
