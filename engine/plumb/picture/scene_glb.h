// Writes a scene as binary glTF 2.0, for other programs. The file contains the facets of the scene
// and the lines that are shown. Dots are left out.
//
// Main flow of write_scene_glb:
//  1. vertices    writes a separate vertex for each corner of each facet. So the vertices of a
//                 facet have the normal of this facet.
//  2. primitives  writes one primitive for each paint of facets, with the triangles and the
//                 material of this paint. If the scene has groups, the step writes one mesh for
//                 each group instead. Then the step writes one primitive for each paint of lines.
//  3. node        writes the rotation that makes the y-axis point upwards. A scale and a
//                 translation map the coordinates of the scene to the coordinates of the set. The
//                 step also writes this scale and this translation if floats can represent them.
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
