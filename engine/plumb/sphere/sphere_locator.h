// Point location and ray shooting for many queries in one set of the sphere. Rays on the sphere are
// walks along great circles.
//
// Main flow of locate():
//  1. bounds    builds a tree of boxes that contain the points and arcs. The coordinates of the
//               boxes are doubles. The constructor takes this step once, for all queries.
//  2. on        tests each point or arc whose box contains the direction. The tests use exact
//               arithmetic. If the direction lies on a point or arc, this point or arc is the
//               result.
//  3. walk      is taken if the direction does not lie on a point or arc. It walks from the
//               direction along a great circle. The circle is searched one portion after another
//               (sphere_locator.cpp). Each point or arc whose box may intersect the portion is
//               tested exactly. The walk ends at the first point or arc. The result is the face
//               through which the walk ran before it met this point or arc.
//  4. round     is taken if the great circle meets no point and no arc. Then the whole circle lies
//               in the same face as the direction. A second walk starts on this circle and runs
//               along the great circle of an arc. So the second walk meets an arc.
// shoot() walks along the great circle of the query in the same way, until it finds a cell that
// answers the query.
//
// The results are exact. They are equal to the results of the functions of NefSphere that have the
// same names. Doubles are used only to select the points and arcs that are tested exactly.
//
// Cost: building a locator takes O(n log n) time for n cells. A locator needs about 330 bytes for
// each cell, and a copy of the planes. A query descends the tree to the cells near its walk, and
// tests these cells:
//   - If small arcs are spread evenly over the sphere, a query takes O(log n).
//   - A call of shoot() whose walk passes through many cells takes time for each of these cells.
//   - A point on the walk takes time proportional to its degree.
//   - If several cells are so close together that doubles cannot distinguish them, all of these
//     cells are tested.
//   - The worst case is O(n) for n cells.
// Each query adds planes to the locator's copy of the table of planes. When the copy has reached
// twice the size of the original table, it is replaced by a new copy of the original table. This
// bounds the memory, and takes O(1) amortized time for each query.
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
  /// Builds a locator in O(n log n) for n cells. The locator keeps a copy of the set and a copy of
  /// its planes. The copy of the set takes O(1), because it shares the map.
  explicit SphereLocator(const NefSphere& set);
  ~SphereLocator();  ///< Releases the index.
  /// Takes over the index of `other`. A moved-from locator may only be destroyed or assigned to.
  SphereLocator(SphereLocator&& other) noexcept;
  SphereLocator& operator=(SphereLocator&& other) noexcept;  ///< Takes over the index of `other`.

  const NefSphere& set() const;  ///< Returns the set in which the locator searches.

  /// Returns the cell that contains a direction, as NefSphere::locate() does. Throws
  /// Error{BadArgument} for the zero vector.
  SphereLocation locate(const SphereVector& direction);
  /// Whether the direction belongs to the set. Errors and cost are the same as for locate().
  bool contains(const SphereVector& direction) { return locate(direction).marked; }
  /// Whether the direction lies on the boundary of the set. Throws as locate() does. This function
  /// takes only step 2 of locate(), so it needs no walk along a great circle.
  bool has_on_boundary(const SphereVector& direction);

  /// Returns the first marked cell on the walk of NefSphere::shoot(), or nullopt if the walk meets
  /// no marked cell. This walk starts at `origin`, takes the shorter way to `towards`, and
  /// continues along the great circle until it returns to `origin`. Throws Error{BadArgument} if
  /// `origin` and `towards` are equal or opposite directions.
  std::optional<SphereHit> shoot(const SphereVector& origin, const SphereVector& towards);
  /// Returns the first point or arc of the map on the walk of shoot(), whether or not it is marked.
  /// Returns nullopt if the walk meets no point and no arc. The result is the same as the result of
  /// NefSphere::shoot_to_boundary(). Throws as shoot() does.
  std::optional<SphereHit> shoot_to_boundary(const SphereVector& origin,
                                             const SphereVector& towards);

  /// Returns the number of exact tests that all queries so far have made.
  std::uint64_t asked() const;

 private:
  struct [[gnu::visibility("hidden")]] State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb
#pragma GCC visibility pop
