// Reads OpenSCAD's flattened models: files .csg, as `openscad model.scad -o model.csg` writes them.
//
// Main flow:
//  1. parse    reads nodes, modifiers and parameters into a CsgTree (csg_tree.h). Nothing recurses,
//              so groups may be nested to any depth
//  2. root     keeps only the subtree of a node with the modifier `!`, if there is one
//  3. imports  reads the files that the model imports, with the readers of solids (solid_io.h), of
//              sets of the plane (plane_io.h), and of fields of heights, which surface() names
//
// Nodes: all that OpenSCAD 2021.01 writes except text(), which is refused.
// Modifiers: `*` and `%` leave a node out, `#` changes nothing, and `!` makes its node the model.
// Parameters that do not change the shape, such as convexity, are skipped; parameters with unknown
// names are skipped with a note. A number is read as the nearest double. A colour is a vector, a
// name of CSS, or #rgb, #rgba, #rrggbb or #rrggbbaa; an unknown name gives a note.
//
// Drawings in DXF are read as OpenSCAD reads them: $fn, $fa and $fs divide arcs, a straight line
// closes an open chain, and hatches are left out.
//
// Imports: a model names files. Unless the options allow more, a file must lie in the folder of the
// model or below it, after symbolic links are resolved. The contents of a file that is refused for
// its place are not read.
//
// Cost: O(bytes), and the cost of the readers of imported files. Errors have the form
// FILE:LINE:COLUMN: message. They are:
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

/// Where the files that a model imports may lie.
enum class CsgImports : std::uint8_t {
  None,        ///< Nowhere: every import is refused.
  BelowModel,  ///< In the folder of the model, or below it.
  Anywhere,    ///< Anywhere.
};

/// Options of reading a model.
struct CsgReadOptions {
  CsgImports imports = CsgImports::BelowModel;  ///< Where imported files may lie.
  /// Whether a number with a decimal point or an exponent of an imported file is read exactly.
  bool exact_decimals = false;
  /// Which attributes of imported meshes are kept (solid_io.h).
  KeptAttributes attributes = KeptAttributes::None;
};

/// A model read from a file.
struct CsgRead {
  CsgTree tree;                       ///< The model.
  std::vector<std::string> notes;     ///< Notes for a human reader; each is one sentence.
  std::vector<std::string> warnings;  ///< Warnings of the readers of imported files.
};

/// Returns the model that `text` describes. `path` is the name of the file in messages; the files
/// that the model imports are looked up in the folder of `path`, or in the working directory if
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
