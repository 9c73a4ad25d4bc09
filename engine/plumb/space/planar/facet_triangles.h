// Polygons in a view (FlatView). The first part finds out whether they are simple, in which
// direction they run, and which region they bound. The second part cuts the facets of a complex
// into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/predicates/sign.h"
#include "plumb/space/planar/triangulate.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// How a polygon meets itself.
enum class PolygonShape : std::uint8_t {
  Simple,  ///< The polygon does not meet itself.
  /// It meets itself in common corners only, or along an edge that it runs forth and back.
  Touching,
  Crossing,  ///< Its edges cross or overlap, or pass through a corner.
};

/// Returns the shape of a polygon, given by indices of points. Requires that all points are
/// different and no corner is followed by the same corner. O(n) for a convex polygon, else
/// O(n log n). Throws what the context throws.
PolygonShape shape_of(const FlatPoints& points, std::span<const std::uint32_t> polygon,
                      Context& context);

/// Returns the direction in which a polygon runs: Positive is counter-clockwise. Requires that the
/// polygon is Simple and does not lie on one line. O(n).
Sign orientation_of(const FlatPoints& points, std::span<const std::uint32_t> polygon);

/// Removes pairs of an edge and its reverse, and sorts the remaining edges. O(n log n).
void cancel_reverses(std::vector<IndexEdge>& edges);

/// Returns the directed edges of a polygon, without edges that it runs forth and back.
std::vector<IndexEdge> boundary_of(std::span<const std::uint32_t> polygon);

// Facets cut into triangles between vertices of the complex.

/// Cuts facets into triangles. An object keeps its working memory from facet to facet, so each
/// thread needs its own object.
class FacetTriangles {
 public:
  /// Keeps a reference to the complex, which must outlive the object.
  explicit FacetTriangles(const SpaceComplex& complex)
      : complex_(complex), flat_(complex.points()) {}
  /// Makes for_each() use the nearest doubles of vertices (rounded_point3.h) in its filters. They
  /// decide more predicates than the boxes of vertices do. `nearest` has one entry for each vertex.
  void use_nearest(std::span<const RoundedPoint3> nearest) { nearest_ = nearest; }

  /// Calls visit(a, b, c) with the vertices of each triangle, counter-clockwise seen from the
  /// positive side of the facet's plane. Vertices inside the facet are corners, too. No vertex lies
  /// inside a triangle or inside one of its edges. O(n log n).
  template <class Visit>
  void for_each(FacetId f, const Visit& visit) {
    const UseId a = complex_.cycles_of(f)[0];
    const UseId b = complex_.use_next[a.value()], c = complex_.use_next[b.value()];
    if (complex_.use_next[c.value()] == a && is_single_cycle(f)) {
      visit(complex_.use_origin(a), complex_.use_origin(b), complex_.use_origin(c));
      return;
    }
    cut(f);
    for (const IndexTriangle& t : triangles_) visit(shown_[t[0]], shown_[t[1]], shown_[t[2]]);
  }

 private:
  bool is_single_cycle(FacetId f) const {
    return complex_.cycles_of(f).size() == 1 && complex_.inner_of(f).empty();
  }
  void cut(FacetId f);
  bool cut_as_fan();
  void show(FacetId f);

  const SpaceComplex& complex_;
  FlatPoints flat_;
  std::span<const RoundedPoint3> nearest_;
  std::vector<VertexId> shown_;  // The vertex of each point of flat_, ascending.
  std::vector<IndexEdge> edges_;
  std::vector<IndexTriangle> triangles_;
};

}  // namespace plumb
#pragma GCC visibility pop
