// Writes meshes as binary glTF 2.0 (docs/formats.md, "glTF"); gltf.h reads them.
//
// The file has one node with one mesh: a list of vertices, and three corners for each triangle. If
// faces have materials, each material has a primitive of its own, and its colour is written as
// numbers that glTF takes for linear. Other attributes are not written.
// Coordinates are floats and are not turned, so read_gltf() of the file returns the mesh that
// as_written() states, with equal vertices welded and vertices numbered by first use. There are no
// normals, because vertices are shared.
//
// Cost: O(bytes). Errors: BadArgument, NumberOutOfRange, CannotWrite, each before the first byte.
#pragma once

#include <iosfwd>

#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"

namespace plumb {

/// Throws Error{BadArgument} if the mesh has no faces or a face is no triangle,
/// Error{NumberOutOfRange} if a coordinate lies beyond the largest float, Error{CannotWrite} if the
/// file would have 2^32 bytes or more, and what `out` throws.
void write_glb(std::ostream& out, const PolygonMesh& mesh, const MeshAttributes& attributes = {});

/// Throws Error{BadArgument} if the mesh has no faces: a list of glTF has one element at least.
void require_faces(const PolygonMesh& mesh);

}  // namespace plumb
