// Reads AMF, a format of programs that slice models for printers, if plumb is built with expat (and
// libzip, for files that are packed).
//
// A file is XML, or a ZIP archive with it. It has objects, each of them a mesh of vertices and
// volumes of triangles, and constellations, which place objects and other constellations. They are
// read into the scene of 3MF (threemf_model.h), which build_threemf() places: objects and
// constellations that no constellation places, exactly, in millimetres.
//
// Left out with a warning: volumes for supports and modifiers. Triangles that normals or edges
// curve are read as flat, with a warning. Named in a note: metadata, textures, colours of vertices;
// and materials, colours and names, if attributes are not asked for.
//
// Cost: O(bytes of the XML), and the cost of build_threemf(). Errors: those of XmlStream,
// ZipArchive and build_threemf(), with the place FILE:LINE:COLUMN, or FILE(ENTRY):LINE:COLUMN in an
// archive; UnknownFormat if plumb is built without the libraries.
#pragma once

#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/mesh_io.h"
#include "plumb/io/read_options.h"

namespace plumb {

/// Whether the bytes begin like XML whose root is an `amf`.
bool begins_like_amf(std::string_view bytes);

/// The memory of the mesh stays charged to `context`.
MeshFile read_amf(std::string_view bytes, const ReadOptions& options, Context& context);

}  // namespace plumb
