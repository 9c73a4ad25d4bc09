// The cells of two maps laid over each other as a picture: one colour a pair of regions, the pair
// written on every cell that has room for it. Self-contained SVG without scripts, y axis upwards.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "plumb/plane/map_overlay.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What the page of an overlay shows.
struct OverlaySvgOptions {
  std::string title = {};             ///< e.g. the files' names; any bytes
  std::string first = "first map";    ///< what the maps are called in the legend
  std::string second = "second map";  ///< any bytes
  /// What regions are called on the cells, by region; 0 is not used.
  std::vector<std::string> first_names = {}, second_names = {};
};

/// Writes the picture of an overlay. At most 20 MB; what is left out for that is said in it.
/// Deterministic. O(n log n).
void write_overlay_svg(std::ostream& out, const MapOverlay& overlay,
                       const OverlaySvgOptions& options = {});

/// A colour for each pair of regions: pairs of the same region of the first map are shades of one
/// tint; neighbours differ as long as the tints and shades suffice.
struct OverlayColour {
  std::uint8_t tint;   ///< 0 .. kTints - 1; kTints: outside of the first map
  std::uint8_t shade;  ///< 0 .. kShades - 1
  friend bool operator==(const OverlayColour&, const OverlayColour&) = default;
};
inline constexpr std::size_t kShades = 4;  ///< shades of each tint

/// Per face of the complex. O(n log n).
std::vector<OverlayColour> colour_cells(const MapOverlay& overlay);

}  // namespace plumb
#pragma GCC visibility pop
