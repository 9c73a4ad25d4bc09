// Painting of a map's faces into a view, and the places that deserve a closer look.
#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "plumb/picture/map/map_marks.h"
#include "plumb/picture/plane/plane_view.h"

namespace plumb {

/// The limits of the content of a view.
struct PaintLimits {
  std::size_t points = 400000;
  std::size_t polygons = 60000;
  /// Whether it shows the whole map: lines are then thinner the more of them there are.
  bool is_overview = true;
};

/// The counts of drawn and omitted cycles.
struct PaintCounts {
  /// Cycles that were drawn.
  std::size_t drawn = 0;
  std::size_t tiny = 0;      ///< Cycles smaller than can be seen; a grey tint marks where they lie.
  std::size_t outside = 0;   ///< Cycles outside of the view.
  std::size_t left_out = 0;  ///< Cycles beyond the limits, which get a grey tint as well.
};

/// Paints cycles with their tints, in descending order of area. If areas are equal, clockwise
/// cycles come first. One painter serves several views.
class Painter {
 public:
  explicit Painter(const Plane& plane);

  /// Writes the faces seen in `view`; clockwise cycles get the colour of the background.
  PaintCounts paint(const View& view, const PaintLimits& limits, std::ostream& out) const;

 private:
  double line_width(const View& view, const PaintLimits& limits) const;

  const Plane& plane_;
  std::vector<std::uint8_t> colour_;  ///< The tint of each cycle; kTints for clockwise cycles.
  std::vector<std::uint32_t> order_;
  double perimeter_ = 0;  ///< The perimeter of all cycles, in units of the plane.
};

// The places of a defective map that deserve a closer look.

/// A close-up of part of a map.
struct Inset {
  Rectangle window;         ///< The part of the plane it shows.
  std::size_t defects = 0;  ///< Defects that it shows and windows chosen earlier do not.
};

/// Returns at most `max` windows around defects whose edges are too short to be seen in `overview`.
/// Windows with many defects come first. No two windows overlap much. `aspect` is width / height.
/// Cost: O(d^2) for the first thousand defects.
std::vector<Inset> choose_insets(const MapReport& report, const Plane& plane, const View& overview,
                                 double aspect, std::size_t max);

}  // namespace plumb
