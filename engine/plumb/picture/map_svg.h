// Draws a checked map as SVG. The picture shows the faces in different tints, and the defects on
// top of the faces. The picture also has close-ups, a legend, and a list of the first defects. The
// file does not load other files and has no scripts. The y-axis points upwards.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "plumb/base/context.h"
#include "plumb/plane/map_check.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of the picture of a map.
struct MapSvgOptions {
  std::string title = {};       ///< The title, such as the name of the file. May be any bytes.
  std::size_t max_listed = 20;  ///< The largest number of defects listed below the map.
  std::size_t max_insets = 6;   ///< The largest number of close-ups, 0 to 6.
  /// The context. Its checkpoint() is called before the map and before each close-up are drawn. A
  /// null pointer means that there are no limits, no stop request and no progress callback.
  Context* context = nullptr;
};

/// Writes the picture of a report. The map may be valid or defective. The map may have any finite
/// coordinates and any number of faces. The file is always smaller than 20 MB. To stay below this
/// size even for 10^6 faces, the picture shows small faces only as a grey tint. For a thousand
/// faces of 10 corners, the file takes about 0.2 MB. The output is deterministic. Cost: O(n log n)
/// for n corners, plus O(n) for each close-up. Exceptions of `out` reach the caller.
void write_map_svg(std::ostream& out, const MapReport& report, const MapSvgOptions& options = {});

}  // namespace plumb
#pragma GCC visibility pop
