// Reads and writes STL, text and binary (docs/formats.md, "STL"): triangles, each with its own
// three points.
//
// Main flow of read_stl():
//  1. kind       A file of 84 + 50 n bytes, with n in bytes 80 to 83, is binary, however it begins
//                (no text shorter than 7 GB can be one); else a file that begins with "solid" and
//                has no control characters at its beginning is text; else a file with control
//                characters is binary
//  2. triangles  In a text any number of solids, words and numbers with any blanks and line breaks
//                between, keywords in any case; in a binary file the triangles of floats for which
//                its size has room
//  3. weld       Equal points become one vertex (mesh_formats.h)
//
// Normals of facets are ignored. Triangles with two equal corners are left out. In a text, normals,
// facet, endfacet and the last endsolid may be missing, ends may be two words, and lines may end
// with CR. In a binary file, the count of triangles may disagree with the size, and bytes may
// follow the last triangle or, as its attribute announces, each triangle. Notes name the contents
// that were left out or are missing. A facet that the end of the file cuts off is refused.
//
// Cost: O(n log n). Errors in a text are thrown with the place (file, line, column), in a binary
// file with the number of the byte: NotText, Syntax, NumberOutOfRange, CountMismatch,
// ResourceLimit; Cancelled.
#pragma once

#include <ostream>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/read_options.h"
#include "plumb/space/mesh_arrays.h"

namespace plumb {

/// Whether a file of these bytes is binary STL (step 1).
bool is_binary_stl(std::string_view bytes);
/// Whether it begins with the word solid, in any case.
bool is_text_stl(std::string_view bytes);
/// Whether the bytes are enough for binary STL and begin as no text does, with control characters.
/// Other binary formats satisfy this, too.
bool has_binary_content(std::string_view bytes);

/// Returns the mesh of an STL file. Its memory stays charged to `context`.
MeshFile read_stl(std::string_view bytes, const ReadOptions& options, Context& context);

// Writes meshes as STL, text or binary (docs/formats.md, "STL").

/// Writes a mesh as text. read_stl() of it gives the same triangles up to rounding, with vertices
/// numbered by first use. Both writers throw Error{BadArgument} if a face is no triangle,
/// Error{NumberOutOfRange} if a coordinate lies beyond the largest double (text) or float (binary),
/// and the exceptions of `out`.
void write_stl_text(std::ostream& out, const PolygonMesh& mesh);
/// Writes a mesh in binary; coordinates become floats.
void write_stl_binary(std::ostream& out, const PolygonMesh& mesh);

/// Returns the mesh with coordinates as binary STL holds them; `exact` becomes empty. Throws
/// Error{NumberOutOfRange} as above.
PolygonMesh rounded_to_floats(PolygonMesh mesh);

}  // namespace plumb
