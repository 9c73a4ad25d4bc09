// Draws a layer that was checked or repaired. The features are drawn in different tints. The
// overlaps, gaps and holes of the layer are drawn on top of the features. Crossings and nestings
// are marked by circles. The SVG file has no scripts, and the HTML file has a close-up of each
// region. Neither file loads other files. The y-axis points upwards.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "plumb/plane/layer.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of the picture of a layer.
struct LayerSvgOptions {
  std::string title = {};  ///< The title, such as the name of the file. May be any bytes.
  /// The largest number of regions (LayerReport::regions) listed below the map.
  std::size_t max_listed = 20;
  std::size_t max_close_ups = 200;  ///< The largest number of close-ups in the HTML file.
};

/// Writes the picture of a layer and of the regions that its report lists. Crossings, and regions
/// that are too small to be seen, are marked by circles. The file takes at most 20 MB. If features
/// are left out to stay below this size, a note in the picture says so. The output is
/// deterministic. Cost: O(n) for n corners. Exceptions of `out` reach the caller.
void write_layer_svg(std::ostream& out, const Layer& layer, const LayerReport& report,
                     const LayerSvgOptions& options = {});

/// Writes an HTML page with the picture that write_layer_svg() writes, and a list of the regions.
/// If the user clicks on one of them in the picture or in the list, the page shows its close-up.
/// Defects are listed before holes. Cost: O(n) for n corners, and O(n) for each close-up.
/// Exceptions of `out` reach the caller.
void write_layer_html(std::ostream& out, const Layer& layer, const LayerReport& report,
                      const LayerSvgOptions& options = {});

}  // namespace plumb
#pragma GCC visibility pop
