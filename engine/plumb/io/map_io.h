// Reads and writes planar maps: a header `n f`, n lines `x y`, and f lines of 1-based vertex ids
// (docs/formats.md, "map").
//
// Main flow of read_map:
//  1. read_counts    reads the header and checks its counts against the bytes that follow
//  2. read_vertices  reads exactly two numbers from each line (record_reader.h)
//  3. read_faces     reads at least three ids from each line, all in range, with no vertex twice in
//                    a row and not all vertices on one line of the plane (decided exactly)
//  4. end            accepts only blank lines and comments after the faces
//
// Cost: O(bytes) time; the memory holds the text and the map. Errors: NotText, Syntax,
// NumberOutOfRange, CountMismatch, BadIndex and DegenerateFace, thrown with the place (file, line,
// column); CannotOpen, ResourceLimit and Cancelled.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/plane/map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the map that `text` holds. The memory of the map stays charged to `context`. Throws the
/// errors stated above.
Map read_map(std::string_view text, const ReadOptions& options = {},
             Context& context = unlimited_context());

/// Reads the file `path`, or standard input if `path` is "-", and returns its map. `options.name`
/// is ignored. Throws the errors stated above.
Map read_map_file(const std::string& path, ReadOptions options = {},
                  Context& context = unlimited_context());

/// Writes a map without loss: read_map() of the text, without exact decimals, returns the same
/// points and cycles. Its own buffer is flushed at the end, `out` is not. Throws what `out` throws.
void write_map(std::ostream& out, const Map& map);

}  // namespace plumb
#pragma GCC visibility pop
