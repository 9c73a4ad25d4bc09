// Options that are common to several readers, and options that are common to several writers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#pragma GCC visibility push(default)
namespace plumb {

/// A rule that decides which points the rings of a file of polygons enclose. The winding number of
/// a point is the number of times that the rings run counter-clockwise around the point. A hole
/// must run in the direction opposite to the outer ring of its polygon. For all rules except Odd, a
/// hole that runs in the same direction is first reversed.
enum class RingRule : std::uint8_t {
  /// The union of the polygons, where each polygon encloses the points for which the winding number
  /// of its own rings is odd.
  Odd,
  NonZero,   ///< The points for which the winding number of all rings of the file is not 0.
  Positive,  ///< The points for which the winding number of all rings is positive.
  Negative,  ///< The points for which the winding number of all rings is negative.
};

/// States which other files a file may name. For example, the file of a scene names the file of its
/// model. If a file comes from a stranger, the stranger has chosen these names. The names must be
/// limited, because the messages of a program can reveal contents of the named files.
enum class NamedFiles : std::uint8_t {
  /// Files in the folder of the naming file and in folders below it. Symbolic links are resolved
  /// first.
  Below,
  Anywhere,  ///< All files.
};

/// Options of reading a text.
struct ReadOptions {
  std::string name = "input";  ///< The name of the file in messages.
  /// Whether a number with a decimal point or an exponent is read exactly. Otherwise such a number
  /// is rounded to the nearest double.
  bool exact_decimals = false;
  NamedFiles named_files = NamedFiles::Below;  ///< The other files that the file may refer to.
  /// The rule for polygons of the plane. For all other contents of files, the rule has no effect.
  RingRule rings = RingRule::Odd;
  /// The largest allowed distance of a curve from the chords that replace it, in the unit of the
  /// result. It is used for drawings (SVG, DXF) that are read as sets of the plane. Requires a
  /// positive number. If there is no value, the largest distance is a thousandth of the larger side
  /// of the drawing.
  std::optional<double> curve_tolerance = {};
  /// For meshes, this option states whether MeshFile::attributes is filled. If it is false, the
  /// reader skips colours, materials, groups and all other data of faces and corners. For sets of
  /// the plane in GeoJSON, it states whether the caller itself keeps the ids and properties of
  /// features. If it is false, a note reports that the ids and properties are left out. If it is
  /// true, there is no such note.
  bool attributes = false;
};

/// The rounding of coordinates that a format cannot represent exactly.
enum class OutputRounding : std::uint8_t {
  Valid,    ///< Rounds such that the written mesh or polygons are valid.
  Nearest,  ///< Rounds to the nearest numbers, even if faces or edges of the result cross.
};

}  // namespace plumb
#pragma GCC visibility pop
