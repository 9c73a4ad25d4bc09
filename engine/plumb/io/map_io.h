// Reads and writes planar maps as text (docs/formats.md, "map"). The text consists of a header
// `n f`, n lines `x y` with the coordinates of the vertices, and f lines with the 1-based vertex
// ids of the faces.
//
// Main flow of read_map:
//  1. read_counts    reads the header and checks its counts against the number of bytes that follow
//  2. read_vertices  reads exactly two numbers from each line (record_reader.h)
//  3. read_faces     reads the vertex ids of each face from its line. There must be at least three
//                    ids, all in range. The same id must not occur twice in a row. The points of
//                    the vertices must not all be collinear, which is decided exactly.
//  4. end            accepts only blank lines and comments after the faces
//
// Cost: O(bytes) time. Text and map are in memory together.
//
// Errors: NotText, Syntax, NumberOutOfRange, CountMismatch, BadIndex and DegenerateFace name the
// file, line and column. Other errors are CannotOpen, ResourceLimit and Cancelled.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/plane/map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the map that `text` describes. The memory of the map stays charged to `context`. Throws
/// the errors stated above.
Map read_map(std::string_view text, const ReadOptions& options = {},
             Context& context = unlimited_context());

/// Reads the file `path`, or standard input if `path` is "-", and returns its map. `options.name`
/// is ignored. Throws the errors stated above.
Map read_map_file(const std::string& path, ReadOptions options = {},
                  Context& context = unlimited_context());

/// Writes a map without loss. If read_map() reads the text without ReadOptions::exact_decimals, it
/// returns the same points and cycles. At the end all bytes have been passed to `out`, but `out` is
/// not flushed. Passes on exceptions of `out`.
void write_map(std::ostream& out, const Map& map);

}  // namespace plumb
#pragma GCC visibility pop
