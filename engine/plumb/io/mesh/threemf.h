// Reads and writes 3MF, the format of programs that slice models for printers.
//
// Main flow of read_threemf():
//  1. package   opens the ZIP archive, and finds the model part that its relationships name
//               (_rels/.rels)
//  2. parts     reads this part and all parts that it refers to (threemf_model.h): objects with
//               meshes or components, and the items of the build
//  3. settings  reads which volumes a slicer does not take for parts of the shape
//               (threemf_settings.h)
//  4. build     places the objects of all items, exactly, in millimetres (threemf_build.h)
//
// Left out with a warning: objects for supports, negative volumes, modifiers, beam lattices. Named
// in a note: metadata, thumbnails, textures, settings of slicers; and base materials, colours and
// names of parts (threemf_looks.h), if attributes are not asked for. Refused: extensions that the
// file requires and that are not supported, document types, archives that unpack to more than 256
// times their size.
//
// Cost: O(bytes that the archive unpacks to), and the cost of step 4. Errors: the errors of these
// steps with the place FILE(PART):LINE:COLUMN, or FILE for the archive; UnknownFormat if plumb is
// built without libzip or expat.
#pragma once

#include <iosfwd>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/read_options.h"
#include "plumb/space/mesh_arrays.h"
#include "plumb/space/mesh_attributes.h"

namespace plumb {

/// Whether the bytes begin like a ZIP archive.
bool begins_like_zip(std::string_view bytes);

/// The memory of the mesh stays charged to `context`.
MeshFile read_threemf(std::string_view bytes, const ReadOptions& options, Context& context);

/// Writes one object in millimetres, with the materials, colours and groups of its faces. Equal
/// meshes give equal bytes. Throws Error{NumberOutOfRange} if a vertex lies beyond the largest
/// double, Error{BadArgument} if a face is no triangle, the errors of write_zip(), and the
/// exceptions of `out`.
void write_threemf(std::ostream& out, const PolygonMesh& mesh,
                   const MeshAttributes& attributes = {});

}  // namespace plumb
