// The distance of two sets of space or of the plane, exactly: the square of the distance, two
// nearest points, and the cells on which they lie.
//
// Distances are those of the closures: an open cube is as far from a point as a closed one, and two
// sets that touch have the distance 0, whether or not they have a common point. The square of the
// distance of two sets with rational coordinates is rational, and there are nearest points with
// rational coordinates.
//
// Main flow of distance():
//  1. clip       an unbounded set is cut off at a box around the other set, which is grown until
//                the distance is not greater than the margin of the box
//  2. nearest    (nearest/simplex_tree.h) the facets of both sets are cut into triangles. A search
//                in two trees of boxes finds the nearest triangles, free edges and isolated points:
//                lower bounds in doubles choose candidates, and the candidates are compared exactly
//  3. contained  if the boundaries do not meet, the distance is 0 only if a part of one boundary
//                lies in the other set. One vertex of each part is located, unless boxes already
//                show that the part lies outside
//
// Cost: O(n log n) for the trees, usually O(log n) for the search. Two balls of 20,480 triangles
// take some 10 ms. Every pair of triangles that doubles cannot tell from the nearest pair costs
// about 10 us; if many facets of the sets are parallel and equally far apart, there are many such
// pairs. Errors: Error{BadArgument} if a set is empty, or if both sets are unbounded; what the
// context throws.
#pragma once

#include <memory>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The distance of two sets of space.
struct SpaceDistance {
  Rational squared;     ///< The square of the distance; 0 if the closures meet.
  RationalPoint3 at_a;  ///< A point of the closure of A.
  RationalPoint3 at_b;  ///< A point of the closure of B; the distance of the two is least.
  /// The cell of A.complex() with `at_a`. If the distance is 0, this may be a volume.
  SpaceLocation cell_a;
  SpaceLocation cell_b;  ///< The cell of B.complex() with `at_b`.
};

/// The distance of two sets of the plane.
struct PlaneDistance {
  Rational squared;     ///< The square of the distance; 0 if the closures meet.
  RationalPoint2 at_a;  ///< A point of the closure of A.
  RationalPoint2 at_b;  ///< A point of the closure of B; the distance of the two is least.
  /// The cell of A.complex() with `at_a`. If the distance is 0, this may be a face.
  PlaneLocation cell_a;
  PlaneLocation cell_b;  ///< The cell of B.complex() with `at_b`.
};

/// Returns the square root of a number that is not negative, with a relative error of at most
/// 2^-52. Returns infinity if the root lies beyond the largest double.
[[nodiscard]] double root_of(const Rational& square);

/// Returns the distance of two sets. If several pairs of points are nearest, the result is one of
/// them.
[[nodiscard]] SpaceDistance distance(const Nef3& a, const Nef3& b,
                                     Context& context = unlimited_context());
/// Returns the distance of a set and a point, which counts as a set of one vertex.
[[nodiscard]] SpaceDistance distance(const Nef3& a, const RationalPoint3& p,
                                     Context& context = unlimited_context());
/// Returns the distance of two sets of the plane.
[[nodiscard]] PlaneDistance distance(const Nef2& a, const Nef2& b,
                                     Context& context = unlimited_context());
/// Returns the distance of a set of the plane and a point.
[[nodiscard]] PlaneDistance distance(const Nef2& a, const RationalPoint2& p,
                                     Context& context = unlimited_context());

/// A set that is prepared for many distances. Several threads may call const members at the same
/// time.
class DistanceIndex {
 public:
  /// Builds the trees. Throws Error{BadArgument} if the set is empty or unbounded. O(n log n).
  explicit DistanceIndex(const Nef3& set, Context& context = unlimited_context());
  DistanceIndex(const DistanceIndex&);             ///< Copies share the trees.
  DistanceIndex& operator=(const DistanceIndex&);  ///< Copies share the trees.
  ~DistanceIndex();                                ///< Releases the trees.

  /// Returns the distance of this set and another set.
  [[nodiscard]] SpaceDistance to(const DistanceIndex& other,
                                 Context& context = unlimited_context()) const;
  /// Returns the distance of this set and a point. O(log n) usually.
  [[nodiscard]] SpaceDistance to(const RationalPoint3& p,
                                 Context& context = unlimited_context()) const;

 private:
  struct [[gnu::visibility("hidden")]] State;
  std::shared_ptr<const State> state_;
};

}  // namespace plumb
#pragma GCC visibility pop
