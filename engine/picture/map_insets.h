// Which places of a defective map deserve a closer look.
#pragma once

#include <vector>

#include "plumb/picture/map_marks.h"

namespace plumb {

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
