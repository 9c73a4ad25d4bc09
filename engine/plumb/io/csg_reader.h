// Reads the flattened models of OpenSCAD, which are files with the extension .csg. The command
// `openscad model.scad -o model.csg` writes such a file.
//
// Main flow:
//  1. parse    reads nodes, modifiers and parameters into a CsgTree (csg_tree.h). The parser does
//              not recurse, so groups may be nested to any depth
//  2. root     keeps only the subtree of a node with the modifier `!`, if there is one
//  3. imports  reads the files that the model imports, with the readers of solids (solid_io.h), of
//              sets of the plane (plane_io.h), and of the height fields that surface() names
//
// Nodes: the reader knows all nodes that OpenSCAD 2021.01 writes. The node text() is refused if
// plumb was built without FreeType and fontconfig. Modifiers: a node with `*` or `%` is left out,
// `#` has no effect, and a node with `!` becomes the whole model. Parameters that do not change the
// shape, such as convexity, are skipped. Parameters with unknown names are skipped with a note. A
// number is read as the nearest double. A colour is a vector, a CSS colour name, or a text of the
// form #rgb, #rgba, #rrggbb or #rrggbbaa. An unknown colour name is reported by a note.
//
// Drawings in DXF are read as OpenSCAD reads them. The variables $fn, $fa and $fs determine how
// arcs are divided, a straight line closes an open chain, and hatches are ignored.
//
// Imports: a model can name other files, which are then imported. By default, an imported file must
// lie in the folder of the model or in a folder below it. Symbolic links are resolved before this
// is checked. A file outside this folder is refused before any of its contents are read.
//
// Cost: O(bytes), plus the cost of the readers of imported files. Errors have the form
// FILE:LINE:COLUMN: message. The errors are:
//   - Syntax, NotText and NumberOutOfRange for the text
//   - BadArgument and BadIndex for parameters
//   - UnknownFormat for nodes that are not supported, and for imports in other formats, and for
//     images of surface() if plumb was built without libpng
//   - CannotOpen for imports that cannot be read or are refused, and the errors of their readers
//   - ResourceLimit and Cancelled
// Source: the OpenSCAD User Manual, and the files that OpenSCAD writes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/csg/csg_tree.h"
#include "plumb/io/solid_io.h"

#pragma GCC visibility push(default)
namespace plumb {

/// States which files a model may import.
enum class CsgImports : std::uint8_t {
  None,        ///< No files: every import is refused.
  BelowModel,  ///< Files in the folder of the model, and in folders below it.
  Anywhere,    ///< All files.
};

/// Options of reading a model.
struct CsgReadOptions {
  CsgImports imports = CsgImports::BelowModel;  ///< The files that may be imported.
  /// Whether numbers with a decimal point or an exponent in imported files are read exactly.
  /// Otherwise such a number is rounded to the nearest double.
  bool exact_decimals = false;
  /// The attributes of imported meshes that are kept (solid_io.h).
  KeptAttributes attributes = KeptAttributes::None;
};

/// A model read from a file.
struct CsgRead {
  CsgTree tree;  ///< The model.
  /// Notes for a human reader about contents that were skipped. Each note is one sentence.
  std::vector<std::string> notes;
  std::vector<std::string> warnings;  ///< Warnings of the readers of imported files.
};

/// Returns the model that `text` describes. `path` is the name of the file in messages. A relative
/// path of an imported file is relative to the folder of `path`, or to the working directory if
/// `path` is "-".
[[nodiscard]] CsgRead read_csg(const std::string& path, std::string_view text,
                               const CsgReadOptions& options = {},
                               Context& context = unlimited_context());

/// Reads the file `path`, or standard input if `path` is "-", and returns its model. The memory of
/// the text is no longer charged to `context` when the function returns.
[[nodiscard]] CsgRead read_csg_file(const std::string& path, const CsgReadOptions& options = {},
                                    Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
