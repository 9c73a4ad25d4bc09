// Reads and writes OFF, the object file format (docs/formats.md, "OFF"): vertices, and faces with
// any number of corners.
//
// Main flow of read_off():
//  1. read_keyword   reads [ST][C][N]OFF in capital or small letters, or nothing; 4OFF and nOFF are
//                    other formats; after OFF BINARY the rest of the file is binary
//  2. read_counts    reads the numbers of vertices, faces and edges (the last is ignored); claims
//                    are checked against the bytes that follow
//  3. read_records   reads three coordinates for each vertex, and for each face the number of
//                    corners and the corners from 0. Records are lines, or share lines, or extend
//                    over lines. Normals, colours and texture coordinates are dropped
//                    unless ReadOptions::attributes is true
//  4. require_end    requires that no numbers follow
//
// Comments may stand between any two numbers. Cost: O(bytes), also for a file that is refused.
// Errors are thrown with the place (file, line, column; in the binary form file and byte): NotText,
// Syntax, NumberOutOfRange, CountMismatch, BadIndex, UnknownFormat, ResourceLimit; Cancelled.
#pragma once

#include <cstdint>
#include <ostream>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/read_options.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"

namespace plumb {

/// Whether a file with this first word can be OFF: a keyword of the format, or a number.
bool begins_off(std::string_view word);

/// Returns the mesh of an OFF file. Its memory stays charged to `context`.
MeshFile read_off(std::string_view text, const ReadOptions& options, Context& context);

// Writes meshes as OFF (docs/formats.md, "OFF").

/// The treatment of coordinates that are not doubles by a writer.
enum class MeshNumbers : std::uint8_t {
  Nearest,  ///< Writes the nearest double, in the shortest decimal that reads back as it.
  Exact,    ///< Writes p/q.
};

/// Writes a mesh. read_off() of the text gives the same mesh; with MeshNumbers::Nearest, exact
/// coordinates are rounded. The threads of the context make the text. Throws
/// Error{NumberOutOfRange} if a vertex that is to be rounded lies beyond the largest double, and
/// the exceptions of `out`.
void write_off(std::ostream& out, const PolygonMesh& mesh,
               MeshNumbers numbers = MeshNumbers::Nearest, Context& context = unlimited_context());
/// Whether a material stands for an index of a colour: it has no colour, and a number for a name.
bool is_off_color_index(const MeshMaterial& material);

/// Writes a mesh with the attributes that OFF holds (docs/formats.md). Requires complete attributes
/// (attribute_writer.h). Throws as above.
void write_off(std::ostream& out, const PolygonMesh& mesh, const MeshAttributes& attributes,
               MeshNumbers numbers = MeshNumbers::Nearest);

}  // namespace plumb
