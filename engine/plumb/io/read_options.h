// Options that are common to all readers, and to all writers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#pragma GCC visibility push(default)
namespace plumb {

/// The points that the rings of a file of polygons enclose. The winding number of a point says how
/// often the rings run around it counter-clockwise. Under all rules but Odd, a hole that runs the
/// same way as the outer ring of its polygon is turned round first.
enum class RingRule : std::uint8_t {
  Odd,       ///< Each polygon by itself: the points whose winding number is odd. Polygons unite.
  NonZero,   ///< All rings of the file together: the points whose winding number is not 0.
  Positive,  ///< All rings of the file together: the points whose winding number is positive.
  Negative,  ///< All rings of the file together: the points whose winding number is negative.
};

/// Which files a file may name, for example a scene its model. Whoever sends a file chooses these
/// names, and the messages of a program may show where reading such a file failed.
enum class NamedFiles : std::uint8_t {
  Below,     ///< Files in the folder of the file and below it, after symbolic links are resolved.
  Anywhere,  ///< All files.
};

/// Options of reading a text.
struct ReadOptions {
  std::string name = "input";  ///< The name of the file in messages.
  /// Whether a number with a decimal point or an exponent is read exactly. Otherwise such a number
  /// is rounded to the nearest double.
  bool exact_decimals = false;
  NamedFiles named_files = NamedFiles::Below;  ///< Which other files the file may name.
  RingRule rings = RingRule::Odd;  ///< For polygons of the plane; ignored for all other contents.
  /// The largest distance of a curve from the chords that replace it, in the unit of the result,
  /// for drawings (SVG, DXF) that are read as sets of the plane. Requires a positive number.
  /// Without a value it is a thousandth of the larger side of the drawing.
  std::optional<double> curve_tolerance = {};
  /// For meshes: whether MeshFile::attributes is filled. Otherwise colours, materials, groups and
  /// all other numbers of faces and corners are passed over. For sets of the plane in GeoJSON:
  /// whether the caller keeps the ids and properties of features, so that no note reports them.
  bool attributes = false;
};

/// How a writer rounds coordinates that its format cannot hold.
enum class OutputRounding : std::uint8_t {
  Valid,    ///< To numbers with which the written mesh or polygons are valid.
  Nearest,  ///< To the nearest numbers, even if faces or edges then cross.
};

}  // namespace plumb
#pragma GCC visibility pop
