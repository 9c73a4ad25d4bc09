// Polygons in a view: are they simple, and if not, what do they cover?
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

enum class PolygonShape : std::uint8_t {
  Simple,
  Touching,  ///< meets itself in common corners only, or runs an edge there and back
  Crossing,
};

/// `polygon`: indices of points, all points different, no corner follows itself. O(n) when convex,
/// else O(n log n).
PolygonShape shape_of(const FlatPoints& points, std::span<const std::uint32_t> polygon,
                      Context& context);

/// Requires a Simple polygon that is not all on a line. Positive: counter-clockwise.
Sign orientation_of(const FlatPoints& points, std::span<const std::uint32_t> polygon);

/// Without those there whose reverse is there too: neither stays. Sorts the others.
void cancel_reverses(std::vector<IndexEdge>& edges);

/// The directed edges of a polygon without those that it runs there and back.
std::vector<IndexEdge> boundary_of(std::span<const std::uint32_t> polygon);

// Facets cut into triangles between vertices of the complex.

/// Keeps its memory from facet to facet. One for each thread.
class FacetTriangles {
 public:
  explicit FacetTriangles(const SpaceComplex& complex)
      : complex_(complex), flat_(complex.points()) {}
  /// From now on looks at the nearest doubles of vertices (rounded_point3.h), per vertex of the
  /// facets to come.
  void use_nearest(std::span<const RoundedPoint3> nearest) { nearest_ = nearest; }

  /// Calls visit(a, b, c) with the vertices of each triangle, counter-clockwise seen from the
  /// positive side of the facet's plane. Vertices inside the facet are corners too; no triangle has
  /// a vertex in its inside or on an edge. O(n log n).
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
  std::vector<VertexId> shown_;  // per point of flat_, ascending
  std::vector<IndexEdge> edges_;
  std::vector<IndexTriangle> triangles_;
};

}  // namespace plumb
#pragma GCC visibility pop
