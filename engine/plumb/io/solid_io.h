// Reads sets of space from files. A file is a mesh (mesh_io.h), a .nef file (nef3_reader.h) or a
// list of half-spaces.
//
// A mesh becomes a closed set. The winding number of each volume decides whether the volume belongs
// to the set. A .nef file represents any set exactly. A note reports whatever the reader changes or
// leaves out.
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

/// Options of the conversion of a file to a set.
struct SolidReadOptions {
  /// The rule for winding numbers. A volume is inside if the rule accepts its winding number.
  /// Without a value, the rule is Positive, and each component that has a negative volume and lies
  /// in no other component is flipped.
  std::optional<WindingRule> rule;
  bool surface = false;  ///< Whether an open mesh is read as the set of its facets.
  /// Whether a number with a decimal point or an exponent is read exactly. Otherwise such a number
  /// is rounded to the nearest double.
  bool exact_decimals = false;
};

/// A set read from a file.
struct SolidRead {
  Nef3 set;                        ///< The set that the file describes.
  std::vector<std::string> notes;  ///< Notes of the reader for a human, one sentence each.
};

/// Whether a file is a .nef file. The extension of `path` decides. If it names no format, the first
/// bytes decide.
bool is_nef_file(const std::string& path, std::string_view bytes);

/// Reads the file `path`, or standard input if `path` is "-", and returns its set. Throws the
/// errors of mesh_io.h and nef3_reader.h. Throws Error{BadShape} if the audit finds a flaw in a
/// .nef file. Throws Error{BadShape}, with the border of the mesh, if a mesh is open and
/// `options.surface` is not set.
SolidRead read_solid_file(const std::string& path, const SolidReadOptions& options = {},
                          Context& context = unlimited_context());
/// Returns the set of the file `path`. The caller has already read the bytes of the file. Throws as
/// read_solid_file() does.
SolidRead read_solid(const std::string& path, const std::string& bytes,
                     const SolidReadOptions& options = {}, Context& context = unlimited_context());

/// Reads half-spaces from the file `path`, or from standard input if `path` is "-". A line
/// `a b c d closed` stands for the half-space a x + b y + c z + d <= 0. A line `a b c d open`
/// stands for a x + b y + c z + d < 0. Throws Error{Syntax} or Error{NumberOutOfRange}, with the
/// position in the file.
HalfSpaceList read_half_spaces_file(const std::string& path, ReadOptions options = {},
                                    Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
