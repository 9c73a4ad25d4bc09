// Writes a scene as binary glTF 2.0, for other programs. The file holds the facets and, as a second
// primitive, the edges of facets; other lines and all dots are left out.
//
// Main flow of write_scene_glb:
//  1. vertices    writes one vertex for each facet and corner, so that normals are per facet; y
//                 points upwards
//  2. primitives  writes the triangles of each paint with its material, then the lines
//  3. node        maps scene coordinates back to those of the set, if floats can hold them
#pragma once

#include <iosfwd>
#include <string>

#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Writes the scene. Facets where a window cuts a set (Paint::Cut) are left out. Cost: O(n). Throws
/// what `out` throws.
void write_scene_glb(std::ostream& out, const Scene& scene, const std::string& title);

}  // namespace plumb
#pragma GCC visibility pop
