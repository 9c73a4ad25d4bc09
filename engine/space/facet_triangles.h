// Facets cut into triangles between vertices of the complex.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "plumb/space/flat_points.h"
#include "plumb/space/space_complex.h"
#include "plumb/space/triangulate.h"

namespace plumb {

/// Keeps its memory from facet to facet. One for each thread.
class FacetTriangles {
 public:
  explicit FacetTriangles(const SpaceComplex& complex)
      : complex_(complex), flat_(complex.points()) {}
  /// From now on looks at the nearest doubles of vertices (rounded_point3.h), per vertex of the facets to come.
  void use_nearest(std::span<const RoundedPoint3> nearest) { nearest_ = nearest; }

  /// Calls visit(a, b, c) with the vertices of each triangle, counter-clockwise seen from the positive
  /// side of the facet's plane. Vertices inside the facet are corners too; no triangle has a vertex in its
  /// inside or on an edge. O(n log n).
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
