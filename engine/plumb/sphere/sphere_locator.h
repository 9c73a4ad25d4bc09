// Point location and ray shooting for many queries of one set of the sphere. A ray is a walk along
// a great circle.
//
// Main flow of locate():
//  1. bounds    builds a tree of bounds of all points and arcs, in doubles (once)
//  2. on        tests exactly the points and arcs whose bounds contain the direction; if the
//               direction lies on one, that is the answer
//  3. walk      otherwise follows a great circle through the direction, in portions
//               (sphere_locator.cpp), and tests exactly the cells whose bounds a portion may
//               intersect. The face of the direction lies in front of the first cell met.
//  4. round     if that circle meets nothing, it lies in the face; then walks from a direction on
//               it along the circle of any arc
// shoot() walks along the given circle until a cell answers the query.
//
// Results equal those of the functions of NefSphere with the same names and are as exact: doubles
// only select the cells that are tested.
//
// Cost: O(n log n) time to build, about 330 bytes a cell, and a copy of the planes. A query
// descends the tree to the cells near its path, as far as the path goes, and tests them: O(log n)
// if small arcs are spread evenly over the sphere. A shot that passes many cells pays for each of
// them; a point on the path costs its degree; cells that doubles cannot distinguish are all tested.
// The worst case is O(n). Memory for the planes of queries is bounded: the table is copied afresh
// when its size has doubled, which is O(1) amortized a query.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "plumb/sphere/nef_sphere.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Point location and ray shooting in one set. Queries change internal state, so each thread needs
/// a locator of its own.
class SphereLocator {
 public:
  /// Builds a locator, which keeps a copy of the set (O(1)) and of its planes. O(n log n).
  explicit SphereLocator(const NefSphere& set);
  ~SphereLocator();  ///< Releases the index.
  /// Takes over the index. A moved-from locator may only be destroyed or assigned to.
  SphereLocator(SphereLocator&& other) noexcept;
  SphereLocator& operator=(SphereLocator&& other) noexcept;  ///< Takes over the index.

  const NefSphere& set() const;  ///< Returns the set that is queried.

  /// Returns the cell on which a direction lies, as NefSphere::locate() does. Throws
  /// Error{BadArgument} for the zero vector.
  SphereLocation locate(const SphereVector& direction);
  /// Whether the direction belongs to the set. Errors and cost as locate().
  bool contains(const SphereVector& direction) { return locate(direction).marked; }
  /// Whether the direction lies on the boundary of the set. Errors as locate(). Takes only step 2
  /// of locate(), so no walk along a circle.
  bool has_on_boundary(const SphereVector& direction);

  /// Returns the first marked cell on the great circle from `origin` through `towards`, once
  /// around, or nothing. The result is that of NefSphere::shoot(). Throws Error{BadArgument} if the
  /// directions are the same or opposite.
  std::optional<SphereHit> shoot(const SphereVector& origin, const SphereVector& towards);
  /// Returns the first point or arc on that circle, marked or not. The result is that of
  /// NefSphere::shoot_to_boundary(). Errors as shoot().
  std::optional<SphereHit> shoot_to_boundary(const SphereVector& origin,
                                             const SphereVector& towards);

  /// Returns the number of exact tests of points and arcs that all queries so far have made.
  std::uint64_t asked() const;

 private:
  struct [[gnu::visibility("hidden")]] State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb
#pragma GCC visibility pop
