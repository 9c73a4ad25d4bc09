#include "plumb/convex/vertical.h"

#include "plumb/base/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

Integer dot(const IntegerRow& row, const std::array<Integer, 3>& v) {
  return row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
}

}  // namespace

Vertical::Vertical(const std::array<Integer, 3>& direction, SpaceTables& tables)
    : direction_(direction), tables_(tables) {
  for (std::size_t i = 1; i < 3; ++i) {
    if (abs(direction_[i]) > abs(direction_[axis_])) axis_ = i;
  }
  PLUMB_CHECK(direction_[axis_] != 0);
  if (direction_[axis_] < 0) {
    for (Integer& d : direction_) d = -d;
  }
}

Sign Vertical::rise(PlaneId p) {
  if (p.value() >= rise_.size()) rise_.resize(tables_.planes.size(), FilteredSign::Unsure);
  FilteredSign& known = rise_[p.value()];
  if (!is_decided(known)) {
    known = filtered(sign_of(dot(tables_.planes.coefficients(p), direction_)));
  }
  return decided(known);
}

OrientedPlane Vertical::through(const std::array<PlaneId, 2>& line) {
  const Integer first = dot(tables_.planes.coefficients(line[0]), direction_);
  const Integer second = dot(tables_.planes.coefficients(line[1]), direction_);
  const OrientedPlane wall = tables_.planes.intern(Pencil{line[0], line[1], first, second});
  PLUMB_CHECK(wall.is_valid());
  return wall;
}

PlaneId Vertical::through(SpacePoint x, PlaneId avoided) {
  const RationalPoint3 at = exact(tables_.points, x);
  const std::array<Integer, 3>& d = direction_;
  PlaneId other;
  for (std::size_t i = 0; i < 3 && !other.is_valid(); ++i) {
    // d x e_i
    std::array<Rational, 3> n;
    n[(i + 1) % 3] = d[(i + 2) % 3];
    n[(i + 2) % 3] = -d[(i + 1) % 3];
    const Rational offset = -(n[0] * at.x + n[1] * at.y + n[2] * at.z);
    const OrientedPlane plane = tables_.planes.intern(n[0], n[1], n[2], offset);
    if (plane.is_valid() && plane.plane() != avoided) other = plane.plane();
  }
  PLUMB_CHECK(other.is_valid());  // two vertical planes go through every point
  return other;
}

double Vertical::slope(std::size_t axis) const {
  return nearest_double(Rational(direction_[axis], direction_[axis_]));
}

}  // namespace plumb
