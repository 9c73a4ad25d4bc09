// Writes planar maps in the format that map_reader.h reads.
#pragma once

#include <ostream>

#include "plumb/plane/map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Exact: read_map() of the text (without exact decimals) gives the same points and cycles.
/// Throws what `out` throws; ends with a flush of its own buffer, not of `out`.
void write_map(std::ostream& out, const Map& map);

}  // namespace plumb
#pragma GCC visibility pop
