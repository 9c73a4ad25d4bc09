// Draws the overlay of two maps as SVG. Each pair of regions has a colour. The names of the two
// regions are written on every face that is large enough. The file does not load other files and
// has no scripts. The y-axis points upwards.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "plumb/base/ids.h"
#include "plumb/plane/map_overlay.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Options of the picture of an overlay.
struct OverlaySvgOptions {
  std::string title = {};             ///< The title, such as the names of files. May be any bytes.
  std::string first = "first map";    ///< Name of the first map in the legend. May be any bytes.
  std::string second = "second map";  ///< Name of the second map in the legend. May be any bytes.
  /// The names of the regions of the two maps. Entry r of a list is the name of region r of its
  /// map. Entry 0 is not used.
  std::vector<std::string> first_names = {}, second_names = {};
};

/// Writes the picture of an overlay. The file takes at most 20 MB. If parts of the overlay are left
/// out to stay below this size, the picture names these parts. The output is deterministic. Cost:
/// O(n log n) for n cells. Exceptions of `out` reach the caller.
void write_overlay_svg(std::ostream& out, const MapOverlay& overlay,
                       const OverlaySvgOptions& options = {});

/// The colour of a pair of regions. A colour is a shade of a tint. All pairs with the same region
/// of the first map have the same tint. Different shades distinguish these pairs. Neighbouring
/// faces get different colours, unless the overlay needs more tints or shades than there are.
struct OverlayColour {
  /// The tint, from 0 to kTints - 1. The value kTints stands for faces in the unbounded region of
  /// the first map.
  std::uint8_t tint;
  std::uint8_t shade;  ///< The shade, from 0 to kShades - 1.
  friend bool operator==(const OverlayColour&, const OverlayColour&) = default;
};
inline constexpr std::size_t kShades = 4;  ///< Number of shades of each tint.

/// Returns the colour of each face of the complex. Cost: O(n log n) for n cells.
IdVector<FaceId, OverlayColour> colour_cells(const MapOverlay& overlay);

}  // namespace plumb
#pragma GCC visibility pop
