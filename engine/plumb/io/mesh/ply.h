// Reads PLY, text and binary of either byte order (docs/formats.md, "PLY"): vertices with
// properties x, y and z of any type, faces with a list vertex_indices (or vertex_index); other
// properties and elements, in any order, are passed over and told.
//
//  1. read_ply_header   what there is (ply_header.h); claims are checked against the bytes that
//                       follow
//  2. the elements in their order: in a text each on a line of its own; in a binary file without
//     gaps
//  3. nothing may follow the last one
//
// Cost: O(bytes). Errors in the header and in a text are thrown with the place (file, line,
// column), in binary parts with the number of the byte: NotText, Syntax, NumberOutOfRange,
// CountMismatch, BadIndex, DegenerateFace (fewer than three corners, a vertex twice in a row),
// UnknownFormat, ResourceLimit; Cancelled.
#pragma once

#include <cstdint>
#include <ostream>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/read_options.h"
#include "plumb/space/mesh_arrays.h"

namespace plumb {

/// The memory of the mesh stays charged to `context`.
MeshFile read_ply(std::string_view bytes, const ReadOptions& options, Context& context);

// Writes meshes as PLY, binary or text (docs/formats.md, "PLY").

/// read_ply() of what is written gives the same mesh, but for what `exact` holds: vertices are
/// rounded to doubles. Both throw Error{NumberOutOfRange} when one lies beyond the largest double;
/// what `out` throws.
void write_ply_text(std::ostream& out, const PolygonMesh& mesh);
/// Little-endian.
void write_ply_binary(std::ostream& out, const PolygonMesh& mesh);

}  // namespace plumb
