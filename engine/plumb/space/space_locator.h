// Point location and ray shooting in a complex.
//
// Main flow:
//  1. build        makes a box tree over facets, free edges and isolated vertices, once
//  2. on_item      tests the items whose boxes contain the point. It compares the point with the
//                  plane first, and then, in a projection along an axis (space_ray.h), with
//                  vertices, edges and interior
//  3. shoot        finds the intersection of the ray with each candidate: by filters in doubles,
//                  and by exact arithmetic for ties and close calls. If the ray runs along an
//                  axis, find_near tests the candidates whose boxes meet a short part of the ray,
//                  then a longer part, as long as the candidates are few. Otherwise the boxes that
//                  the ray enters are visited nearest first
//  4. volume_of    shoots towards -x. The first item that the ray meets determines the volume in
//                  front of that item: a facet by its side, an edge or vertex by its sphere map
//  5. locate       for doubles, uses a grid (volume_grid.h, made at the first query). The grid
//                  knows the volume of every grid cell that is away from the boundary. Near the
//                  boundary, the locator searches only to the left, up to a point whose volume the
//                  grid knows
//
// Requires vertices, edges, uses, and facets with their cycles; volume_of and locate also require
// volumes. Marks serve only to recognize the frame. Several threads may call const members at the
// same time.
//
// Cost: O(n log n) to build; 76 bytes for each item of the tree, and 16 bytes more for the grid. A
// query visits O(log n) nodes and a few facets, provided that boxes of facets are small and few of
// them overlap.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "plumb/predicates/rational_point.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The first item that a ray meets, and the point where the ray meets it.
struct SpaceItemHit {
  SpaceItem item;        ///< The vertex, edge or facet.
  RationalPoint3 point;  ///< The exact point where the ray meets the item.
};

/// An index over a complex for point location and ray shooting.
class SpaceLocator {
 public:
  /// Builds the index. The complex must outlive the locator, and the parts of it that the head of
  /// this file requires must not change. O(n log n).
  explicit SpaceLocator(const SpaceComplex& complex);
  ~SpaceLocator();
  SpaceLocator(const SpaceLocator&) = delete;
  SpaceLocator& operator=(const SpaceLocator&) = delete;

  /// Returns the vertex, edge or facet on which the point lies, or an invalid item if it lies in a
  /// volume. Never returns an item of the frame.
  SpaceItem on_item(const RationalPoint3& p) const;
  SpaceItem on_item(const Point3& p) const;

  /// Returns the volume around a point. Requires volumes, and that the point lies on no vertex,
  /// edge or facet.
  VolumeId volume_of(const RationalPoint3& p) const;
  VolumeId volume_of(const Point3& p) const;

  /// Returns the vertex, edge, facet or volume on which the point lies: on_item(), or else
  /// volume_of(). Requires volumes.
  SpaceItem locate(const RationalPoint3& p) const;
  SpaceItem locate(const Point3& p) const;
  /// Sets items[i] to locate(points[i]). To use several threads, give each thread a part of the
  /// points. Requires that the sizes agree.
  void locate(std::span<const Point3> points, std::span<SpaceItem> items) const;

  /// Returns the first vertex, edge or facet that the ray meets strictly after `origin`, or
  /// nothing. If the ray starts in an item or runs along it, that item does not count. The ray then
  /// meets the vertex or edge at which it leaves the item. Items of the frame do not count.
  /// Requires that `direction` is not zero.
  std::optional<SpaceItemHit> shoot(const RationalPoint3& origin,
                                    const RationalPoint3& direction) const;
  std::optional<SpaceItemHit> shoot(const Point3& origin, const Point3& direction) const;
  /// Returns the first item that a ray towards -x meets strictly after a point of the complex's
  /// tables, or an invalid item. The result may be an item of the frame.
  SpaceItem shoot_left(SpacePoint origin) const;

 private:
  struct [[gnu::visibility("hidden")]] Tree;
  const SpaceComplex& complex_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace plumb
#pragma GCC visibility pop
