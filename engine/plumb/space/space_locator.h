// Point location and ray shooting in a complex.
//
// Main flow:
//  1. build        makes a tree of the bounding boxes of items. The items are the facets, the free
//                  edges and the isolated vertices. The constructor takes this step
//  2. on_item      tests the items whose boxes contain the point. For a facet, the point is first
//                  compared with the plane of the facet. If the point lies on this plane, it is
//                  compared with the vertices, edges and interior of the facet, in a projection
//                  along an axis (space_ray.h)
//  3. shoot        finds the intersection of the ray with each candidate. Intersections are
//                  computed in doubles first, and exactly if doubles do not decide. If the ray is
//                  parallel to an axis, find_near() first tests the candidates whose boxes meet a
//                  short part of the ray. If it finds no intersection, it continues with longer
//                  parts of the ray, as long as there are few candidates. In all other cases, the
//                  boxes that the ray enters are visited in order of distance, the nearest first
//  4. volume_of    shoots a ray towards -x. The result is the volume just in front of the first
//                  item that the ray meets. If this item is a facet, the result is the volume on
//                  the side of the facet that the ray meets. If the item is an edge or vertex, the
//                  sphere map of the edge or vertex gives the volume
//  5. locate       uses a grid (volume_grid.h) if the point has double coordinates. The grid is
//                  made at the first query. For every grid cell that no box of an item meets, the
//                  grid stores the volume that contains the grid cell. If the box of an item meets
//                  the grid cell of the point, no volume is stored for this grid cell. Then the
//                  locator looks for a grid cell with a stored volume among the next grid cells in
//                  the direction of -x. It tests only the items on the way to this grid cell. If no
//                  item lies on the way, the stored volume is the result. If there is no such grid
//                  cell nearby, steps 2 and 4 give the result
//
// All functions require vertices, edges, uses, and facets with their cycles. The functions
// volume_of and locate require volumes, too. Marks are used only to recognize the frame. Several
// threads may call const members at the same time.
//
// Cost: building takes O(n log n) time for n items. For each item, the tree needs 76 bytes and the
// grid needs 16 bytes. If the boxes of facets are small and few of the boxes overlap, a query
// visits O(log n) nodes and a few facets.
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
  /// Builds the index. The complex must outlive the locator. The arrays of the complex that the
  /// head of this file names must not change. Cost: O(n log n) for n items.
  explicit SpaceLocator(const SpaceComplex& complex);
  ~SpaceLocator();
  SpaceLocator(const SpaceLocator&) = delete;
  SpaceLocator& operator=(const SpaceLocator&) = delete;

  /// Returns the vertex, edge or facet on which the point lies, or an invalid item if the point
  /// lies in a volume. Never returns an item of the frame.
  SpaceItem on_item(const RationalPoint3& p) const;
  SpaceItem on_item(const Point3& p) const;

  /// Returns the volume around a point. Requires that the complex has volumes, and that the point
  /// lies on no vertex, edge or facet.
  VolumeId volume_of(const RationalPoint3& p) const;
  VolumeId volume_of(const Point3& p) const;

  /// Returns the cell that contains the point. If the result of on_item() is valid, locate()
  /// returns it. Otherwise locate() returns the result of volume_of(). Requires that the complex
  /// has volumes.
  SpaceItem locate(const RationalPoint3& p) const;
  SpaceItem locate(const Point3& p) const;
  /// Sets items[i] to locate(points[i]). To use several threads, give each thread a part of the
  /// points. Requires that the two spans have the same size.
  void locate(std::span<const Point3> points, std::span<SpaceItem> items) const;

  /// Returns the first vertex, edge or facet that the ray meets strictly after `origin`, or nullopt
  /// if there is none. The function skips items in which the ray starts or along which it runs. It
  /// does not skip the vertex or edge at which the ray leaves such an item. It also skips items of
  /// the frame. Requires that `direction` is not zero.
  std::optional<SpaceItemHit> shoot(const RationalPoint3& origin,
                                    const RationalPoint3& direction) const;
  std::optional<SpaceItemHit> shoot(const Point3& origin, const Point3& direction) const;
  /// Shoots a ray towards -x from an input point or a constructed point of the complex. Returns the
  /// first item that the ray meets strictly after this point, or an invalid item if there is none.
  /// The result may be an item of the frame.
  SpaceItem shoot_left(SpacePoint origin) const;

 private:
  struct [[gnu::visibility("hidden")]] Tree;
  const SpaceComplex& complex_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace plumb
#pragma GCC visibility pop
