// Draws a checked map as SVG. The picture has tinted faces, the defects over them, close-ups, a
// legend, and a list of the first defects. The file is self-contained and has no scripts. The
// y-axis points upwards.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "plumb/plane/map_check.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of the picture of a map.
struct MapSvgOptions {
  std::string title = {};       ///< The title, for example the name of the file. Any bytes.
  std::size_t max_listed = 20;  ///< The largest number of defects listed below the map.
  std::size_t max_insets = 6;   ///< The largest number of close-ups, 0 to 6.
};

/// Writes the picture of a report. The map may be valid or defective, with any finite coordinates
/// and any number of faces. The file stays below 20 MB. To achieve this for 10^6 faces, small faces
/// are drawn as a grey tint. The file takes about 0.2 MB for a thousand faces of 10 corners. The
/// output is deterministic. Cost: O(n log n) for n corners, plus O(n) for each close-up. Passes on
/// exceptions of `out`.
void write_map_svg(std::ostream& out, const MapReport& report, const MapSvgOptions& options = {});

}  // namespace plumb
#pragma GCC visibility pop
