// Places the objects of a 3MF scene: the mesh of all items of the build.
#pragma once

#include <string>

#include "plumb/base/context.h"
#include "plumb/io/mesh/threemf_model.h"
#include "plumb/io/mesh/threemf_settings.h"
#include "plumb/io/mesh_io.h"

namespace plumb {

/// Returns the mesh of a scene, in millimetres. Transforms are applied exactly: a point that is no
/// triple of doubles is in PolygonMesh::exact. A transform that mirrors turns triangles around. If
/// the scene has objects but no items, the objects of the first part that are no components are
/// placed, with a note.
///
/// Cost: O(n) operations of numbers for n placed triangles. The mesh stays charged to `context`.
/// Throws, with the place of the component or item: BadIndex if its object does not exist; BadShape
/// if an object contains itself; ResourceLimit if objects are nested more than 64 deep, or if more
/// than 2^20 objects are placed; the errors of the Context.
MeshFile build_threemf(const ThreeMfScene& scene, const ThreeMfSettings& settings,
                       const std::string& file, Context& context);

}  // namespace plumb
