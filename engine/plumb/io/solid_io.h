// Reads sets of space from files: the entry point to meshes (mesh_io.h), .nef (nef3_reader.h) and
// lists of half-spaces.
//
// A mesh becomes a closed set whose volumes are selected by winding number. A .nef holds any set
// exactly. Where the reader changes or leaves out something, a note says so.
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

/// Options that say how a file becomes a set.
struct SolidReadOptions {
  /// Which winding numbers are inside. Without a value the rule is Positive, and components of
  /// negative volume that no other component contains are flipped.
  std::optional<WindingRule> rule;
  bool surface = false;  ///< Whether an open mesh is read as the set of its facets.
  /// Whether numbers with a point or an exponent have exactly the value written. Otherwise each is
  /// rounded to the nearest double.
  bool exact_decimals = false;
};

/// A set read from a file.
struct SolidRead {
  Nef3 set;                        ///< The set that the file describes.
  std::vector<std::string> notes;  ///< What was reported while reading: one sentence each.
};

/// Whether a file is a .nef. The extension of `path` decides, or the first bytes if the extension
/// names no format.
bool is_nef_file(const std::string& path, std::string_view bytes);

/// Reads the file `path`, or standard input if `path` is "-", and returns its set. Throws the
/// errors of mesh_io.h and nef3_reader.h; Error{BadShape} if the audit rejects a .nef, or if a mesh
/// is open and `options.surface` is not set; the latter error states the border.
SolidRead read_solid_file(const std::string& path, const SolidReadOptions& options = {},
                          Context& context = unlimited_context());
/// Returns the set of the file `path`, whose bytes have been read already. Throws as
/// read_solid_file() does.
SolidRead read_solid(const std::string& path, const std::string& bytes,
                     const SolidReadOptions& options = {}, Context& context = unlimited_context());

/// Reads half-spaces from the file `path`, or from standard input if `path` is "-". Each line is
/// `a b c d closed|open` and stands for a x + b y + c z + d <= 0 (closed) or < 0 (open). Throws
/// Error{Syntax} or Error{NumberOutOfRange} with the place.
HalfSpaceList read_half_spaces_file(const std::string& path, ReadOptions options = {},
                                    Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
