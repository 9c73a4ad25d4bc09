// plumb.SimplifyReport: what PlaneSet.simplified_with_report() and Layer.simplified_with_report()
// say about their results.
#pragma once

#include <cstddef>

#include "plumb/plane/layer_simplify.h"
#include "plumb/plane/plane_simplify.h"

namespace plumb::python {

struct SimplifyReport {
  std::size_t corners_before, corners_after, fixed, blocked, overlaps;
  double borders_moved, rounding_moved;
};

inline SimplifyReport report_of(const SimplifiedLayer& made) {
  return {made.corners_before, made.corners_after,        made.fixed, made.blocked, made.overlaps,
          made.borders_moved,  made.rounding.largest_move};
}

/// Corners where several borders meet are not counted in a set of the plane, and nothing overlaps.
inline SimplifyReport report_of(const SimplifiedSet& made) {
  return {made.corners_before, made.corners_after,        0, made.blocked, 0,
          made.borders_moved,  made.rounding.largest_move};
}

}  // namespace plumb::python
