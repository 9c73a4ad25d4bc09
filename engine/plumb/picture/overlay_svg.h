// Draws the overlay of two maps: one colour for each pair of regions, with the pair written on
// every cell that is large enough. The file is self-contained SVG without scripts; y points
// upwards.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "plumb/plane/map_overlay.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of the picture of an overlay.
struct OverlaySvgOptions {
  std::string title = {};             ///< The title, such as the names of the files; any bytes.
  std::string first = "first map";    ///< The first map in the legend; any bytes.
  std::string second = "second map";  ///< The second map in the legend; any bytes.
  /// The names of regions on the cells, indexed by region; entry 0 is not used.
  std::vector<std::string> first_names = {}, second_names = {};
};

/// Writes the picture of an overlay. The file takes at most 20 MB and states what is left out for
/// that. The output is deterministic. Cost: O(n log n). Throws what `out` throws.
void write_overlay_svg(std::ostream& out, const MapOverlay& overlay,
                       const OverlaySvgOptions& options = {});

/// The colour of a pair of regions. Pairs with the same region of the first map are shades of one
/// tint. Neighbours differ as long as tints and shades suffice.
struct OverlayColour {
  std::uint8_t tint;   ///< 0 to kTints - 1, or kTints outside the first map.
  std::uint8_t shade;  ///< 0 to kShades - 1.
  friend bool operator==(const OverlayColour&, const OverlayColour&) = default;
};
inline constexpr std::size_t kShades = 4;  ///< Number of shades of each tint.

/// Returns the colour of each face of the complex. Cost: O(n log n).
std::vector<OverlayColour> colour_cells(const MapOverlay& overlay);

}  // namespace plumb
#pragma GCC visibility pop
