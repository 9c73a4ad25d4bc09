// Point location and ray shooting for many queries of one set of the sphere. A ray is a walk along
// a great circle.
//
// Main flow of locate():
//  1. bounds    builds a tree of the bounds of all points and arcs, with doubles as coordinates.
//               The tree is built only once, by the constructor.
//  2. on        tests the points and arcs whose bounds contain the direction, by exact arithmetic.
//               If the direction lies on a point or arc, this point or arc is the result.
//  3. walk      otherwise walks from the direction along a great circle, one portion after another
//               (sphere_locator.cpp). Each point or arc whose bounds may intersect the portion is
//               tested exactly. The result is the face through which the walk reaches the first
//               point or arc.
//  4. round     if the great circle meets no point or arc, the whole circle lies in the face of the
//               direction. Then a second walk starts on this circle and follows the circle of any
//               arc.
// shoot() walks along the given circle until it finds a cell that answers the query.
//
// The results are exact and equal those of the functions of NefSphere with the same names. Doubles
// only select the points and arcs that are tested.
//
// Cost: building takes O(n log n) time, about 330 bytes for each cell, and a copy of the planes. A
// query descends the tree to the cells near its path, and tests these cells:
//   - If small arcs are spread evenly over the sphere, a query takes O(log n).
//   - A shot that passes many cells takes time for each of them.
//   - A point on the path takes time proportional to its degree.
//   - If doubles cannot distinguish several cells, all of these cells are tested.
//   - The worst case is O(n).
// A query adds planes to the locator's copy of the table. When the copy has doubled in size, the
// original table is copied again. This bounds the memory and takes O(1) amortized for each query.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "plumb/sphere/nef_sphere.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Point location and ray shooting in one set. Queries change internal state, so each thread needs
/// its own locator.
class SphereLocator {
 public:
  /// Builds a locator in O(n log n). The locator keeps a copy of the set, which takes O(1), and a
  /// copy of its planes.
  explicit SphereLocator(const NefSphere& set);
  ~SphereLocator();  ///< Releases the index.
  /// Takes over the index of `other`. A moved-from locator may only be destroyed or assigned to.
  SphereLocator(SphereLocator&& other) noexcept;
  SphereLocator& operator=(SphereLocator&& other) noexcept;  ///< Takes over the index of `other`.

  const NefSphere& set() const;  ///< Returns the set in which the locator searches.

  /// Returns the cell that contains a direction, as NefSphere::locate() does. Throws
  /// Error{BadArgument} for the zero vector.
  SphereLocation locate(const SphereVector& direction);
  /// Whether the direction belongs to the set. Errors and cost are those of locate().
  bool contains(const SphereVector& direction) { return locate(direction).marked; }
  /// Whether the direction lies on the boundary of the set. Throws as locate() does. This function
  /// takes only step 2 of locate(), without a walk along a circle.
  bool has_on_boundary(const SphereVector& direction);

  /// Returns the first marked cell on a walk from `origin` along the great circle through
  /// `towards`, once around, or nullopt if there is none. The result equals that of
  /// NefSphere::shoot(). Throws Error{BadArgument} if `origin` and `towards` are the same or
  /// opposite directions.
  std::optional<SphereHit> shoot(const SphereVector& origin, const SphereVector& towards);
  /// Returns the first point or arc on the walk of shoot(), whether marked or not, or nullopt if
  /// there is none. The result equals that of NefSphere::shoot_to_boundary(). Throws as shoot()
  /// does.
  std::optional<SphereHit> shoot_to_boundary(const SphereVector& origin,
                                             const SphereVector& towards);

  /// Returns the total number of exact tests of points and arcs in all queries so far.
  std::uint64_t asked() const;

 private:
  struct [[gnu::visibility("hidden")]] State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb
#pragma GCC visibility pop
