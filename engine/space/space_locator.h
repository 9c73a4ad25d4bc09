// Where points lie in a complex, and what rays meet first.
//
// Main flow:
//  1. a box tree over facets, free edges and vertices alone in a volume (once)
//  2. on_item      candidates whose box holds the point: on the plane, then in its shadow along an axis
//                  (space_ray.h) a vertex, an edge or the inside
//  3. shoot        each candidate says what the ray meets of it; filters in doubles, ties and close calls exact.
//                  find_near: along an axis, those whose box meets a short piece of the ray, then longer ones, as
//                  long as they are few; else those whose box the ray enters, nearer ones first
//  4. volume_of    what a ray towards -x meets first knows the volume in front of it: a facet by its side, an
//                  edge or vertex by its sphere map
//  5. locate       of doubles: a grid (volume_grid.h, made when first asked) knows the volume away from all items; near
//                  one, the way to the left up to a place that it knows is looked at
//
// Needs vertices, edges, uses, facets with their cycles; volume_of and locate need volumes too; nobody needs
// marks but to tell the frame. Const members may be called from many threads.
//
// Cost: O(n log n) to build, 76 bytes an item and 16 for the grid. A query looks at O(log n) nodes and a few facets where
// boxes of facets are small and few of them overlap.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "plumb/predicates/rational_point.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// What a ray meets first.
struct SpaceHit {
  SpaceItem item;        ///< vertex, edge or facet
  RationalPoint3 point;  ///< exactly where
};

/// Trees of boxes over a complex, for points and rays.
class SpaceLocator {
 public:
  /// The complex must outlive the locator and keep what is listed above.
  explicit SpaceLocator(const SpaceComplex& complex);
  ~SpaceLocator();
  SpaceLocator(const SpaceLocator&) = delete;
  SpaceLocator& operator=(const SpaceLocator&) = delete;

  /// The vertex, edge or facet the point lies on; invalid: it lies in a volume. Never an item of the
  /// frame.
  SpaceItem on_item(const RationalPoint3& p) const;
  SpaceItem on_item(const Point3& p) const;

  /// The volume around a point that lies on no item. Requires volumes.
  VolumeId volume_of(const RationalPoint3& p) const;
  VolumeId volume_of(const Point3& p) const;

  /// The vertex, edge, facet or volume that holds the point: on_item, then volume_of.
  SpaceItem locate(const RationalPoint3& p) const;
  SpaceItem locate(const Point3& p) const;
  /// items[i] = locate(points[i]); for many threads, give each a part. Requires one size.
  void locate(std::span<const Point3> points, std::span<SpaceItem> items) const;

  /// The first item met strictly after `origin` in `direction` (not zero), if any. An item that the ray
  /// starts in or runs along is met where it ends: at the next vertex or edge. What a ray meets of
  /// the frame is nothing.
  std::optional<SpaceHit> shoot(const RationalPoint3& origin,
                                const RationalPoint3& direction) const;
  std::optional<SpaceHit> shoot(const Point3& origin, const Point3& direction) const;
  /// Towards -x from a point of the complex's tables. The item alone, that may be of the frame.
  SpaceItem shoot_left(SpacePoint origin) const;

 private:
  struct [[gnu::visibility("hidden")]] Tree;
  const SpaceComplex& complex_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace plumb
#pragma GCC visibility pop
