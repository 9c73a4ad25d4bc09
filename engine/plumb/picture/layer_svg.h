// Draws a checked or repaired layer: its features in tints, and its overlaps, gaps and holes on top
// of them. The SVG file has no scripts, and the HTML file has a close-up of each region. Neither
// file loads other files. The y-axis points upwards.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "plumb/plane/layer.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of the picture of a layer.
struct LayerSvgOptions {
  std::string title = {};           ///< The title, such as the name of the file. May be any bytes.
  std::size_t max_listed = 20;      ///< The largest number of regions listed below the map.
  std::size_t max_close_ups = 200;  ///< The largest number of close-ups in the HTML file.
};

/// Writes the picture of a layer and its report. Regions that are too small to be seen are marked
/// by circles. The file takes at most 20 MB; if features are left out for this reason, a note says
/// so. The output is deterministic. Cost: O(n) for n corners. Exceptions of `out` reach the caller.
void write_layer_svg(std::ostream& out, const Layer& layer, const LayerReport& report,
                     const LayerSvgOptions& options = {});

/// Writes one HTML page with this picture, and a list of the regions. A click on a region, in the
/// picture or in the list, shows its close-up. Overlaps and gaps come first. Cost: O(n) for n
/// corners, and O(n) for each close-up. Exceptions of `out` reach the caller.
void write_layer_html(std::ostream& out, const Layer& layer, const LayerReport& report,
                      const LayerSvgOptions& options = {});

}  // namespace plumb
#pragma GCC visibility pop
