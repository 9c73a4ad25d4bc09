// A checked map as a picture: tinted faces, defects drawn over them, close-ups, a legend, the list
// of the first defects. Self-contained SVG without scripts, y axis of the map upwards.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>

#include "plumb/plane/map_check.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What the page of a map shows.
struct MapSvgOptions {
  std::string title = {};       ///< e.g. the file's name; any bytes
  std::size_t max_listed = 20;  ///< defects written out below the map
  std::size_t max_insets = 6;   ///< 0 to 6 close-ups
};

/// Writes the picture of a report, valid or not. Any finite coordinates, any number of faces: the
/// file stays below 20 MB (10^6 faces: small ones become a grey tint), about 0.2 MB a thousand
/// faces of 10 corners. Deterministic. O(n log n) for n corners, plus O(n) for each close-up.
void write_map_svg(std::ostream& out, const MapReport& report, const MapSvgOptions& options = {});

}  // namespace plumb
#pragma GCC visibility pop
