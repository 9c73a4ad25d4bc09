// What the rungs of fixed width say of one question about planes or their points: narrow, medium,
// wide.
#pragma once

#include <array>
#include <cstddef>

#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/space/point3_table.h"

namespace plumb::fixed_rungs {

using exact3::Medium;
using exact3::Narrow;
using exact3::Wide;

using Fixed3 = std::array<FilteredSign, 3>;

inline Fixed3 det3(const PlaneTable& t, PlaneId p, PlaneId q, PlaneId r) {
  return {rung::det3_fixed<Narrow>(t, p, q, r), rung::det3_fixed<Medium>(t, p, q, r),
          rung::det3_fixed<Wide>(t, p, q, r)};
}

inline Fixed3 det4(const PlaneTable& t, PlaneId p, PlaneId q, PlaneId r, PlaneId s) {
  return {rung::det4_fixed<Narrow>(t, p, q, r, s), rung::det4_fixed<Medium>(t, p, q, r, s),
          rung::det4_fixed<Wide>(t, p, q, r, s)};
}

inline Fixed3 minor(const PlaneTable& t, PlaneId p, PlaneId q, std::size_t axis) {
  return {rung::minor_fixed<Narrow>(t, p, q, axis), rung::minor_fixed<Medium>(t, p, q, axis),
          rung::minor_fixed<Wide>(t, p, q, axis)};
}

inline Fixed3 side(const Point3Table& t, SpacePoint x, PlaneId p) {
  return {rung::side_fixed<Narrow>(t, x, p), rung::side_fixed<Medium>(t, x, p),
          rung::side_fixed<Wide>(t, x, p)};
}

inline Fixed3 compare_axis(const Point3Table& t, SpacePoint x, SpacePoint y, std::size_t axis) {
  return {rung::compare_axis_fixed<Narrow>(t, x, y, axis),
          rung::compare_axis_fixed<Medium>(t, x, y, axis),
          rung::compare_axis_fixed<Wide>(t, x, y, axis)};
}

}  // namespace plumb::fixed_rungs
