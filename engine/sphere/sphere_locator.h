// Where directions lie in one set of the sphere, and what great circles meet of it, asked many times.
//
// Main flow of locate():
//  1. bounds    a tree of bounds of all points and arcs, in doubles (once)
//  2. on        a point or arc whose bound holds the direction: those are asked exactly
//  3. walk      else along a great circle through the direction, in pieces (sphere_walk.h); what their bounds may
//               meet is asked exactly. The nearest thing met has the direction's face in front of it.
//  4. round     when that circle meets nothing, it lies in the face: from it along the circle of any arc
// shoot() walks along the circle given, until something answers.
//
// Answers are those of NefSphere's functions of the same names, and as exact: doubles only choose what is asked.
//
// Cost: O(n log n) to build, about 330 bytes an item and a copy of the planes. A query asks the items near its way as far as
// it has to go, and walks down the tree to them: O(log n) where small arcs are spread evenly over the sphere. A shot that passes many
// items pays for each; a point met costs its degree; items that doubles cannot tell apart are all asked. Worst: O(n).
// Memory for planes of queries is bounded: the table is copied afresh when it has doubled, O(1) a query on average.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "plumb/sphere/nef_sphere.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Location and shooting in one set. A query changes what it keeps inside: give each thread a locator of its own.
class SphereLocator {
 public:
  explicit SphereLocator(
      const NefSphere& set);  ///< Keeps a copy of the set, O(1), and of its planes.
  ~SphereLocator();           ///< Ends it.
  SphereLocator(SphereLocator&& other) noexcept;  ///< `other` may only be destroyed then.
  SphereLocator& operator=(SphereLocator&& other) noexcept;  ///< As the constructor.

  const NefSphere& set() const;  ///< The set asked.

  /// As NefSphere::locate. Throws Error{BadArgument} for zero.
  SphereLocation locate(const SphereVector& direction);
  /// Does the direction belong to the set? As locate().
  bool contains(const SphereVector& direction) { return locate(direction).marked; }
  /// Is it on the boundary of the set? Costs no walk.
  bool has_on_boundary(const SphereVector& direction);

  /// As NefSphere::shoot. Throws Error{BadArgument} when the two are the same or opposite.
  std::optional<SphereHit> shoot(const SphereVector& origin, const SphereVector& towards);
  /// As NefSphere::shoot_to_boundary.
  std::optional<SphereHit> shoot_to_boundary(const SphereVector& origin,
                                             const SphereVector& towards);

  /// How many points and arcs all queries so far have asked exactly.
  std::uint64_t asked() const;

 private:
  struct [[gnu::visibility("hidden")]] State;
  std::unique_ptr<State> state_;
};

}  // namespace plumb
#pragma GCC visibility pop
