// Reads and writes sets of the plane in the formats WKT, GeoJSON, WKB, DXF and .nef2, and reads
// SVG.
//
// WKT, GeoJSON and WKB files list polygons, lines and points (PlaneShapes). A polygon stands for
// the points that its rings enclose by the even-odd rule, together with the points on its rings;
// the caller may choose another rule (RingRule). A line stands for the set of its points. A file
// stands for the union of the sets of all its polygons, lines and points.
//
// DXF and SVG files are drawings. Their curves are replaced by chords (ReadOptions). A DXF file
// stands for the points that all its rings together enclose by the even-odd rule. An SVG file
// stands for the union of its shapes. The fill rule of a shape decides which points the shape
// encloses. If the caller chooses another rule than RingRule::Odd, this rule is applied to all
// rings of the file together, both for DXF and for SVG.
//
// Reading: a file in any of these formats cannot state which boundary points belong to the set. A
// set that is read from such a file is closed. Contents of a file that cannot be represented by a
// set are reported by notes.
//
// Writing: .nef2 represents every set exactly. WKT, GeoJSON and WKB represent only polygons, lines
// and points, whose coordinates are doubles. DXF represents only polygons. The set is rounded so
// that these shapes are valid (plane_rounding.h): rings meet only in common corners, and nothing is
// degenerate. If a set has properties that such a file cannot represent, or rounding changes its
// shape, these losses are reported (PlaneLosses).
#pragma once

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_rounding.h"
#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Polygons, lines and points in flat arrays. A ring or a line is a chain of indices into `points`.
/// A ring is closed: an edge joins its last corner to its first corner. The first corner is not
/// repeated at the end.
struct PlaneShapes {
  PointTable2 points;                       ///< All corners, exact.
  std::vector<std::uint32_t> ring_corners;  ///< Corners of all rings, end to end.
  /// For each ring, the offset of its first corner in ring_corners. The last entry is the size of
  /// ring_corners.
  std::vector<std::uint32_t> ring_begin = {0};
  /// For each polygon, the index of its first ring. The last entry is the number of rings.
  std::vector<std::uint32_t> polygon_begin = {0};
  std::vector<std::uint32_t> line_corners;  ///< Points of all lines, end to end.
  /// For each line, the offset of its first point in line_corners. The last entry is the size of
  /// line_corners.
  std::vector<std::uint32_t> line_begin = {0};
  std::vector<std::uint32_t> single_points;  ///< Indices of the isolated points.

  /// Returns the number of polygons. Each polygon has an outer ring and any number of holes.
  std::size_t polygon_count() const { return polygon_begin.size() - 1; }
  std::size_t ring_count() const { return ring_begin.size() - 1; }  ///< Number of rings.
  std::size_t line_count() const { return line_begin.size() - 1; }  ///< Number of lines.
  /// Returns the corners of ring `r` as indices into `points`.
  std::span<const std::uint32_t> ring(std::size_t r) const {
    return {ring_corners.data() + ring_begin[r], ring_corners.data() + ring_begin[r + 1]};
  }
  /// Returns the points of line `l` as indices into `points`.
  std::span<const std::uint32_t> line(std::size_t l) const {
    return {line_corners.data() + line_begin[l], line_corners.data() + line_begin[l + 1]};
  }
  /// Whether there are no polygons, lines or isolated points.
  bool empty() const { return polygon_count() == 0 && line_count() == 0 && single_points.empty(); }

  /// Ends a ring. The ring consists of the corners that were appended to ring_corners after the
  /// previous ring ended.
  void end_ring() { ring_begin.push_back(static_cast<std::uint32_t>(ring_corners.size())); }
  /// Ends a polygon. The polygon consists of the rings that ended after the previous polygon ended.
  void end_polygon() { polygon_begin.push_back(static_cast<std::uint32_t>(ring_count())); }
  /// Ends a line. The line consists of the points that were appended to line_corners after the
  /// previous line ended.
  void end_line() { line_begin.push_back(static_cast<std::uint32_t>(line_corners.size())); }
};

