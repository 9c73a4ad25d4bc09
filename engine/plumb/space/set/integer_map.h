// An affine map of points and planes in integers. Internal.
#pragma once

#include <array>

#include "plumb/predicates/arithmetic/fingerprint.h"
#include "plumb/predicates/sign.h"
#include "plumb/space/boolean/frame.h"
#include "plumb/space/complex/space_tables.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// An affine map x -> M x + t in integers without a common factor. With a common denominator c let
/// M = A / c and t = b / c. A point X / w goes to (A X + b w) / (c w). Up to the factor |det A|,
/// which is positive, a plane n.x + d = 0 goes to c s (n adj A).x + |det A| d - s (n adj A).b,
/// where s is the sign of det A.
class IntegerMap {
 public:
  /// Requires an invertible map.
  explicit IntegerMap(const AffineMap3& map);

  /// Returns the sign of det M.
  Sign determinant() const { return determinant_; }
  /// Returns the image of a point in homogeneous coordinates, the last one positive.
  IntegerRow image_of_point(const IntegerRow& x) const {
    return {product(point_[0], x), product(point_[1], x), product(point_[2], x), weight_ * x[3]};
  }
  /// Returns the image of a plane up to a positive factor, with the image of its positive side as
  /// its positive side.
  IntegerRow image_of_plane(const IntegerRow& plane) const {
    return {product(plane_[0], plane), product(plane_[1], plane), product(plane_[2], plane),
            product(plane_[3], plane)};
  }
  /// Returns the matrix of image_of_plane(). Its row k gives coefficient k of the image.
  const std::array<IntegerRow, 4>& plane_matrix() const { return plane_; }
  /// Returns the matrix of image_of_point() without its last row. Row k gives coordinate k.
  const std::array<IntegerRow, 3>& point_matrix() const { return point_; }
  /// Returns the factor of the last homogeneous coordinate of a point.
  const Integer& weight() const { return weight_; }

 private:
  using IntegerVector = std::array<Integer, 3>;

  void take_denominators(const RationalRow& row);
  Integer whole(const Rational& x) const { return numerator(x) * (weight_ / denominator(x)); }
  void set_planes(const std::array<IntegerVector, 3>& a);
  void divide_planes();
  static Integer product(const IntegerRow& a, const IntegerRow& b);

  std::array<IntegerRow, 3> point_;  // The rows of A, each followed by a coordinate of b.
  std::array<IntegerRow, 4> plane_;  // Row k gives coefficient k of a plane.
  Integer weight_ = 1;               // The common denominator c.
  Sign determinant_ = Sign::Zero;
};

/// Returns the plane with these coefficients, and adds it if the table does not have it.
OrientedPlane intern_row(PlaneTable& planes, IntegerRow row);
/// Adds the point with these homogeneous coordinates, the last of which is positive. It becomes an
/// input point if its coordinates are doubles.
SpacePoint add_point(SpaceTables& tables, const IntegerRow& x);

}  // namespace plumb
