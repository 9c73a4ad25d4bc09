// Reads OFF, the object file format (docs/formats.md, "OFF"): vertices, and faces of any number of
// corners.
//
//  1. read_keyword   [ST][C][N]OFF, or nothing; 4OFF, nOFF and OFF BINARY are other formats
//  2. read_counts    vertices, faces, and edges (which nobody needs); claims are checked against
//                    the bytes that follow
//  3. read_vertices  three coordinates a line; normals, colours, texture coordinates as announced
//  4. read_faces     how many corners, the corners from 0, up to four numbers for a colour
//  5. nothing but blank and comment lines may follow
//
// A comment may also end a line. Cost: O(bytes). Errors are thrown with the place (file, line,
// column): NotText, Syntax, NumberOutOfRange, CountMismatch, BadIndex, DegenerateFace (fewer than
// three corners, a vertex twice in a row), UnknownFormat, ResourceLimit; Cancelled.
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
MeshFile read_off(std::string_view text, const ReadOptions& options, Context& context);

// Writes meshes as OFF (docs/formats.md, "OFF").

/// What a writer does with coordinates that are no doubles.
enum class MeshNumbers : std::uint8_t {
  Nearest,  ///< the nearest double, in the shortest decimal that reads back as it
  Exact,    ///< p/q
};

/// read_off() of the text gives the same mesh, with MeshNumbers::Nearest but for what `exact`
/// holds. Throws Error{NumberOutOfRange} when a vertex that is to be rounded lies beyond the
/// largest double; what `out` throws.
void write_off(std::ostream& out, const PolygonMesh& mesh,
               MeshNumbers numbers = MeshNumbers::Nearest);

}  // namespace plumb
