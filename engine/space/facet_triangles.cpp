#include "plumb/space/facet_triangles.h"

#include <algorithm>

#include "plumb/base/error.h"
#include "plumb/space/flat_polygon.h"

namespace plumb {

void FacetTriangles::cut(FacetId f) {
  show(f);
  triangles_.clear();
  if (is_single_cycle(f) && shown_.size() == edges_.size() && cut_as_fan()) return;
  triangles_.clear();
  cancel_reverses(edges_);  // an edge with the facet on both sides
  PLUMB_CHECK(triangulate(flat_, edges_, triangles_));
}

/// A simple polygon is star-shaped around its first corner if all triangles there turn left.
bool FacetTriangles::cut_as_fan() {
  for (std::size_t i = 1; i + 1 < edges_.size(); ++i) {
    const IndexTriangle t{edges_[0][0], edges_[i][0], edges_[i][1]};
    if (flat_.orient(t[0], t[1], t[2]) != Sign::Positive) return false;
    triangles_.push_back(t);
  }
  return true;
}

void FacetTriangles::show(FacetId f) {
  shown_.clear();
  edges_.clear();
  const auto walk = [&](UseId first, const auto& visit) {
    UseId u = first;
    do {
      const UseId next = complex_.use_next[u.value()];
      visit(complex_.use_origin(u), complex_.use_origin(next));
      u = next;
    } while (u != first);
  };
  const auto inner = complex_.inner_of(f);
  shown_.assign(inner.begin(), inner.end());
  for (const UseId first : complex_.cycles_of(f)) {
    walk(first, [&](VertexId v, VertexId) { shown_.push_back(v); });
  }
  std::sort(shown_.begin(), shown_.end());
  shown_.erase(std::unique(shown_.begin(), shown_.end()), shown_.end());
  const auto index = [&](VertexId v) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(shown_, v) - shown_.begin());
  };
  for (const UseId first : complex_.cycles_of(f)) {
    walk(first, [&](VertexId v, VertexId w) { edges_.push_back({index(v), index(w)}); });
  }
  flat_.reset(FlatView::of_plane(complex_.planes(), complex_.facet_plane[f.value()]));
  for (const VertexId v : shown_) {
    const SpacePoint p = complex_.vertex_point[v.value()];
    if (nearest_.empty()) {
      flat_.push_back(p);
    } else {
      flat_.push_back(p, nearest_[v.value()]);
    }
  }
}

}  // namespace plumb
