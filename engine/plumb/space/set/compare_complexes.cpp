// Equality of sets by their vertices, equality of arrays, and the canonical order of cells.
//
// A set is determined by the sphere maps at its vertices and, if it has none, by the mark of space
// (docs/design/boolean.md, "Correctness"). So two sets are equal if their vertices are at the same
// points with the same maps. Fingerprints find the candidates, exact comparison decides
// (docs/design/planes-first.md, "Fingerprints"); maps are equal if the overlay of both by "unequal"
// is empty.
//
// The canonical order starts from the lexicographic order of points; everything else is numbered by
// vertices. Two edges have different pairs of vertices; two facets have different corners at their
// least vertices, for a corner names its facet. So the order is unique.
//
// Tested by tests/space/canonical_test.cpp, tests/space/nef3_test.cpp and
// tests/space/nef3_property_test.cpp.

#include "plumb/space/set/compare_complexes.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "plumb/predicates/point3_signs.h"
#include "plumb/space/local_maps.h"
#include "plumb/sphere/overlay/sphere_overlay.h"

namespace plumb {
namespace {

/// Returns the vertices sorted by the fingerprints of their points.
std::vector<std::pair<Fingerprint, VertexId>> by_fingerprint(
    const Point3Table& points, const std::vector<SpacePoint>& vertex_point) {
  std::vector<std::pair<Fingerprint, VertexId>> order;
  order.reserve(vertex_point.size());
  for (std::size_t v = 0; v < vertex_point.size(); ++v) {
    order.emplace_back(fingerprint(points, vertex_point[v]), VertexId(v));
  }
  std::sort(order.begin(), order.end());
  return order;
}

/// Replaces the planes of a map by those of another table.
void translate(const TableMap& to, SphereMap& map) {
  for (PlaneId& p : map.circle) p = to(p);
  for (SphereDirection& d : map.direction) d = {to(d.p), to(d.q)};
}

/// Compares two complexes with equally many cells of each kind.
class Comparison {
 public:
  Comparison(const SpaceComplex& a, const SpaceComplex& b)
      : a_(a),
        b_(b),
        tables_(copy(*a.tables)),
        to_(merge(*tables_, *b.tables)),
        overlay_(tables_->planes) {}

  /// Whether the sets are equal. Vertices with the same fingerprint are compared pairwise. Nearly
  /// always, there is one on each side.
  bool operator()() {
    std::vector<SpacePoint> points_of_b;
    for (const SpacePoint p : b_.vertex_point) points_of_b.push_back(to_(p));
    const auto first = by_fingerprint(tables_->points, a_.vertex_point);
    const auto second = by_fingerprint(tables_->points, points_of_b);
    // Fingerprints of equal points are equal. Therefore, if the sorted lists differ, the sets are
    // different.
    for (std::size_t i = 0; i < first.size(); ++i) {
      if (!(first[i].first == second[i].first)) return false;
    }
    for (std::size_t i = 0; i < first.size();) {
      std::size_t end = i + 1;
      while (end < first.size() && first[end].first == first[i].first) ++end;
      for (std::size_t k = i; k < end; ++k) {
        const VertexId v = first[k].second;
        const bool has_match =
            std::any_of(second.begin() + static_cast<std::ptrdiff_t>(i),
                        second.begin() + static_cast<std::ptrdiff_t>(end), [&](const auto& entry) {
                          return equal(tables_->points, a_.vertex_point[v],
                                       points_of_b[entry.second.value()]) &&
                                 have_same_map(v, entry.second);
                        });
        if (!has_match) return false;
      }
      i = end;
    }
    return true;
  }

 private:
  /// Whether two vertices have the same map: no point of the sphere has different marks in both.
  bool have_same_map(VertexId v, VertexId w) {
    local_map(a_, v, local_[0]);
    local_map(b_, w, local_[1]);
    const SphereMap &m = local_[0].map, &n = local_[1].map;
    if (m.centre_mark != n.centre_mark || m.point_count() != n.point_count() ||
        m.arc_count() != n.arc_count() || m.face_count() != n.face_count()) {
      return false;
    }
    // The overlay marks the places where exactly one map has a mark. It must be one unmarked face.
    translate(to_, local_[1].map);
    overlay_.boolean_op(m, n, MarkTable::unequal(), difference_, origins_);
    return difference_.point_count() == 0 && difference_.arc_count() == 0 &&
           difference_.face_mark[0] == 0;
  }

