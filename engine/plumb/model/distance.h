// Computes the exact distance between two sets of space or of the plane. The result consists of the
// square of the distance, a pair of nearest points, and the cells that contain these points.
//
// The distance between two sets is the distance between their closures. So it does not matter
// whether the sets contain their boundaries. For example, two sets that touch each other have the
// distance 0, even if they have no common point. The coordinates of sets are rational. Therefore
// the square of a distance is rational, and there are nearest points with rational coordinates.
//
// Main flow of distance():
//  1. clip       replaces an unbounded set by its part in a box around the other set. The box is
//                made larger until the distance is at most the margin between the other set and the
//                sides of the box
//  2. nearest    (nearest/simplex_tree.h) cuts the facets of both sets into triangles, and searches
//                for the nearest triangles, free edges and isolated points. The search uses one
//                tree of boxes for each set. Lower bounds in doubles select candidates, and the
//                candidates are compared exactly
//  3. contained  looks for a set that lies inside the other one. If the boundaries do not meet, the
//                distance is 0 only if a connected part of one boundary lies in the other set. To
//                find out, the step takes one vertex of each connected part of each boundary, and
//                locates this vertex in the other set. It omits parts whose boxes already show that
//                they lie outside the other set
//
// Cost: building the trees takes O(n log n) for n cells of both sets. The search usually takes
// O(log n). For two balls of 20,480 triangles, the function takes some 10 ms. For each pair of
// triangles, there is a lower bound for their distance. If the bound is not greater than the
// distance between the sets, the pair is compared exactly, in about 10 us. There are many such
// pairs if many facets of the sets are parallel and equally far apart. Errors: Error{BadArgument}
// if a set is empty, or if both sets are unbounded. Functions also throw the errors of the Context.
#pragma once

#include <memory>

#include "plumb/base/context.h"
#include "plumb/plane/nef2.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/nef3.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The distance between two sets of space.
struct SpaceDistance {
  Rational squared;     ///< The square of the distance; 0 if the closures meet.
  RationalPoint3 at_a;  ///< A point of the closure of A.
  RationalPoint3 at_b;  ///< A point of the closure of B, at the least distance from `at_a`.
  /// The cell of the complex of A that contains `at_a`. If the distance is 0, this may be a volume.
  SpaceLocation cell_a;
  SpaceLocation cell_b;  ///< The cell of the complex of B that contains `at_b`.
};

/// The distance between two sets of the plane.
struct PlaneDistance {
  Rational squared;     ///< The square of the distance; 0 if the closures meet.
  RationalPoint2 at_a;  ///< A point of the closure of A.
  RationalPoint2 at_b;  ///< A point of the closure of B, at the least distance from `at_a`.
  /// The cell of the complex of A that contains `at_a`. If the distance is 0, this may be a face.
  PlaneLocation cell_a;
  PlaneLocation cell_b;  ///< The cell of the complex of B that contains `at_b`.
};

/// Returns the square root of a number, with a relative error of at most 2^-52. Requires that the
/// number is not negative. Returns infinity if the root lies beyond the largest double.
[[nodiscard]] double root_of(const Rational& square);

/// Returns the distance between two sets. If several pairs of points have this distance, the result
/// contains one of these pairs.
[[nodiscard]] SpaceDistance distance(const Nef3& a, const Nef3& b,
                                     Context& context = unlimited_context());
/// Returns the distance between a set and a point. The point is treated as a set with one vertex.
[[nodiscard]] SpaceDistance distance(const Nef3& a, const RationalPoint3& p,
                                     Context& context = unlimited_context());
/// Returns the distance between two sets of the plane.
[[nodiscard]] PlaneDistance distance(const Nef2& a, const Nef2& b,
                                     Context& context = unlimited_context());
/// Returns the distance between a set of the plane and a point.
[[nodiscard]] PlaneDistance distance(const Nef2& a, const RationalPoint2& p,
                                     Context& context = unlimited_context());

/// A set with a prepared tree of boxes, for queries of many distances. Several threads may call
/// const members at the same time.
class DistanceIndex {
 public:
  /// Builds the tree of the set. Throws Error{BadArgument} if the set is empty or unbounded. Cost:
  /// O(n log n) for n cells.
  explicit DistanceIndex(const Nef3& set, Context& context = unlimited_context());
  DistanceIndex(const DistanceIndex&);             ///< Copies share the tree.
  DistanceIndex& operator=(const DistanceIndex&);  ///< Copies share the tree.
  ~DistanceIndex();                                ///< Releases the tree if no copy uses it.

  /// Returns the distance between this set and another set.
  [[nodiscard]] SpaceDistance to(const DistanceIndex& other,
                                 Context& context = unlimited_context()) const;
  /// Returns the distance between this set and a point. The query usually takes O(log n).
  [[nodiscard]] SpaceDistance to(const RationalPoint3& p,
                                 Context& context = unlimited_context()) const;

 private:
  struct [[gnu::visibility("hidden")]] State;
  std::shared_ptr<const State> state_;
};

}  // namespace plumb
#pragma GCC visibility pop
