// Reads planar maps: `n f`, n lines `x y`, f lines of 1-based vertex ids (docs/formats.md, "map").
//
//  1. read_counts    the header; claims are checked against the bytes that follow
//  2. read_vertices  exactly two numbers a line (number_reader.h)
//  3. read_faces     at least three ids a line, in range, no vertex twice in a row, not all on one
//                    line of the plane (exact)
//  4. nothing but blank and comment lines may follow
//
// Cost: O(bytes) time; memory is the text and the map. Errors are thrown with the place
// (file, line, column): NotText, Syntax, NumberOutOfRange, CountMismatch, BadIndex,
// DegenerateFace; besides CannotOpen, ResourceLimit, Cancelled.
#pragma once

#include <string>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/plane/map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The map written in `text`. The memory of the map stays charged to `context`.
Map read_map(std::string_view text, const ReadOptions& options, Context& context);

/// The same from a file, or from standard input for "-". `options.name` is ignored.
Map read_map_file(const std::string& path, ReadOptions options, Context& context);

}  // namespace plumb
#pragma GCC visibility pop
