// Functions for polygons whose corners lie in a plane of space and are seen in a view (FlatView).
// The first part of this header tests whether a polygon is simple, and computes its orientation and
// the region that it bounds. The second part cuts the facets of a complex into triangles.
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

/// States whether and how a polygon meets itself.
enum class PolygonShape : std::uint8_t {
  Simple,  ///< The polygon does not meet itself.
  /// The polygon meets itself only in common corners, or along edges that it contains in both
  /// directions.
  Touching,
  Crossing,  ///< Two edges cross or overlap, or an edge passes through a corner.
};

/// Returns the shape of a polygon. The polygon is given by indices of points. Requires that all
/// points of `points` are different, and that no two consecutive corners of the polygon are the
/// same point. For n corners, O(n) if the polygon is convex, otherwise O(n log n). Throws the
/// errors of the Context.
PolygonShape shape_of(const FlatPoints& points, std::span<const std::uint32_t> polygon,
                      Context& context);

/// Returns the direction in which a polygon runs: Positive means counter-clockwise. Requires that
/// the polygon is Simple and does not lie on one line. O(n) for n corners.
Sign orientation_of(const FlatPoints& points, std::span<const std::uint32_t> polygon);

/// Sorts directed edges. If the list contains an edge and its reverse, both are removed. O(n log n)
/// for n edges.
void cancel_reverses(std::vector<IndexEdge>& edges);

/// Returns the directed edges of a polygon. If the polygon runs along an edge in both directions,
/// neither of the two directed edges is returned.
std::vector<IndexEdge> boundary_of(std::span<const std::uint32_t> polygon);

// Facets cut into triangles between vertices of the complex.

/// Cuts facets into triangles. An object reuses its working memory for every facet, so each thread
/// needs an object of its own.
class FacetTriangles {
 public:
  /// Keeps a reference to the complex, which must outlive the object.
  explicit FacetTriangles(const SpaceComplex& complex)
      : complex_(complex), flat_(complex.points()) {}
  /// Passes the doubles nearest to the coordinates of all vertices (rounded_point3.h). The filters
  /// of for_each() then use these doubles instead of the boxes of vertices, and so decide more
  /// predicates. `nearest` has one entry for each vertex of the complex.
  void use_nearest(std::span<const RoundedPoint3> nearest) { nearest_ = nearest; }

  /// Calls visit(a, b, c) with the vertices of each triangle, counter-clockwise seen from the
  /// positive side of the facet's plane. Vertices inside the facet become corners of triangles,
  /// too. So no vertex lies inside a triangle or inside an edge of a triangle. O(n log n) for n
  /// vertices of the facet.
  template <class Visit>
  void for_each(FacetId f, const Visit& visit) {
    const UseId a = complex_.cycles_of(f)[0];
    const UseId b = complex_.use_next[a], c = complex_.use_next[b];
    if (complex_.use_next[c] == a && is_single_cycle(f)) {
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
  bool cut_as_fan(FacetId f);
  Sign turn_at_edge(FacetId f, UseId u, const IndexTriangle& t) const;
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
