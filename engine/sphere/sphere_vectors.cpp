#include "plumb/sphere/sphere_vectors.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/predicates/decompose.h"

namespace plumb {
namespace {

void require_nonzero(const SphereVector& v) {
  if (v.is_zero()) throw Error(ErrorCode::BadArgument, "a direction must not be zero");
}

SphereVector vector_of(const IntegerRow& row) {
  const IntegerRow r = primitive(row);
  return {Rational(r[0]), Rational(r[1]), Rational(r[2])};
}

/// Gives planes of one table their place in another.
class Centring {
 public:
  explicit Centring(const PlaneTable& planes) : planes_(planes) {}

  PlaneId operator()(PlaneId p) {
    const auto [at, is_new] = centred_.try_emplace(p);
    if (is_new) {
      const IntegerRow row = planes_.coefficients(p);
      at->second =
          table_->intern(Rational(row[0]), Rational(row[1]), Rational(row[2]), Rational(0)).plane();
    }
    return at->second;
  }
  std::shared_ptr<const PlaneTable> table() const { return table_; }

 private:
  const PlaneTable& planes_;
  std::unordered_map<PlaneId, PlaneId> centred_;
  std::shared_ptr<PlaneTable> table_ = std::make_shared<PlaneTable>();
};

}  // namespace

SphereVector::SphereVector(double a, double b, double c) {
  if (!is_finite(a) || !is_finite(b) || !is_finite(c)) {
    throw Error(ErrorCode::NotFinite, "the coordinates of a direction must be finite numbers");
  }
  x = a;
  y = b;
  z = c;
}

Rational dot(const SphereVector& u, const SphereVector& v) {
  return u.x * v.x + u.y * v.y + u.z * v.z;
}

SphereVector cross(const SphereVector& u, const SphereVector& v) {
  return {Rational(u.y * v.z - u.z * v.y), Rational(u.z * v.x - u.x * v.z),
          Rational(u.x * v.y - u.y * v.x)};
}

bool is_same_direction(const SphereVector& u, const SphereVector& v) {
  return cross(u, v).is_zero() && dot(u, v) > 0;
}

OrientedPlane intern_circle(PlaneTable& planes, const SphereVector& normal) {
  require_nonzero(normal);
  return planes.intern(normal.x, normal.y, normal.z, Rational(0));
}

/// (v x e1) x (v x e2) = v (v . e3), for an axis e3 with v . e3 != 0.
SphereDirection intern_direction(PlaneTable& planes, const SphereVector& v) {
  require_nonzero(v);
  const std::array<SphereVector, 3> unit{SphereVector(1, 0, 0), SphereVector(0, 1, 0),
                                         SphereVector(0, 0, 1)};
  std::size_t axis = 0;
  while (dot(v, unit[axis]) == 0) ++axis;
  const OrientedPlane p = intern_circle(planes, cross(v, unit[(axis + 1) % 3]));
  const OrientedPlane q = intern_circle(planes, cross(v, unit[(axis + 2) % 3]));
  const SphereDirection u{p.plane(), q.plane()};
  const bool is_opposite = (dot(v, unit[axis]) < 0) != (p.is_opposite() != q.is_opposite());
  return is_opposite ? u.opposite() : u;
}

SphereVector exact_normal(const PlaneTable& planes, PlaneId circle) {
  IntegerRow row = planes.coefficients(circle);
  row[3] = 0;
  return vector_of(row);
}

SphereVector exact_direction(const PlaneTable& planes, SphereDirection u) {
  const IntegerRow p = planes.coefficients(u.p);
  const IntegerRow q = planes.coefficients(u.q);
  return vector_of({Integer(p[1] * q[2] - p[2] * q[1]), Integer(p[2] * q[0] - p[0] * q[2]),
                    Integer(p[0] * q[1] - p[1] * q[0]), Integer(0)});
}

std::shared_ptr<const PlaneTable> centred(const PlaneTable& planes, SphereMap& map) {
  Centring centring(planes);
  for (PlaneId& c : map.circle) c = centring(c);
  for (SphereDirection& u : map.direction) u = {centring(u.p), centring(u.q)};
  return centring.table();
}

}  // namespace plumb
