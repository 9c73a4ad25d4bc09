// Reads glTF 2.0, binary (.glb) and text (.gltf): the triangles of all nodes, as they are placed.
//
//   1. the document and its buffers (gltf_parts.h); it has to say version 2
//   2. nodes of the scene it names, else of its first, else all that are no children; each once
//   3. triangles, strips and fans of their meshes (gltf_parts.h), listed once per mesh; coordinates
//      are floats, moved by the transforms of the node and those above it, in doubles. A transform
//      that mirrors turns triangles around.
//   4. equal points become one vertex (mesh_formats.h)
//
// Triangles with two equal corners are left out, and told; so are lines, points, skins and morph
// targets. Refused: sparse accessors, coordinates that are no floats, required extensions but those
// of materials, textures and lights, and a file without triangles.
//
// Cost: O(bytes + n log n) for n triangles, counted as often as they are placed. Errors: those of
// gltf_parts.h; "FILE: accessors[3]: what" for what the document says wrong: Syntax, BadIndex,
// CountMismatch, BadShape, NumberOutOfRange; ResourceLimit; Cancelled.
#pragma once

#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/mesh/gltf_parts.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/read_options.h"

namespace plumb {

/// The memory of the mesh stays charged to `context`; that of the document and its buffers is given
/// back.
MeshFile read_gltf(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
                   Context& context);

}  // namespace plumb
