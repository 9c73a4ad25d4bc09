// Sets of space from files and to files: the one front door to meshes and .nef.
//
// Reading: a mesh is a closed set, its volumes by winding number. Writing: .nef holds every set
// exactly; meshes hold the closure of the interior, rounded, and what that loses is told.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/space/half_space_list.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// How a file becomes a set.
struct SolidReadOptions {
  /// Which winding numbers are inside. None: Positive, and components of negative volume that no other
  /// contains are turned.
  std::optional<WindingRule> rule;
  bool surface = false;         ///< an open mesh is the set of its facets
  bool exact_decimals = false;  ///< numbers with a point or exponent exactly as written
};

/// What reading gives.
struct SolidRead {
  Nef3 set;                        ///< all of the file
  std::vector<std::string> notes;  ///< what was reported on the way; one sentence each
};

/// A .nef: by its extension, or, where that names no format, by how it begins.
bool is_nef_file(const std::string& path, std::string_view bytes);

/// From a file, or standard input for "-". Errors: those of solid_io.h and nef3_reader.h; BadShape for a .nef that its
/// audit rejects and for a mesh that is open (without `surface`), with its border.
SolidRead read_solid_file(const std::string& path, const SolidReadOptions& options,
                          Context& context);
/// The same, when the bytes of the file have been read.
SolidRead read_solid(const std::string& path, const std::string& bytes,
                     const SolidReadOptions& options, Context& context);

/// Lines `a b c d closed|open`: a x + b y + c z + d <= 0 or < 0. From a file or standard input. Errors: Syntax,
/// NumberOutOfRange, with the place.
HalfSpaceList read_half_spaces_file(const std::string& path, ReadOptions options, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
