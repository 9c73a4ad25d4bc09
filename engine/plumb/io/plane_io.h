// Reads and writes sets of the plane: the entry point to WKT, GeoJSON and .nef2.
//
// WKT and GeoJSON list polygons, lines and points (PlaneShapes). As a set, a polygon is the closed
// region of the points that its rings enclose by the even-odd rule, with its boundary; a line is
// the set of its points; the set of the file is the union of everything listed.
//
// Reading: WKT and GeoJSON carry no marks and give a closed set. Writing: .nef2 holds every set
// exactly. WKT and GeoJSON hold polygons, lines and points with doubles as coordinates; what that
// loses is always reported (PlaneLosses).
#pragma once

#include <array>
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
#include "plumb/predicates/point_table2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Polygons, lines and points in flat arrays. A ring or a line is a chain of indices into `points`.
/// A ring closes from its last corner to its first, which is not repeated.
struct PlaneShapes {
  PointTable2 points;                              ///< All corners, exact.
  std::vector<std::uint32_t> ring_corners;         ///< Corners of all rings, end to end.
  std::vector<std::uint32_t> ring_begin = {0};     ///< First corners of rings, and the end.
  std::vector<std::uint32_t> polygon_begin = {0};  ///< First rings of polygons, and the end.
  std::vector<std::uint32_t> line_corners;         ///< Points of all polylines, end to end.
  std::vector<std::uint32_t> line_begin = {0};     ///< First points of lines, and the end.
  std::vector<std::uint32_t> single_points;        ///< Indices of the isolated points.

  /// Returns the number of polygons. Each has an outer ring and any number of holes.
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

  /// Makes a ring of the corners appended since the last ring.
  void end_ring() { ring_begin.push_back(static_cast<std::uint32_t>(ring_corners.size())); }
  /// Makes a polygon of the rings appended since the last polygon.
  void end_polygon() { polygon_begin.push_back(static_cast<std::uint32_t>(ring_count())); }
  /// Makes a line of the points appended since the last line.
  void end_line() { line_begin.push_back(static_cast<std::uint32_t>(line_corners.size())); }
};

/// Returns the set that the shapes stand for. One sweep handles all polygons whose rings meet only
/// at common corners (touching polygons, touching holes); a polygon that crosses itself is first
/// resolved by a sweep of its own. Cost: O((n + k) log n) for n corners and k crossings.
Nef2 to_set(const PlaneShapes& shapes, Context& context = unlimited_context());

/// Returns the parts of a set as shapes, with exact coordinates.
PlaneShapes to_shapes(const PlaneParts& parts, Context& context = unlimited_context());

/// Returns the shapes with every coordinate rounded to the nearest double. Throws
/// Error{NumberOutOfRange} if a coordinate lies beyond the largest double.
PlaneShapes rounded(PlaneShapes shapes, Context& context = unlimited_context());

/// Formats for sets of the plane. Only Nef2 (.nef2) holds every set without loss.
enum class PlaneFormat : std::uint8_t { Wkt, GeoJson, Nef2 };

/// Returns the format that the extension of `path` names: .wkt, .geojson or .json, or .nef2.
/// Returns nullopt for any other extension.
std::optional<PlaneFormat> plane_format_of(const std::string& path);

/// Returns the format that the text seems to have. "{" and "[" begin GeoJSON, "plumb-" begins
/// .nef2; everything else is taken for WKT.
PlaneFormat guess_plane_format(std::string_view text);

/// Returns the set that `text` holds in the given format. Throws the errors that the reader of the
/// format states (wkt.h, geojson.h, nef2_format.h).
Nef2 read_plane_set(std::string_view text, PlaneFormat format, const ReadOptions& options = {},
                    Context& context = unlimited_context());

/// Reads the file `path`, or standard input if `path` is "-", and returns its set. Without
/// `format`, the format is that of the extension, or else guessed. `options.name` is ignored. The
/// memory of the text is released. Throws as read_plane_set() does, and if the file cannot be read.
Nef2 read_plane_set_file(const std::string& path, std::optional<PlaneFormat> format,
                         ReadOptions options = {}, Context& context = unlimited_context());

/// The properties of a set that a written file does not hold.
struct PlaneLosses {
  bool unbounded = false;  ///< Unbounded faces, rays or lines were left out.
  bool open = false;       ///< The set is not closed; its closure was written.
  bool filled = false;     ///< The closure has points inside that the set lacks. Implies `open`.
  /// Set if rounding the coordinates changed the structure: the counts of the set that should have
  /// been written, then those of the set that a reader will get.
  std::optional<std::array<PlaneCounts, 2>> reshaped;

  /// Whether anything is lost.
  bool any() const { return unbounded || open || reshaped.has_value(); }
  /// Returns the sentence that says that the closure was written, or an empty string. A difference
  /// is seldom closed: the program says so only where a file must hold the set exactly.
  std::string closing() const;
  /// Returns the other losses as text: one sentence for each, for people.
  std::vector<std::string> sentences() const;
};

/// A set prepared for writing in a format. The constructor does all the work and finds all losses,
/// so that a caller can refuse them before the first byte is written.
class PlaneText {
 public:
  /// Prepares `set`. If a coordinate has to be rounded, the set that a reader will get is built and
  /// compared. Throws Error{NumberOutOfRange} if a coordinate lies beyond the largest double and
  /// the format is not Nef2.
  PlaneText(const Nef2& set, PlaneFormat format, Context& context = unlimited_context());

  const PlaneLosses& losses() const { return losses_; }  ///< What the file will not hold.
  /// Writes the file, with a checkpoint after each 64 kB. Throws what `out` throws.
  void write(std::ostream& out, Context& context = unlimited_context()) const;

 private:
  Nef2 set_;
  PlaneFormat format_;
  PlaneShapes shapes_;
  PlaneLosses losses_;
};

}  // namespace plumb
#pragma GCC visibility pop
