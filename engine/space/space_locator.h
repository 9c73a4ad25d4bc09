// Where points lie in a complex, and what rays meet first.
//
// Main flow:
//  1. a box tree over facets, free edges and vertices inside facets or volumes (once)
//  2. on_item      candidates whose box holds the point: vertex, edge, then facet; exact
//  3. shoot        nearest candidate along the ray; filters in doubles, ties and close calls exact
//
// Needs vertices, edges, uses, facets with their cycles; neither volumes nor marks. Const members may be
// called from many threads.
#pragma once

#include <memory>
#include <optional>

#include "plumb/predicates/rational_point.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// What a ray meets first.
struct SpaceHit {
  SpaceItem item;  ///< vertex, edge or facet
  RationalPoint3 point;
};

class SpaceLocator {
 public:
  /// The complex must outlive the locator and keep what is listed above.
  explicit SpaceLocator(const SpaceComplex& complex);
  ~SpaceLocator();
  SpaceLocator(const SpaceLocator&) = delete;
  SpaceLocator& operator=(const SpaceLocator&) = delete;

  /// The vertex, edge or facet the point lies on; invalid: it lies in a volume.
  SpaceItem on_item(const RationalPoint3& p) const;
  SpaceItem on_item(const Point3& p) const;

  /// The first item met strictly after `origin` in `direction` (not zero), if any. An item that the ray
  /// starts in or runs along is met where it ends: at the next vertex or edge.
  std::optional<SpaceHit> shoot(const RationalPoint3& origin,
                                const RationalPoint3& direction) const;
  std::optional<SpaceHit> shoot(const Point3& origin, const Point3& direction) const;
  /// Towards -x from a point of the complex's tables. The item alone.
  SpaceItem shoot_left(SpacePoint origin) const;

 private:
  struct Tree;
  const SpaceComplex& complex_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace plumb
