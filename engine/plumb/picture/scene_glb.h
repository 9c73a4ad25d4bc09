// Writes a scene as binary glTF 2.0, for other programs. The file contains the facets of the scene
// and the lines that are shown. Dots are left out.
//
// Main flow of write_scene_glb:
//  1. vertices    writes a separate vertex for each corner of each facet. Facets share no vertices,
//                 so each vertex has the normal of its facet.
//  2. primitives  writes one primitive for each paint of facets, with the triangles and the
//                 material of this paint. If the scene has groups, the step writes one mesh for
//                 each group instead. In both cases, the step then writes one primitive for each
//                 paint of lines.
//  3. node        writes the rotation that makes the y-axis point upwards. It also writes the scale
//                 and the translation that map coordinates of the scene to coordinates of the set,
//                 if floats can represent these numbers.
#pragma once

#include <iosfwd>
#include <string>

#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Writes the scene. Facets where a window cuts a set (Paint::Cut) are left out. Cost: O(n) for n
/// triangles and lines. Exceptions of `out` reach the caller.
void write_scene_glb(std::ostream& out, const Scene& scene, const std::string& title);

}  // namespace plumb
#pragma GCC visibility pop
