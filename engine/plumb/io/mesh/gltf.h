// Reads glTF 2.0, binary (.glb) and text (.gltf): the triangles of all nodes, as they are placed.
//
// Main flow of read_gltf():
//  1. document   opens the document and its buffers (gltf_parts.h); it must say version 2
//  2. nodes      visits the nodes of the scene that the document names, else of its first scene,
//                else all nodes that are no children; each once
//  3. triangles  lists triangles, strips and fans of their meshes, once per mesh (gltf_parts.h).
//                Coordinates are floats, bytes or shorts, moved in doubles by the transforms of the
//                node and those above it, and once for each copy of the mesh that the node places;
//                a transform that mirrors turns triangles around. Accessors may be sparse, and data
//                may be compressed if plumb is built with the libraries (gltf_codecs.h)
//  4. weld       makes equal points one vertex (mesh_formats.h)
//
// Triangles with two equal corners are left out, with a note; so are lines, points, skins, morph
// targets, hidden nodes, other scenes, and used extensions that may change the shape
// (gltf_extensions.h). Refused are such extensions if they are required, and a file without
// triangles.
//
// Cost: O(bytes + n log n) for n triangles, counted as often as they are placed. Errors: the errors
// of gltf_parts.h and gltf_codecs.h. Errors of the document have the form "FILE: accessors[3]:
// message": Syntax, BadIndex, CountMismatch, BadShape, NumberOutOfRange; ResourceLimit; Cancelled.
#pragma once

#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/mesh/gltf_parts.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/read_options.h"

namespace plumb {

/// Returns the mesh of a glTF file. The memory of the mesh stays charged to `context`. The memory
/// of the document and of its buffers is released.
MeshFile read_gltf(std::string_view bytes, const GltfLoader& loader, const ReadOptions& options,
                   Context& context);

}  // namespace plumb
