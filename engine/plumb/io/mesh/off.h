// Reads and writes OFF, the object file format (docs/formats.md, "OFF"): vertices, and faces with
// any number of corners.
//
// Main flow of read_off():
//  1. read_keyword   reads [ST][C][N]OFF, or nothing; 4OFF, nOFF and OFF BINARY are other formats
//  2. read_counts    reads the numbers of vertices, faces and edges (the last is ignored); claims
//                    are checked against the bytes that follow
//  3. read_vertices  reads three coordinates a line; normals, colours and texture coordinates as
//                    announced
//  4. read_faces     reads the number of corners, the corners from 0, and up to four numbers for a
//                    colour
//  5. require_end    requires that nothing but blank and comment lines follows
//
// A comment may also end a line. Cost: O(bytes). Errors are thrown with the place (file, line,
// column): NotText, Syntax, NumberOutOfRange, CountMismatch, BadIndex, UnknownFormat, ResourceLimit; Cancelled.
#pragma once

#include <cstdint>
#include <ostream>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/read_options.h"
#include "plumb/space/mesh_arrays.h"

namespace plumb {

/// Returns the mesh of an OFF text. Its memory stays charged to `context`.
MeshFile read_off(std::string_view text, const ReadOptions& options, Context& context);

// Writes meshes as OFF (docs/formats.md, "OFF").

/// What a writer does with coordinates that are not doubles.
enum class MeshNumbers : std::uint8_t {
  Nearest,  ///< Writes the nearest double, in the shortest decimal that reads back as it.
  Exact,    ///< Writes p/q.
};

/// Writes a mesh. read_off() of the text gives the same mesh; with MeshNumbers::Nearest, exact
/// coordinates are rounded. Throws Error{NumberOutOfRange} if a vertex that is to be rounded lies
/// beyond the largest double, and what `out` throws.
void write_off(std::ostream& out, const PolygonMesh& mesh,
               MeshNumbers numbers = MeshNumbers::Nearest);

}  // namespace plumb
