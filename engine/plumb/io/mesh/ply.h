// Reads and writes PLY, text and binary of either byte order (docs/formats.md, "PLY"): vertices
// with properties x, y and z of any type, faces with a list vertex_indices (or another usual name),
// and triangle strips (element tristrips), which become triangles. Other properties and elements,
// in any order, are skipped; a note names them. If ReadOptions::attributes is true, properties of
// vertices and faces become attributes (ply_attributes.h).
//
// Main flow of read_ply():
//  1. read_ply_header   reads the list of elements. The counts are compared with the number of
//                       bytes that follow
//  2. elements          reads the elements in their order: in a text each on a line of its own, or
//                       all on one line, or each value on a line; in a binary file without gaps
//  3. pass_over_rest    notes bytes behind the last element; refuses text that may be more elements
//
// A vertex may have coordinates that are not finite, as scanners write them, if no face of three
// different corners uses it. It is the point 0 0 0 of the mesh. Lengths and corners may be written
// as any number whose value is whole. Lines may end with LF, CRLF or CR.
//
// Cost: O(bytes). Errors in the header and in a text are thrown with the place (file, line,
// column), in binary parts with the number of the byte: NotText, Syntax, NumberOutOfRange,
// CountMismatch, BadIndex, UnknownFormat, ResourceLimit; Cancelled.
#pragma once

#include <ostream>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/read_options.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"

namespace plumb {

/// Returns the mesh of a PLY file. Its memory stays charged to `context`.
MeshFile read_ply(std::string_view bytes, const ReadOptions& options, Context& context);

// Writes meshes as PLY, binary or text (docs/formats.md, "PLY").

/// Writes a mesh as text. read_ply() of it gives the same mesh, except that exact coordinates are
/// rounded to doubles. Both writers throw Error{NumberOutOfRange} if a vertex lies beyond the
/// largest double, and the exceptions of `out`.
/// Both write the attributes that PLY holds, which must be complete (attribute_writer.h).
void write_ply_text(std::ostream& out, const PolygonMesh& mesh,
                    const MeshAttributes& attributes = {});
/// Writes a mesh in binary, little-endian.
void write_ply_binary(std::ostream& out, const PolygonMesh& mesh,
                      const MeshAttributes& attributes = {});

}  // namespace plumb