  const SpaceComplex& a_;
  const SpaceComplex& b_;
  std::shared_ptr<SpaceTables> tables_;
  TableMap to_;
  SphereOverlay overlay_;
  std::array<LocalMap, 2> local_;
  SphereMap difference_;
  SphereOrigins origins_;
};

}  // namespace

bool is_same(const SpaceComplex& a, const SpaceComplex& b) {
  if (a.vertex_count() != b.vertex_count() || a.edge_count() != b.edge_count() ||
      a.facet_count() != b.facet_count() || a.volume_count() != b.volume_count() ||
      a.volume_mark[0] != b.volume_mark[0]) {
    return false;
  }
  return a.vertex_count() == 0 || Comparison(a, b)();
}

namespace {

/// Whether the tables define the same planes in the same way.
bool has_same_planes(const PlaneTable& a, const PlaneTable& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const PlaneId p(i);
    if (a.source(p).is_explicit() != b.source(p).is_explicit()) return false;
    if (!a.source(p).is_explicit() && a.source(p).code != b.source(p).code) return false;
    if (!a.source(p).is_explicit()) continue;
    if (a.is_frame(p) != b.is_frame(p) || a.coefficients(p) != b.coefficients(p)) return false;
  }
  return true;
}

/// Whether two constructed points are defined in the same way.
bool is_same_source(const PointSource& a, const PointSource& b) {
  if (a.is_line() != b.is_line()) return false;
  for (std::size_t i = 0; a.is_line() && i < 2; ++i) {
    if (a.end(i) != b.end(i)) return false;
  }
  for (std::size_t i = 0; i < a.plane_count(); ++i) {
    if (a.plane(i) != b.plane(i)) return false;
  }
  return true;
}

/// Whether the tables define the same points in the same way.
bool has_same_points(const SpaceTables& a, const SpaceTables& b) {
  if (a.points.size() != b.points.size()) return false;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const SpacePoint p = SpacePoint::constructed(i);
    if (!is_same_source(a.points.source(p), b.points.source(p))) return false;
  }
  const auto is_equal_point = [](const Point3& p, const Point3& q) {
    return is_equal(p.x, q.x) && is_equal(p.y, q.y) && is_equal(p.z, q.z);
  };
  return std::ranges::equal(a.planes.points(), b.planes.points(), is_equal_point);
}

bool has_same_tables(const SpaceTables& a, const SpaceTables& b) {
  return &a == &b || (has_same_points(a, b) && has_same_planes(a.planes, b.planes));
}

}  // namespace

bool is_identical(const SpaceComplex& a, const SpaceComplex& b) {
  if (&a == &b) return true;
  // If sets were made by the same operations from different points, their tables differ. Therefore
  // tables are compared first.
  return has_same_tables(*a.tables, *b.tables) && a.vertex_point == b.vertex_point &&
         a.vertex_mark == b.vertex_mark && a.vertex_volume == b.vertex_volume &&
         a.vertex_facet == b.vertex_facet && a.star_begin == b.star_begin && a.star == b.star &&
         a.edge_planes == b.edge_planes && a.edge_mark == b.edge_mark && a.edge_use == b.edge_use &&
         a.edge_volume == b.edge_volume && a.origin == b.origin &&
         a.use_halfedge == b.use_halfedge && a.use_next == b.use_next && a.use_prev == b.use_prev &&
         a.use_radial == b.use_radial && a.use_facet == b.use_facet &&
         a.facet_plane == b.facet_plane && a.facet_mark == b.facet_mark &&
         a.facet_volume == b.facet_volume && a.facet_origin == b.facet_origin &&
         a.cycle_begin == b.cycle_begin && a.cycle == b.cycle && a.inner_begin == b.inner_begin &&
         a.inner == b.inner && a.volume_mark == b.volume_mark;
}

namespace {

/// Computes the canonical order.
class Ordering {
 public:
  Ordering(const SpaceComplex& complex, Context& context) : c_(complex), context_(context) {}

  CanonicalOrder run() && {
    order_vertices();
    order_edges();
    order_facets();
    order_uses();
    order_volumes();
    return std::move(order_);
  }

 private:
  void order_vertices();
  void order_edges();
  void order_facets();
  void order_uses();
  void order_volumes();

