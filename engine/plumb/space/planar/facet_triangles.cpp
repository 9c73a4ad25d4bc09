// Shapes of polygons, and triangles of facets.
//
// A polygon is convex, and so simple, if all its turns have one sign and it changes its
// lexicographic direction twice, so that it goes around once. Any other polygon is tested by a
// sweep that stops at the first place where segments meet other than in common ends.
//
// A facet may be a triangle already, or a polygon whose fan from one corner has left turns only.
// Any other facet is triangulated by the sweep of triangulate(), which also accepts holes, slits
// and inner vertices.
//
// Tested by tests/space/triangulate_test.cpp and tests/space/from_mesh_test.cpp.

#include "plumb/space/planar/facet_triangles.h"

#include <algorithm>
#include <utility>

#include "plumb/plane/sweep/sweep.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/input/rung_counters.h"
#include "plumb/space/planar/facet_site.h"

namespace plumb {
namespace {

/// Whether a polygon goes around once and never turns back: two changes of lexicographic direction,
/// and no two turns of different signs.
bool is_convex(const FlatPoints& points, std::span<const std::uint32_t> polygon) {
  const std::size_t n = polygon.size();
  Sign turn = Sign::Zero, direction = points.compare(polygon[n - 1], polygon[0]);
  int changes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t a = polygon[i], b = polygon[(i + 1) % n], c = polygon[(i + 2) % n];
    const Sign next = points.compare(a, b), s = points.orient(a, b, c);
    changes += next != direction ? 1 : 0;
    direction = next;
    if (s == Sign::Zero) continue;
    if (turn != Sign::Zero && s != turn) return false;
    turn = s;
  }
  return changes == 2 && turn != Sign::Zero;
}

/// Finds out whether segments meet at places other than common ends.
class TouchVisitor final : public SweepVisitor {
 public:
  bool on_event(const SweepEvent& event) override {
    is_crossing_ = event.points.size() != 1 || !event.has_ends_only();
    return !is_crossing_;
  }
  bool is_crossing() const { return is_crossing_; }

 private:
  bool is_crossing_ = false;
};

/// Whether edges meet at places other than common ends.
bool is_crossing(const FlatPoints& points, std::span<const IndexEdge> edges, Context& context) {
  std::vector<SweepSegment> segments;
  for (const IndexEdge& e : edges) segments.push_back({e[0], e[1]});
  TouchVisitor visitor;
  sweep(points.table(), segments, visitor, context);
  return visitor.is_crossing();
}

/// Whether a corner occurs twice.
bool has_repeats(std::span<const std::uint32_t> polygon) {
  std::vector<std::uint32_t> sorted(polygon.begin(), polygon.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

}  // namespace

void cancel_reverses(std::vector<IndexEdge>& edges) {
  const auto key = [](const IndexEdge& e) {
    return IndexEdge{std::min(e[0], e[1]), std::max(e[0], e[1])};
  };
  std::sort(edges.begin(), edges.end(), [&](const IndexEdge& a, const IndexEdge& b) {
    return std::pair(key(a), a) < std::pair(key(b), b);
  });
  // The entries of one undirected edge are consecutive: first one direction, and then the reverse.
  // Each reverse cancels one entry of the first direction.
  std::size_t kept = 0;
  for (const IndexEdge& e : edges) {
    if (kept > 0 && edges[kept - 1] == IndexEdge{e[1], e[0]}) {
      --kept;
    } else {
      edges[kept++] = e;
    }
  }
  edges.resize(kept);
}

std::vector<IndexEdge> boundary_of(std::span<const std::uint32_t> polygon) {
  std::vector<IndexEdge> edges;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    edges.push_back({polygon[i], polygon[(i + 1) % polygon.size()]});
  }
  cancel_reverses(edges);
  return edges;
}

PolygonShape shape_of(const FlatPoints& points, std::span<const std::uint32_t> polygon,
                      Context& context) {
  if (is_convex(points, polygon)) return PolygonShape::Simple;
  const bool is_repeating = has_repeats(polygon);
  if (is_crossing(points, boundary_of(polygon), context)) return PolygonShape::Crossing;
  return is_repeating ? PolygonShape::Touching : PolygonShape::Simple;
}

// The corner at the least point of a simple polygon is convex, so its turn is that of the polygon.
Sign orientation_of(const FlatPoints& points, std::span<const std::uint32_t> polygon) {
  const std::size_t n = polygon.size();
  std::size_t least = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (points.compare(polygon[i], polygon[least]) == Sign::Negative) least = i;
  }
  return points.orient(polygon[(least + n - 1) % n], polygon[least], polygon[(least + 1) % n]);
}

void FacetTriangles::cut(FacetId f) {
  show(f);
  triangles_.clear();
  if (is_single_cycle(f) && shown_.size() == edges_.size() && cut_as_fan(f)) return;
  triangles_.clear();
  PLUMB_CHECK(triangulate(flat_, edges_, triangles_));
}

/// Cuts the facet into a fan from its first corner. Returns false if a triangle of the fan does not
/// turn left. If all turn left, the simple polygon is star-shaped around that corner.
bool FacetTriangles::cut_as_fan(FacetId f) {
  UseId u = complex_.use_next[complex_.cycles_of(f)[0]];
  for (std::size_t i = 1; i + 1 < edges_.size(); ++i, u = complex_.use_next[u]) {
    const IndexTriangle t{edges_[0][0], edges_[i][0], edges_[i][1]};
    if (turn_at_edge(f, u, t) != Sign::Positive) return false;
    triangles_.push_back(t);
  }
  return true;
}

/// Returns the turn of a triangle whose second and third corner are the ends of a use. If it is
/// unclear and a corner is constructed, the side of a plane through the edge is computed, which
/// needs smaller numbers than three points.
Sign FacetTriangles::turn_at_edge(FacetId f, UseId u, const IndexTriangle& t) const {
  const auto point = [&](std::size_t i) { return complex_.vertex_point[shown_[t[i]]]; };
  const FilteredSign s = flat_.nearby_orient(t[0], t[1], t[2]);
  if (is_decided(s)) return decide(Predicate::Orient2d, Rung::Filter, s);
  if (point(0).is_input() && point(1).is_input() && point(2).is_input()) {
    return flat_.orient(t[0], t[1], t[2]);
  }
  return side_in_plane(complex_, complex_.facet_plane[f], complex_.use_halfedge[u],
                       complex_.points(), point(0));
}

/// Fills shown_, edges_ and flat_ with a facet.
void FacetTriangles::show(FacetId f) {
  shown_.clear();
  edges_.clear();
  const auto walk = [&](UseId first, const auto& visit) {
    UseId u = first;
    do {
      const UseId next = complex_.use_next[u];
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
  flat_.reset(FlatView::of_plane(complex_.planes(), complex_.facet_plane[f]));
  for (const VertexId v : shown_) {
    const SpacePoint p = complex_.vertex_point[v];
    if (nearest_.empty()) {
      flat_.push_back(p);
    } else {
      flat_.push_back(p, nearest_[v.value()]);
    }
  }
}

}  // namespace plumb
