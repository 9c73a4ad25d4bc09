// Reads and writes OBJ (docs/formats.md, "OBJ"): vertices `v`, faces `f`.
//
// Corners are v, v/vt, v//vn or v/vt/vn, numbered from 1, or from -1 backwards from the vertex
// given last; vt and vn may be missing behind their slashes. Faces may precede their vertices. A
// comment may end a line; a backslash at the end of a line continues the statement on the next one.
// If ReadOptions::attributes is true, usemtl, mtllib, g, o, vt, vn and the colours of vertices
// become attributes (obj_attributes.h).
// All other statements are skipped: with a note, or with a warning if they are geometry. Unknown
// statements are skipped, too, and a note names them.
//
// Cost: O(bytes). Errors are thrown with the place (file, line, column): NotText, Syntax (also for
// a file that has neither v nor f, but unknown statements), NumberOutOfRange, BadIndex,
// CountMismatch (a file of nothing but blanks), ResourceLimit; Cancelled.
#pragma once

#include <ostream>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/mesh/obj_attributes.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/read_options.h"
#include "plumb/space/mesh_arrays.h"

namespace plumb {

/// Returns the mesh of an OBJ text. Its memory stays charged to `context`. If attributes
/// are wanted, `loader` returns the bytes of material libraries; without it their materials have no
/// colours.
MeshFile read_obj(std::string_view text, const ReadOptions& options, Context& context,
                  const ObjLoader& loader = {});

// Writes meshes as OBJ (docs/formats.md, "OBJ").

/// Writes a mesh. read_obj() of the text gives the same mesh, except that exact coordinates are
/// rounded. The threads of the context make the text. Throws Error{NumberOutOfRange} if a vertex
/// lies beyond the largest double, and the exceptions of `out`.
void write_obj(std::ostream& out, const PolygonMesh& mesh, Context& context = unlimited_context());

}  // namespace plumb