  /// The corner of a facet's boundary at a vertex. No other facet has the same corner at its own
  /// least vertex: the corner is neither straight nor a full turn, because all of the facet comes
  /// after the vertex, so it lies in one plane and on one side in it.
  struct Corner {
    VertexId vertex;
    VertexId to;
    VertexId from;
    friend auto operator<=>(const Corner&, const Corner&) = default;
  };
  Corner corner(UseId u) const {
    const UseId before = c_.use_prev[u];
    return {order_.vertices(c_.use_origin(u)), order_.vertices(c_.target(c_.use_halfedge[u])),
            order_.vertices(c_.use_origin(before))};
  }
  Corner least_corner(FacetId f) const {
    const UseId first = c_.cycles_of(f).front();
    Corner least = corner(first);
    for (UseId u = c_.use_next[first]; u != first; u = c_.use_next[u]) {
      least = std::min(least, corner(u));
    }
    return least;
  }
  /// Returns the use of the cycle with the least half-edge.
  std::pair<HalfedgeId, UseId> start_of_cycle(UseId first) const {
    std::pair least{order_.halfedge(c_, c_.use_halfedge[first]), first};
    for (UseId u = c_.use_next[first]; u != first; u = c_.use_next[u]) {
      least = std::min(least, {order_.halfedge(c_, c_.use_halfedge[u]), u});
    }
    return least;
  }
  void append(VolumeId v) {
    if (v.is_valid() && !order_.volumes.has(v)) order_.volumes.append(v);
  }

  const SpaceComplex& c_;
  Context& context_;
  CanonicalOrder order_;
};

// Only this order needs signs, because all others follow from the numbers of vertices.
void Ordering::order_vertices() {
  const std::size_t n = c_.vertex_count();
  std::vector<std::uint32_t> vertices(n);
  std::iota(vertices.begin(), vertices.end(), 0U);
  std::uint64_t compared = 0;
  std::sort(vertices.begin(), vertices.end(), [&](std::uint32_t v, std::uint32_t w) {
    if (++compared % 4096 == 0) context_.checkpoint("order of vertices", 0, 0);
    return compare_xyz(c_.points(), c_.vertex_point[v], c_.vertex_point[w]) == Sign::Negative;
  });
  order_.vertices = NewOrder<VertexId>(n);
  for (const std::uint32_t v : vertices) order_.vertices.append(VertexId(v));
}

// Two edges never have the same two vertices, so the order is strict.
void Ordering::order_edges() {
  context_.checkpoint("order of edges", 1, 5);
  using Ends = std::array<VertexId, 2>;
  std::vector<std::pair<Ends, EdgeId>> edges;
  edges.reserve(c_.edge_count());
  for (std::size_t e = 0; e < c_.edge_count(); ++e) {
    const VertexId v = order_.vertices(c_.origin[2 * e]), w = order_.vertices(c_.origin[2 * e + 1]);
    edges.emplace_back(Ends{std::min(v, w), std::max(v, w)}, EdgeId(e));
  }
  std::sort(edges.begin(), edges.end());
  order_.edges = NewOrder<EdgeId>(edges.size());
  for (const auto& [ends, e] : edges) order_.edges.append(e);
}

// Two facets never have the same least corner, so the order is strict.
void Ordering::order_facets() {
  context_.checkpoint("order of facets", 2, 5);
  std::vector<std::pair<Corner, FacetId>> facets;
  facets.reserve(c_.facet_count());
  for (std::size_t f = 0; f < c_.facet_count(); ++f) {
    facets.emplace_back(least_corner(FacetId(f)), FacetId(f));
  }
  std::sort(facets.begin(), facets.end());
  order_.facets = NewOrder<FacetId>(facets.size());
  for (const auto& [corner, f] : facets) order_.facets.append(f);
}

void Ordering::order_uses() {
  context_.checkpoint("order of uses", 3, 5);
  order_.uses = NewOrder<UseId>(c_.use_count());
  order_.cycles.reserve(c_.cycle.size());
  std::vector<std::pair<HalfedgeId, UseId>> starts;
  for (const FacetId f : order_.facets.ids()) {
    starts.clear();
    for (const UseId first : c_.cycles_of(f)) starts.push_back(start_of_cycle(first));
    std::sort(starts.begin() + 1, starts.end());  // The outer cycle remains the first.
    for (const auto& [h, start] : starts) {
      order_.cycles.push_back(start);
      UseId u = start;
      do {
        order_.uses.append(u);
        u = c_.use_next[u];
      } while (u != start);
    }
  }
}

// Every volume except volume 0 has a facet, a free edge or an isolated vertex beside it, so all
// volumes get numbers.
void Ordering::order_volumes() {
  context_.checkpoint("order of volumes", 4, 5);
  order_.volumes = NewOrder<VolumeId>(c_.volume_count());
  append(VolumeId(0));
  for (const FacetId f : order_.facets.ids()) {
    for (const VolumeId v : c_.facet_volume[f]) append(v);
  }
  for (const EdgeId e : order_.edges.ids()) append(c_.edge_volume[e]);
  for (const VertexId v : order_.vertices.ids()) append(c_.vertex_volume[v]);
}

}  // namespace

CanonicalOrder canonical_order(const SpaceComplex& complex, Context& context) {
  return Ordering(complex, context).run();
}

}  // namespace plumb
