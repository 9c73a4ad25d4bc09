// Reads STL, text and binary (docs/formats.md, "STL"): triangles, each with its own three points.
//
//   1. a file of 84 + 50 n bytes, with n in bytes 80 to 83, is binary, however it begins (no text
//      shorter than 7 GB can be one); else a file that begins with "solid" is text
//   2. text: any number of solids, words and numbers with any blanks and line breaks between,
//      keywords in any case; binary: n triangles of floats
//   3. equal points become one vertex (mesh_formats.h)
//
// Normals of facets are not looked at. Triangles with two equal corners are left out, and told.
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

/// Step 1: is a file of these bytes binary STL?
bool is_binary_stl(std::string_view bytes);
/// Step 2: does it begin with the word solid, in any case?
bool is_text_stl(std::string_view bytes);

/// The memory of the mesh stays charged to `context`.
MeshFile read_stl(std::string_view bytes, const ReadOptions& options, Context& context);

// Writes meshes as STL, text or binary (docs/formats.md, "STL").

/// read_stl() of what is written gives the same triangles, but for what is rounded, with vertices
/// numbered by first use. Both throw Error{BadArgument} when a face is no triangle,
/// Error{NumberOutOfRange} when a coordinate lies beyond the largest double (text) or float
/// (binary), and what `out` throws.
void write_stl_text(std::ostream& out, const PolygonMesh& mesh);
/// Coordinates become floats.
void write_stl_binary(std::ostream& out, const PolygonMesh& mesh);

/// The coordinates of the vertices as binary STL holds them. `exact` becomes empty.
/// Throws Error{NumberOutOfRange} as above.
PolygonMesh rounded_to_floats(PolygonMesh mesh);

}  // namespace plumb