/// Shapes read from a WKT, GeoJSON, WKB or DXF file.
struct PlaneFile {
  PlaneShapes shapes;  ///< The shapes as the file lists them.
  /// In WKT and WKB: the polygons, in ascending order, that belong to the same MULTIPOLYGON as the
  /// polygon before them.
  std::vector<std::uint32_t> continued;
  /// In WKT and WKB: for each geometry without polygons, in the order of the file, the number of
  /// polygons before it. Such a geometry is empty, or it consists of points or lines.
  std::vector<std::uint32_t> without_polygons;
  /// Notes for a human reader. Each note is one sentence. The notes report contents of the file
  /// that are not in `shapes`.
  std::vector<std::string> notes;
};

/// Returns the union of the polygons, lines and points. `rule` decides which points the rings of
/// the polygons enclose. For RingRule::Odd, the result is the same as without `rule` (see the
/// function below).
Nef2 to_set(const PlaneShapes& shapes, RingRule rule, Context& context = unlimited_context());

/// Returns the union of the polygons, lines and points, where each polygon encloses points by the
/// even-odd rule. First, each polygon whose rings meet at points other than common corners is swept
/// separately. Then one sweep handles all other polygons together. The other polygons are those
/// whose rings meet at most at common corners, for example at a corner where a hole touches the
/// outer ring. Cost: O((n + k) log n) for n corners and k crossings.
Nef2 to_set(const PlaneShapes& shapes, Context& context = unlimited_context());

/// Returns the parts of a set as shapes, with exact coordinates.
PlaneShapes to_shapes(const PlaneParts& parts, Context& context = unlimited_context());

/// Returns the shapes with every coordinate rounded to the nearest double. The function repairs
/// nothing, so rings of the result may cross or coincide. round_to_doubles() (plane_rounding.h)
/// returns a set whose shapes are valid. Throws Error{NumberOutOfRange} if a coordinate lies beyond
/// the largest double.
PlaneShapes with_nearest_doubles(PlaneShapes shapes, Context& context = unlimited_context());

/// Formats for sets of the plane. Only the format Nef2 (.nef2) represents every set without loss.
/// Svg can be read but not written.
enum class PlaneFormat : std::uint8_t { Wkt, GeoJson, Nef2, Wkb, Dxf, Svg };

/// Returns the format that the extension of `path` names. The extensions are .wkt for Wkt, .geojson
/// and .json for GeoJson, .nef2 for Nef2, .wkb for Wkb, .dxf for Dxf, and .svg for Svg. Returns
/// nullopt for any other extension.
std::optional<PlaneFormat> plane_format_of(const std::string& path);

/// Returns the format that the text seems to have. A text that begins with "{" or "[", or with a
/// record separator before them, is GeoJSON. A text that begins with "plumb-" is .nef2. A text that
/// begins with the binary code of a geometry is WKB (begins_like_wkb() in wkb.h). A text that
/// begins with "<svg", "<?xml" or "<!" is SVG. A text that begins with a section or a comment of
/// DXF is DXF (begins_like_dxf() in dxf.h). Any other text is WKT.
PlaneFormat guess_plane_format(std::string_view text);

/// Returns the format that the extension of `path` names. If the extension names no format, returns
/// the format that the text seems to have.
PlaneFormat plane_format_of(const std::string& path, std::string_view text);

/// A set read from a file.
struct PlaneRead {
  Nef2 set;  ///< The set that the file describes.
  /// Notes for a human reader. Each note is one sentence. The notes report contents of the file
  /// that are not in `set`. Another note reports an empty `set` if all geometries of the file are
  /// empty, unless the file is a .nef2 file of the empty set.
  std::vector<std::string> notes;
  /// Warnings for a human reader. Each warning is one sentence. A warning reports an empty `set` if
  /// the file has other contents. A program should show warnings even if it does not show notes.
  std::vector<std::string> warnings = {};
};

/// Returns the set that `text` describes in the given format. Throws the errors of the reader of
/// this format, as its header states them (wkt.h, geojson.h, nef2_format.h, wkb.h, dxf.h,
/// svg_reader.h).
PlaneRead read_plane_set(std::string_view text, PlaneFormat format, const ReadOptions& options = {},
                         Context& context = unlimited_context());

