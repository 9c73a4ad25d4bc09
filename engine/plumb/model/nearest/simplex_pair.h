// The nearest points of two simplices of space: points, segments and triangles. One function
// computes bounds in doubles, the other one exact points.
//
// The exact nearest points are found by faces. For a pair of faces, the points of their affine
// hulls that are nearest to each other solve a linear system. A solution is the answer if its
// points lie in the faces, and if no corner lies beyond the planes through both points that are
// orthogonal to the segment between them. Why some pair of faces gives the answer: the pairs of
// nearest points form a convex polytope. Let (p, q) be a corner of it, F the face with p in its
// relative interior, and G the face with q in its relative interior. If the system of F and G had
// several solutions, p and q could move both ways along them and stay nearest, and (p, q) would not
// be a corner. So the system has one solution, and (p, q) is this solution. A triangle and a
// triangle have no such system, because the six directions of two planes are never independent.
#pragma once

#include <array>
#include <cstdint>

#include "plumb/predicates/rational_point.h"

namespace plumb {

/// A point, segment or triangle with corners of type Point. The corners need not be independent.
template <class Point>
struct SimplexOf {
  std::array<Point, 3> corner;  ///< The corners.
  std::uint32_t size = 0;       ///< The number of corners, 1 to 3.
};
/// Corners rounded to doubles.
using RoundedSimplex = SimplexOf<std::array<double, 3>>;
/// Exact corners.
using ExactSimplex = SimplexOf<RationalPoint3>;

/// A face of a simplex: bit i is set if corner i belongs to the face.
using SimplexFace = std::uint32_t;

/// Bounds for the distance of two simplices, and the faces on which the nearest points probably
/// lie.
struct DistanceBounds {
  double lower;       ///< At most the distance.
  double upper;       ///< At least the distance.
  SimplexFace a = 1;  ///< A face of the first simplex.
  SimplexFace b = 1;  ///< A face of the second simplex.
  /// The vector from the first simplex to the second one, about as long as the upper bound.
  std::array<double, 3> toward = {0, 0, 0};
};

/// Returns bounds for the distance of two simplices, given slack_of() all corners.
DistanceBounds distance_bounds(const RoundedSimplex& a, const RoundedSimplex& b, double slack);

/// Returns a bound for the errors of distances in doubles. `magnitude` is at least the absolute
/// value of every coordinate, and at most 2^500; `error` is at least the difference of any
/// coordinate and its exact value. A point of a simplex moves by at most 2 * error with the
/// corners, and so do both ends of a gap; the roundings of a computation sum up to less than
/// magnitude * 2^-46.
constexpr double slack_of(double magnitude, double error) {
  return magnitude * 0x1p-44 + 8 * error;
}

/// The nearest points of two simplices.
struct NearestPoints {
  RationalPoint3 a;    ///< A point of the first simplex.
  RationalPoint3 b;    ///< A point of the second simplex.
  Rational squared;    ///< The square of their distance.
  SimplexFace face_a;  ///< The face of the first simplex with `a` in its relative interior.
  SimplexFace face_b;  ///< The face of the second simplex with `b` in its relative interior.
};

/// Returns nearest points of two simplices. The faces are tried first.
NearestPoints nearest_points(const ExactSimplex& a, SimplexFace guess_a, const ExactSimplex& b,
                             SimplexFace guess_b);

}  // namespace plumb
