// Draws the overlay of two maps as SVG. Each pair of regions has a colour, and the names of the
// pair are written on every face that is large enough. The file is self-contained and has no
// scripts. The y-axis points upwards.
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
  std::string title = {};             ///< The title, for example names of files. Any bytes.
  std::string first = "first map";    ///< Name of the first map in the legend. Any bytes.
  std::string second = "second map";  ///< Name of the second map in the legend. Any bytes.
  /// The names that are written for the regions of the first map and of the second map. The index
  /// is the region. Entry 0 is not used.
  std::vector<std::string> first_names = {}, second_names = {};
};

/// Writes the picture of an overlay. The file takes at most 20 MB. If parts of the overlay are left
/// out for this reason, the picture states which. The output is deterministic. Cost: O(n log n).
/// Passes on exceptions of `out`.
void write_overlay_svg(std::ostream& out, const MapOverlay& overlay,
                       const OverlaySvgOptions& options = {});

/// The colour of a pair of regions. All pairs with the same region of the first map have the same
/// tint, in different shades. Neighbouring faces have different colours as long as there are enough
/// tints and shades.
struct OverlayColour {
  std::uint8_t tint;   ///< From 0 to kTints - 1; kTints for faces outside the first map.
  std::uint8_t shade;  ///< From 0 to kShades - 1.
  friend bool operator==(const OverlayColour&, const OverlayColour&) = default;
};
inline constexpr std::size_t kShades = 4;  ///< Number of shades of each tint.

/// Returns the colour of each face of the complex. Cost: O(n log n).
std::vector<OverlayColour> colour_cells(const MapOverlay& overlay);

}  // namespace plumb
#pragma GCC visibility pop
