// Writes a scene as binary glTF 2.0, for other programs. The file contains the facets and the edges
// of facets. The edges are a primitive of their own. Other lines and all dots are left out.
//
// Main flow of write_scene_glb:
//  1. vertices    writes a separate vertex for each corner of each facet. So each facet has its own
//                 normal. The y-axis points upwards.
//  2. primitives  writes one primitive for each paint, with the triangles and the material of this
//                 paint, and then the primitive of the lines
//  3. node        writes the transform from scene coordinates to the coordinates of the set, if
//                 floats can represent it
#pragma once

#include <iosfwd>
#include <string>

#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Writes the scene. Facets where a window cuts a set (Paint::Cut) are left out. Cost: O(n). Passes
/// on exceptions of `out`.
void write_scene_glb(std::ostream& out, const Scene& scene, const std::string& title);

}  // namespace plumb
#pragma GCC visibility pop
