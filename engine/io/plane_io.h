// Sets of the plane from files and to files: the one front door to WKT, GeoJSON and .nef2.
//
// Reading: a file without marks (WKT, GeoJSON) is a closed set (plane_shapes.h says which).
// Writing: .nef2 holds every set exactly. WKT and GeoJSON hold polygons, lines and points with
// doubles for coordinates; what that loses is told (PlaneLosses), never silent.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/plane_shapes.h"
#include "plumb/io/read_options.h"
#include "plumb/plane/nef2.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Files of sets of the plane; .nef2 alone holds all of any set.
enum class PlaneFormat : std::uint8_t { Wkt, GeoJson, Nef2 };

/// By the extension: .wkt, .geojson or .json, .nef2; none for any other.
std::optional<PlaneFormat> plane_format_of(const std::string& path);

/// By the first characters: "{" or "[" begin GeoJSON, "plumb-" begins .nef2; all else is taken for
/// WKT.
PlaneFormat guess_plane_format(std::string_view text);

/// The set written in `text`. Errors: those of wkt_reader.h, geojson_reader.h, nef2_reader.h.
Nef2 read_plane_set(std::string_view text, PlaneFormat format, const ReadOptions& options,
                    Context& context);

/// The same from a file, or from standard input for "-"; without `format` it is that of the
/// extension, else guessed. `options.name` is ignored. The memory of the text is given back.
Nef2 read_plane_set_file(const std::string& path, std::optional<PlaneFormat> format,
                         ReadOptions options, Context& context);

/// How many vertices, edges and faces the minimal complex of a set has.
struct PlaneCounts {
  std::size_t vertices = 0;  ///< those at infinity not counted
  std::size_t edges = 0;     ///< those of the frame not counted
  std::size_t faces = 0;     ///< the unbounded ones, too
  friend bool operator==(const PlaneCounts&, const PlaneCounts&) = default;
};
PlaneCounts counts_of(const Nef2& set);  ///< Of its minimal complex. O(n).

/// What a written file does not say of the set.
struct PlaneLosses {
  bool unbounded = false;  ///< unbounded faces, rays or lines were left out
  bool open = false;       ///< the set is not closed; its closure was written
  /// Rounding the coordinates changed the structure: that of what should have been written, and
  /// that of what a reader will get. None when nothing changed.
  std::optional<std::array<PlaneCounts, 2>> reshaped;

  /// Is there anything that the file does not say?
  bool any() const { return unbounded || open || reshaped.has_value(); }
  /// One sentence each, for people.
  std::vector<std::string> sentences() const;
};

/// A set made ready for a file of some format: all work and all judgement is done before the first
/// byte is written.
class PlaneText {
 public:
  /// Throws Error{NumberOutOfRange} when a coordinate lies beyond the largest double (not for
  /// .nef2). When a coordinate has to be rounded, what a reader will get is built and compared.
  PlaneText(const Nef2& set, PlaneFormat format, Context& context);

  const PlaneLosses& losses() const { return losses_; }  ///< What the file will not say.
  /// Writes the file. Throws what `out` throws; a checkpoint each 64 kB.
  void write(std::ostream& out, Context& context) const;

 private:
  Nef2 set_;
  PlaneFormat format_;
  PlaneShapes shapes_;
  PlaneLosses losses_;
};

}  // namespace plumb
#pragma GCC visibility pop
