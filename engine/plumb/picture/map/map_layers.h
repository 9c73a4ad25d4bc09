// Painting the faces of a map into a view.
#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "plumb/picture/map/map_marks.h"
#include "plumb/picture/plane/plane_view.h"

namespace plumb {

/// What a view may hold.
struct PaintLimits {
  std::size_t points = 400000;
  std::size_t polygons = 60000;
  bool is_overview = true;  ///< of the whole map: lines thinner the more of them there are
};

/// What became of the cycles.
struct PaintCounts {
  std::size_t drawn = 0;
  std::size_t tiny = 0;      ///< smaller than can be seen: a grey tint where they lie
  std::size_t outside = 0;   ///< of the view
  std::size_t left_out = 0;  ///< beyond the limits: grey tint as well
};

/// Cycles by decreasing area, a clockwise one before counter-clockwise ones of the same area; with
/// their tints. Kept for several views.
class Painter {
 public:
  explicit Painter(const Plane& plane);

  /// Writes the faces seen in `view`, clockwise cycles in the colour of the background.
  PaintCounts paint(const View& view, const PaintLimits& limits, std::ostream& out) const;

 private:
  double line_width(const View& view, const PaintLimits& limits) const;

  const Plane& plane_;
  std::vector<std::uint8_t> colour_;  ///< kTints: clockwise
  std::vector<std::uint32_t> order_;
  double perimeter_ = 0;  ///< of all cycles, plane units
};

// Which places of a defective map deserve a closer look.

struct Inset {
  Rectangle window;         ///< of the plane
  std::size_t defects = 0;  ///< that it shows and windows chosen earlier do not
};

/// At most `max` windows, those with most defects first, none overlapping much of another; only
/// where the defects' edges are too short to be seen in `overview`. `aspect` = width / height.
/// O(d^2) for the first thousand defects.
std::vector<Inset> choose_insets(const MapReport& report, const Plane& plane, const View& overview,
                                 double aspect, std::size_t max);

}  // namespace plumb
