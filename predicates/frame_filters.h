// Filters for the frame. A point that depends on it is P0 + u R with R beyond all bounds, and a form of
// such points is c0 + c1 R (plane_exact.h, Parts). The filters serve each part by itself, with other rows
// and boxes for the planes and points:
//
//   far   in units of R, for c1: of a plane d is the multiple of R that its offset is; a box is around u,
//         that of a point without R around 0
//   near  with 0 for R, for c0: a plane of the frame has no offset; a box is around P0
//
// What the far parts decide decides the whole. Only where c1 is known to be 0 may the near ones be asked.
#pragma once

#include <algorithm>
#include <cmath>

#include "plumb/predicates/point3_table.h"

namespace plumb {

/// The row but for its offset, which is 0 without error.
inline PlaneRow row_of_normal(PlaneRow row) {
  row.d = 0;
  row.offset_error = 0;
  return row;
}

/// The rows of the cube's planes are exact: a unit vector and +-1. Of other far planes the multiple is not in
/// the row: no filter decides.
inline PlaneRow far_row(const PlaneTable& planes, PlaneId p) {
  const PlaneSource& source = planes.source(p);
  PlaneRow row = planes.row(p);
  if (!source.is_frame()) return row_of_normal(row);
  if (source.frame_index() < planes.frame().size()) row.offset_error = 0;
  return row;
}

inline PlaneRow near_row(const PlaneTable& planes, PlaneId p) {
  return planes.is_frame(p) ? row_of_normal(planes.row(p)) : planes.row(p);
}

/// Requires a box that is finite or of a known direction.
inline PointBox far_box(const PointBox& box) {
  if (!is_far(box)) return {{}, 0};
  const auto& u = box.mid;
  return {u, kDirectionError * std::max({std::fabs(u[0]), std::fabs(u[1]), std::fabs(u[2])})};
}

}  // namespace plumb
