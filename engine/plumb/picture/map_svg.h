// Draws a checked map: tinted faces, defects drawn over them, close-ups, a legend, and a list of
// the first defects. The file is self-contained SVG without scripts; y points upwards.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "plumb/plane/map_check.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of the picture of a map.
struct MapSvgOptions {
  std::string title = {};       ///< The title, such as the name of the file; any bytes.
  std::size_t max_listed = 20;  ///< The largest number of defects listed below the map.
  std::size_t max_insets = 6;   ///< The largest number of close-ups, 0 to 6.
};

/// Writes the picture of a report of a valid or defective map, with any finite coordinates and any
/// number of faces. The file stays below 20 MB (with 10^6 faces, small ones become a grey tint); it
/// takes about 0.2 MB for a thousand faces of 10 corners. The output is deterministic. Cost:
/// O(n log n) for n corners, plus O(n) for each close-up. Throws what `out` throws.
void write_map_svg(std::ostream& out, const MapReport& report, const MapSvgOptions& options = {});

}  // namespace plumb
#pragma GCC visibility pop
