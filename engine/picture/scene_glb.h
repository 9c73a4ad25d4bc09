// A scene as binary glTF 2.0: the facets for other programs. Lines and dots are left out but for the edges of
// facets, which are a second primitive.
//
//  1. vertices     one for each facet and corner, so that normals are those of facets; y points up there
//  2. primitives   triangles of each paint with its material, then the lines of each paint
//  3. node         puts scene coordinates back to those of the set, where floats can hold them
#pragma once

#include <ostream>
#include <string>

#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// O(n). Facets where a window cuts a set (Paint::Cut) are left out.
void write_scene_glb(std::ostream& out, const Scene& scene, const std::string& title);

}  // namespace plumb
#pragma GCC visibility pop
