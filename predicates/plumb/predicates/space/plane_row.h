// The row of a plane: doubles with error bounds, from input points in doubles, or from exact
// coefficients.
#pragma once

#include "plumb/predicates/space/plane_exact.h"
#include "plumb/predicates/space/plane_table.h"

namespace plumb {

/// The least error of a normal: half of the least stored normal_error (see PlaneRow).
inline constexpr double kUnitError = 0x1p-49;

/// The row of a plane through three points, if doubles give it.
struct FastRow {
  bool is_good;     ///< Whether the row and the orientation are known.
  bool is_flipped;  ///< Whether the canonical normal is opposite to (q - p) x (r - p).
  PlaneRow row;     ///< The row in canonical orientation.
};
/// Returns the row of the plane through p, q, r. It is good if doubles give the normal with an
/// error of at most 2^-37 of its largest component, and the sign of its first nonzero component.
FastRow fast_row(const Point3& p, const Point3& q, const Point3& r);

/// Returns the row of exact coefficients. Never fails. The stored errors are 2 kUnitError for the
/// normal and 2 kUnitError |d| for the offset, at least FLT_MIN and infinite beyond the floats; an
/// offset above 2^900 counts as unknown. Requires canonical orientation.
template <class Plane>
PlaneRow exact_row(const Plane& plane);

extern template PlaneRow exact_row(const exact3::FixedPlane<exact3::Medium>&);
extern template PlaneRow exact_row(const exact3::LongPlane&);
extern template PlaneRow exact_row(const exact3::BigPlane&);

/// Returns a float that is not less than x: at least FLT_MIN, and infinite beyond the floats.
/// Requires x >= 0.
float rounded_up(double x);

}  // namespace plumb
