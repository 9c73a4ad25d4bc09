// Models of OpenSCAD's own language (.scad), by the program openscad, which writes them as flat
// models (.csg).
#pragma once

#include <string>

#include "plumb/base/context.h"

namespace plumb::cli {

/// Runs `openscad -o - --export-format csg PATH`, and returns what it writes. Messages of openscad
/// go to standard error if it fails. Throws Error{UnknownFormat} if openscad is not installed,
/// Error{Syntax} if it fails, and the errors of the Context. openscad, and all that it started, is
/// ended when the function returns or throws, and when the program ends.
std::string flat_model_of(const std::string& path, Context& context);

}  // namespace plumb::cli