/// Reads the file `path`, or standard input if `path` is "-", and returns its set. If `format` is
/// not given, the extension of `path` determines the format. If the extension names no format, the
/// format is guessed by guess_plane_format(). `options.name` is ignored. The text is no longer
/// charged to `context` when the function returns. Throws the errors of read_plane_set(). Also
/// throws if the file cannot be read.
PlaneRead read_plane_set_file(const std::string& path, std::optional<PlaneFormat> format,
                              ReadOptions options = {}, Context& context = unlimited_context());

/// Options of the writers of WKT, GeoJSON, WKB and DXF. The options have no effect on .nef2.
struct PlaneWriteOptions {
  OutputRounding rounding = OutputRounding::Valid;  ///< The rounding of coordinates to doubles.
  /// The step of a grid. If it has a value, coordinates are rounded to multiples of the step, so
  /// that the shapes are valid. The doubles nearest to these multiples are written, and `rounding`
  /// is ignored. Requires a positive step.
  std::optional<Rational> grid = {};
};

/// Whether rounding changed the shape of a set or of a subdivision. If the caller has chosen a
/// grid, the movement of vertices to this grid does not count as a change.
bool is_reshaped(const PlaneRoundingReport& report, const PlaneWriteOptions& options);

/// Returns a sentence for a human reader that states how rounding changed the shape. Returns an
/// empty string if rounding did not change the shape.
std::string rounding_sentence(const PlaneRoundingReport& report, const PlaneWriteOptions& options);

/// The properties of a set that a written file does not represent.
struct PlaneLosses {
  bool unbounded = false;  ///< Unbounded faces, rays or lines were left out.
  bool open = false;       ///< The set is not closed, so its closure was written.
  /// The written closure has points inside that do not belong to the set (PlaneParts::filled). If
  /// this is true, `open` is true, too.
  bool filled = false;
  /// Lines and points were left out, because the format represents polygons only.
  bool thin = false;
  /// The changes made by rounding. For OutputRounding::Nearest, rounding does not repair the
  /// shapes. In this case, the report lists the changes that a repair would make. If the report
  /// lists no change, the shapes with the nearest doubles are valid.
  PlaneRoundingReport rounding;
  PlaneWriteOptions options;  ///< The rounding of coordinates, and other options.

  /// Whether rounding changes the shape of the set.
  bool is_reshaped() const { return plumb::is_reshaped(rounding, options); }
  /// Whether the written file loses any property of the set.
  bool any() const { return unbounded || open || thin || is_reshaped(); }
  /// Returns a sentence for a human reader, which states that the closure was written instead of
  /// the set. Returns an empty string if the set is closed. This sentence is not among sentences(),
  /// because a program need not always print it: differences of sets are seldom closed.
  std::string closing() const;
  /// Returns a sentence for a human reader for each loss, except for the loss that closing()
  /// states.
  std::vector<std::string> sentences() const;
};

/// A set that is prepared for writing in a format. The constructor finds all losses before any byte
/// is written. So the caller can look at the losses and decide not to write the file.
class PlaneText {
 public:
  /// Prepares `set` for writing. If a coordinate must be rounded, the constructor rounds the set
  /// with round_to_doubles(). Throws Error{NumberOutOfRange} if the format is not Nef2 and a
  /// coordinate lies beyond the largest double, and Error{UnknownFormat} if the format is Svg.
  PlaneText(const Nef2& set, PlaneFormat format, Context& context = unlimited_context())
      : PlaneText(set, format, {}, context) {}
  /// Prepares `set` for writing with options. Throws as the constructor above does, and
  /// Error{BadArgument} if the step of the grid is not positive.
  PlaneText(const Nef2& set, PlaneFormat format, const PlaneWriteOptions& options,
            Context& context = unlimited_context());

  /// Returns the properties of the set that the file will not represent.
  const PlaneLosses& losses() const { return losses_; }
  /// Writes the file. Calls Context::checkpoint() after each 64 kB. Exceptions of `out` reach the
  /// caller.
  void write(std::ostream& out, Context& context = unlimited_context()) const;

 private:
  Nef2 set_;
  PlaneFormat format_;
  PlaneShapes shapes_;
  PlaneLosses losses_;
};

}  // namespace plumb
#pragma GCC visibility pop
