// Signs of the predicates' determinants by Boost integers, straight from their definitions.
#pragma once

#include <vector>

#include "plumb/predicates/point.h"
#include "plumb/predicates/sign.h"
#include "plumb/testing/exact.h"

namespace plumb::testing {

/// Coordinates as integers on one grid common to all points: signs of homogeneous polynomials of
/// differences are those of the points themselves. Requires finite coordinates.
std::vector<std::vector<BigInt>> on_common_grid(const std::vector<Point3>& points, int dimension);

/// Determinant by expansion along the first row.
BigInt determinant(const std::vector<std::vector<BigInt>>& rows);

/// orient2d, orient3d: rows p_i - p_last. incircle, insphere (lifted): with |p_i - p_last|^2 added.
/// The number of points is dimension + 1, or dimension + 2 when lifted.
Sign simplex_sign(const std::vector<Point3>& points, int dimension, bool lifted);

/// Sign of (b - a) x (d - c), from x and y.
Sign cross_sign_oracle(const Point3& a, const Point3& b, const Point3& c, const Point3& d);

}  // namespace plumb::testing
