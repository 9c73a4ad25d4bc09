// Doubles with error bounds for a plane: PlaneRow from input points (fast) or from exact
// coefficients (always tight).
#pragma once

#include "plumb/predicates/space/plane_exact.h"
#include "plumb/predicates/space/plane_table.h"

namespace plumb {

/// One half of every stored error, at least (see PlaneRow).
inline constexpr double kUnitError = 0x1p-49;

/// The row of the plane through p, q, r, if doubles give it to a relative error of 2^-36; and
/// whether its canonical orientation is against (q - p) x (r - p), if doubles can tell.
struct FastRow {
  bool is_good;
  bool is_flipped;
  PlaneRow row;
};
FastRow fast_row(const Point3& p, const Point3& q, const Point3& r);

/// The row of exact coefficients whose orientation is canonical already. Never fails; the
/// errors are kUnitError times the values, except where an offset leaves [2^-100, 2^100].
template <class Plane>
PlaneRow exact_row(const Plane& plane);

extern template PlaneRow exact_row(const exact3::FixedPlane<exact3::Medium>&);
extern template PlaneRow exact_row(const exact3::BigPlane&);

/// x as a float that is not smaller, for 0 <= x; never subnormal, infinite beyond the floats.
float rounded_up(double x);

}  // namespace plumb
