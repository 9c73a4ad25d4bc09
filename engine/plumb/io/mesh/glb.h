// Writes meshes as binary glTF 2.0 (docs/formats.md, "glTF"); gltf.h reads them.
//
// The file has one node with one mesh: a list of vertices, and three corners for each triangle. If
// faces have materials, each material has a primitive of its own, and its colour is written as
// numbers that glTF takes for linear. Colours, normals and texture coordinates of corners are
// written for vertices, which are split where corners differ. Without such channels, vertices are
// shared and have no normals. Other attributes are not written.
// Coordinates are floats and are not turned, so read_gltf() of the file returns the mesh that
// as_written() states, with equal vertices welded and vertices numbered by first use.
//
// Cost: O(bytes). Errors: BadArgument, NumberOutOfRange, CannotWrite, each before the first byte.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Throws Error{BadArgument} if the mesh has no faces or a face is no triangle,
/// Error{NumberOutOfRange} if a coordinate lies beyond the largest float, Error{CannotWrite} if the
/// file would have 2^32 bytes or more, and the exceptions of `out`.
void write_glb(std::ostream& out, const PolygonMesh& mesh, const MeshAttributes& attributes = {});

/// Throws Error{CannotWrite} with both numbers if a binary file of so many bytes is not possible:
/// its header states the length in 32 bits.
void require_glb_size(std::uint64_t bytes);

/// Returns the channels that a file of glTF holds, in the order in which they are written: colours,
/// normals, and texture coordinates that are numbered from 0 without gaps.
std::vector<const MeshChannel*> glb_channels(const MeshAttributes& attributes);

/// Throws Error{BadArgument} if the mesh has no faces: a list of glTF has one element at least.
void require_faces(const PolygonMesh& mesh);

}  // namespace plumb
#pragma GCC visibility pop
