#include "plumb/model/transform.h"

#include <algorithm>
#include <cmath>

#include "plumb/model/primitives.h"
#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/vectors.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

using Vector = std::array<Rational, 3>;

AffineMap3 identity() {
  AffineMap3 map;
  for (std::size_t i = 0; i < 3; ++i) map.matrix[i][i] = 1;
  return map;
}

/// Returns the rotation of the quaternion w + x i + y j + z k, which need not have the length 1.
/// The matrix is orthogonal unless all four numbers are zero.
AffineMap3 rotation_of_quaternion(const Rational& w, const Vector& v) {
  const Rational& x = v[0];
  const Rational& y = v[1];
  const Rational& z = v[2];
  const Rational n = w * w + dot(v, v);
  AffineMap3 map;
  map.matrix = {
      {{(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n},
       {2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n},
       {2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n}}};
  return map;
}

/// Returns the direction of an axis as doubles. Its length is 1 up to rounding.
std::array<double, 3> unit_axis(std::array<double, 3> axis) {
  const double largest = std::max({std::fabs(axis[0]), std::fabs(axis[1]), std::fabs(axis[2])});
  if (!(largest > 0)) throw Error(ErrorCode::BadArgument, "the axis of a rotation is zero");
  for (double& a : axis) a /= largest;
  const double length = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  for (double& a : axis) a /= length;
  return axis;
}

const Rational& coordinate_of(const RationalPoint3& p, std::size_t axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

}  // namespace

AffineMap3 composed(const AffineMap3& second, const AffineMap3& first) {
  AffineMap3 map;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Vector column{first.matrix[0][j], first.matrix[1][j], first.matrix[2][j]};
      map.matrix[i][j] = dot(second.matrix[i], column);
    }
    map.offset[i] = dot(second.matrix[i], first.offset) + second.offset[i];
  }
  return map;
}

Rational determinant(const AffineMap3& map) {
  return dot(map.matrix[0], cross(map.matrix[1], map.matrix[2]));
}

AffineMap3 scaling(const std::array<Rational, 3>& factors) {
  AffineMap3 map;
  for (std::size_t i = 0; i < 3; ++i) map.matrix[i][i] = factors[i];
  return map;
}

AffineMap3 translation(const std::array<Rational, 3>& by) {
  AffineMap3 map = identity();
  map.offset = by;
  return map;
}

AffineMap3 reflection(const std::array<Rational, 3>& normal) {
  const Rational square = dot(normal, normal);
  if (square == 0) throw Error(ErrorCode::BadArgument, "the normal of a reflection is zero");
  AffineMap3 map = identity();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      map.matrix[i][j] -= 2 * normal[i] * normal[j] / square;
    }
  }
  return map;
}

// The quaternion of half the angle gives an orthogonal matrix whatever its rounding errors are; its
// length does not matter. The cosine and the sine of half the angle are never both zero, so no
// angle is a special case. About a coordinate axis, multiples of 90 degrees have a quaternion of
// equal numbers or of one number.
AffineMap3 rotation(const std::array<double, 3>& axis, double degrees) {
  for (const double number : {axis[0], axis[1], axis[2], degrees}) {
    if (is_finite(number)) continue;
    throw Error(ErrorCode::NotFinite, "the numbers of a rotation must be finite");
  }
  const std::array<double, 3> unit = unit_axis(axis);
  const double half = std::remainder(degrees, 720) / 2;
  const Rational sine = exact_rational(sine_of_degrees(half));
  Vector v;
  for (std::size_t i = 0; i < 3; ++i) v[i] = exact_rational(unit[i]) * sine;
  return rotation_of_quaternion(exact_rational(cosine_of_degrees(half)), v);
}

std::optional<BoundingBox3> bounding_box(const Nef3& set) {
  if (set.is_empty()) return std::nullopt;
  if (!set.is_bounded()) {
    throw Error(ErrorCode::BadArgument, "an unbounded set has no bounding box");
  }
  const SpaceComplex& c = set.complex();
  std::array<std::array<SpacePoint, 2>, 3> ends;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto& [low, high] = ends[axis];
    low = high = c.vertex_point[VertexId(0)];
    for (const SpacePoint p : c.vertex_point) {
      if (compare_axis(c.points(), p, low, axis) == Sign::Negative) low = p;
      if (compare_axis(c.points(), p, high, axis) == Sign::Positive) high = p;
    }
  }
  const auto end = [&](std::size_t axis, std::size_t side) {
    return coordinate_of(exact(c.points(), ends[axis][side]), axis);
  };
  return BoundingBox3{{end(0, 0), end(1, 0), end(2, 0)}, {end(0, 1), end(1, 1), end(2, 1)}};
}

AffineMap3 resizing(const BoundingBox3& box, const std::array<Rational, 3>& size,
                    const std::array<bool, 3>& is_automatic) {
  Vector factors{1, 1, 1};
  Rational greatest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (size[i].sign() < 0) throw Error(ErrorCode::BadArgument, "a size is negative");
    if (size[i] == 0) continue;
    const Rational extent = coordinate_of(box.high, i) - coordinate_of(box.low, i);
    if (extent == 0) throw Error(ErrorCode::BadArgument, "a flat set cannot be made thicker");
    factors[i] = size[i] / extent;
    greatest = std::max(greatest, factors[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (size[i] == 0 && is_automatic[i] && greatest != 0) factors[i] = greatest;
  }
  return scaling(factors);
}

}  // namespace plumb
