// Reads and writes planar maps as text (docs/formats.md, "map"). The text has three parts:
//   - a header `n f`, where n is the number of vertices and f is the number of faces
//   - n lines `x y`, the coordinates of the vertices
//   - f lines, each with the 1-based vertex ids of one face
//
// Main flow of read_map:
//  1. read_counts    reads the header, and checks that the rest of the text is long enough for n
//                    vertices and f faces
//  2. read_vertices  reads exactly two numbers from each line (record_reader.h)
//  3. read_faces     reads the vertex ids of each face from its line. A line must have at least
//                    three ids, and all ids must be in range. Two neighbouring ids must differ. The
//                    points of these vertices must not all be collinear, which is tested
//                    exactly.
//  4. end            accepts only blank lines and comments after the faces
//
// Cost: O(bytes) time. The text and the map are in memory at the same time.
//
// Errors: the errors NotText, Syntax, NumberOutOfRange, CountMismatch, BadIndex and DegenerateFace
// name the file, line and column. The other errors are CannotOpen, ResourceLimit and Cancelled.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/io/plane_io.h"
#include "plumb/io/read_options.h"
#include "plumb/plane/map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the map that `text` describes. The memory of the map stays charged to `context`. Throws
/// the errors that the head of this file states.
Map read_map(std::string_view text, const ReadOptions& options = {},
             Context& context = unlimited_context());

/// Reads the file `path`, or standard input if `path` is "-", and returns its map. `options.name`
/// is ignored. Throws the errors that the head of this file states.
Map read_map_file(const std::string& path, ReadOptions options = {},
                  Context& context = unlimited_context());

/// Returns the map that polygons form. Polygons do not list the outer boundary of the whole map, so
/// the map must be checked with OuterRule::Infer. Corners with equal coordinates become one vertex.
/// Vertices are numbered in the order of their first occurrences as corners. Cycle k is the outer
/// ring of polygon k, counter-clockwise. After all outer rings come the holes of all polygons,
/// clockwise. A ring that runs in the other direction is reversed. Lines and single points are left
/// out. A hole with fewer than three different corners is left out. Throws Error{DegenerateFace} if
/// an outer ring has fewer than three different corners. Cost: O(n log n) for n corners.
Map map_of_polygons(const PlaneShapes& shapes, Context& context = unlimited_context());

/// The result of read_map_or_polygons().
struct MapFile {
  Map map;  ///< The map.
  /// Whether the file lists polygons, which map_of_polygons() made into the map.
  bool is_polygons = false;
  /// Notes about contents of a file of polygons that are not in `map`.
  std::vector<std::string> notes;
  std::size_t dropped = 0;  ///< Number of lines and single points that were left out.
};

/// Reads the file `path`, or standard input if `path` is "-". If the file is in WKT, GeoJSON or
/// WKB, its polygons are made into a map by map_of_polygons(). Any other file is read by
/// read_map(). The format is determined by the extension of the file, or by its first bytes if the
/// extension is unknown. `options.name` is ignored. Throws the errors of these readers.
MapFile read_map_or_polygons(const std::string& path, ReadOptions options = {},
                             Context& context = unlimited_context());

/// Does the same as the function above for a file whose contents `text` the caller has read
/// already. `path` is the path of the file, and its extension determines the format. Throws the
/// errors of the readers.
MapFile read_map_or_polygons(std::string_view text, const std::string& path, ReadOptions options,
                             Context& context);

/// Writes a map without loss. If ReadOptions::exact_decimals is false, read_map() returns the same
/// points and cycles from the written text. When the function returns, all bytes have been passed
/// to `out`, but `out` has not been flushed. Exceptions of `out` reach the caller.
void write_map(std::ostream& out, const Map& map);

}  // namespace plumb
#pragma GCC visibility pop
