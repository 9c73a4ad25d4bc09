// Links the facets of a mesh: edges by sorting, radial orders by signs of planes.
//
// Uses are put into buckets by the lesser vertex of their edge, and sorted by the greater vertex.
// So no hash table of pairs is needed, and edges are in a canonical order. Doubled facets have
// equal cycles, because each cycle starts at its least vertex; only facets that start along the
// same edge are compared.
//
// If the facets of an edge have two planes, the edge has these. Otherwise, a second plane is made
// through both ends of the edge and a point straight above one of them. It is parallel to the
// coordinate axis with the largest component of the first normal. Its coefficients are no longer
// than those of an input plane (docs/design/planes-first.md, "Invariants"). Half-edge 2e then runs
// along n_p x n_q.
//
// Around an edge with more than two uses the radial order is sorted by quarters and signs of turns
// about the line; with two uses there is nothing to sort.
//
// Tested by tests/space/from_mesh_test.cpp.

#include "plumb/space/mesh/link_facets.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <functional>
#include <numeric>
#include <utility>

#include "plumb/base/internal/insertion_sort.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/triangulate.h"

namespace plumb {
namespace {

/// Fills `next` and `facet`.
void link_cycles(const MeshFacets& facets, MeshLinks& links) {
  links.next.resize(facets.corner.size());
  links.facet.resize(facets.corner.size());
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    for (std::uint32_t u = facets.begin[f]; u < facets.begin[f + 1]; ++u) {
      links.next[u] = u + 1;
      links.facet[u] = f;
    }
    links.next[facets.begin[f + 1] - 1] = facets.begin[f];
  }
}

/// The uses in buckets by their lesser vertex. Each entry is (greater vertex, use) as one word.
struct Buckets {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint64_t> entry;
};

/// Counts the uses, and then places them. The entry begin[v + 1] is the place of the next entry of
/// v.
Buckets bucket_uses(const MeshFacets& facets, const MeshLinks& links, std::size_t vertex_count) {
  Buckets b;
  b.begin.assign(vertex_count + 2, 0);
  const auto lesser = [&](std::uint32_t u) {
    return std::min(facets.corner[u], facets.corner[links.next[u]]);
  };
  const auto count = static_cast<std::uint32_t>(facets.corner.size());
  for (std::uint32_t u = 0; u < count; ++u) ++b.begin[lesser(u) + 2];
  for (std::size_t v = 2; v < b.begin.size(); ++v) b.begin[v] += b.begin[v - 1];
  b.entry.resize(count);
  for (std::uint32_t u = 0; u < count; ++u) {
    const std::uint32_t from = facets.corner[u], to = facets.corner[links.next[u]];
    b.entry[b.begin[std::min(from, to) + 1]++] = std::uint64_t{std::max(from, to)} << 32U | u;
  }
  return b;
}

/// Sorts the entries of a vertex, which are few at nearly all vertices.
void sort_entries(std::span<std::uint64_t> entries) {
  constexpr std::size_t kFew = 24;
  if (entries.size() <= kFew) return insertion_sort(entries, std::less<>());
  std::sort(entries.begin(), entries.end());
}

}  // namespace

MeshLinks link_corners(const MeshFacets& facets, std::size_t vertex_count) {
  MeshLinks links;
  link_cycles(facets, links);
  Buckets buckets = bucket_uses(facets, links, vertex_count);
  links.end.reserve(facets.corner.size() / 2 + 1);
  links.begin.reserve(facets.corner.size() / 2 + 2);
  links.use.resize(facets.corner.size());
  std::uint32_t place = 0;  // The place of the next use.
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const auto first = buckets.entry.begin() + buckets.begin[v];
    const auto last = buckets.entry.begin() + buckets.begin[v + 1];
    sort_entries({first, last});
    std::uint32_t known = ~std::uint32_t{0};  // The other end of the last edge of v.
    for (auto i = first; i != last; ++i) {
      const auto other = static_cast<std::uint32_t>(*i >> 32U);
      if (other != known) {
        links.begin.push_back(place);
        links.end.push_back({v, other});
        known = other;
      }
      links.use[place++] = static_cast<std::uint32_t>(*i);
    }
  }
  links.begin.push_back(place);
  return links;
}

bool is_plainly_closed(const MeshFacets& facets, const MeshLinks& links) {
  if (!facets.loose.empty()) return false;
  for (std::size_t e = 0; e < links.edge_count(); ++e) {
    if (links.begin[e + 1] - links.begin[e] != 2) return false;
    const std::uint32_t u = links.use[links.begin[e]], v = links.use[links.begin[e] + 1];
    const std::uint32_t f = links.facet[u], g = links.facet[v];
    // Uses of the same direction need opposite jumps, and uses of opposite directions need equal
    // jumps. A use leaves the lesser end of its edge if it is forward.
    const bool is_one_way = facets.corner[u] == facets.corner[v];
    if (facets.jump[f] != (is_one_way ? -facets.jump[g] : facets.jump[g])) return false;
    // Facets that occur twice are in one plane and begin with the same use.
    if (is_one_way && facets.plane[f] == facets.plane[g] && facets.begin[f] == u) return false;
  }
  return true;
}

// ---------------------------------------------------------------- doubled facets

namespace {

/// Finds facets with equal boundaries.
class Doubles {
 public:
  Doubles(const MeshFacets& facets, const MeshLinks& links) : facets_(facets), links_(links) {}

  /// Returns for each facet the first facet with the same boundary, which may be the facet itself.
  /// Returns an empty list if no two facets have the same boundary. Cost: O(n log n) for n corners,
  /// even if many facets share an edge.
  std::vector<std::uint32_t> find() {
    std::vector<std::uint32_t> beginning;  // The facets whose cycles begin with an edge.
    for (std::size_t e = 0; e < links_.edge_count(); ++e) {
      beginning.clear();
      for (const std::uint32_t use : links_.uses_of(e)) {
        if (is_first(use)) beginning.push_back(links_.facet[use]);
      }
      if (beginning.size() > 1) join_equal(beginning);
    }
    return std::move(same_);
  }

 private:
  /// Whether the use begins its cycle. Each cycle starts at its least vertex, so equal ones start
  /// with equal uses.
  bool is_first(std::uint32_t use) const { return facets_.begin[links_.facet[use]] == use; }

  /// Sorts facets such that equal facets are consecutive, in the order of their numbers.
  void join_equal(std::vector<std::uint32_t>& facets) {
    std::sort(facets.begin(), facets.end(), [this](std::uint32_t f, std::uint32_t g) {
      const auto order = compare(f, g);
      return order != 0 ? order < 0 : f < g;
    });
    std::uint32_t first = facets[0];
    for (std::size_t i = 1; i < facets.size(); ++i) {
      if (compare(first, facets[i]) == 0) {
        set_same(facets[i], first);
      } else {
        first = facets[i];
      }
    }
  }
  std::strong_ordering compare(std::uint32_t f, std::uint32_t g) const {
    if (const auto order = facets_.plane[f] <=> facets_.plane[g]; order != 0) return order;
    const auto a = facets_.corners(f), b = facets_.corners(g);
    return std::lexicographical_compare_three_way(a.begin(), a.end(), b.begin(), b.end());
  }
  void set_same(std::uint32_t facet, std::uint32_t first) {
    if (same_.empty()) {
      same_.resize(facets_.size());
      std::iota(same_.begin(), same_.end(), 0U);
    }
    same_[facet] = first;
  }

  const MeshFacets& facets_;
  const MeshLinks& links_;
  std::vector<std::uint32_t> same_;
};

/// Returns the facets that are their own `same`, with the jumps of the other facets added.
MeshFacets merged(const MeshFacets& facets, std::span<const std::uint32_t> same) {
  MeshFacets kept;
  kept.loose = facets.loose;
  std::vector<std::uint32_t> place(facets.size());
  for (std::uint32_t f = 0; f < facets.size(); ++f) {
    place[f] = same[f] == f ? static_cast<std::uint32_t>(kept.size()) : place[same[f]];
    if (same[f] != f) {
      kept.jump[place[f]] += facets.jump[f];
      continue;
    }
    const auto corners = facets.corners(f);
    kept.corner.insert(kept.corner.end(), corners.begin(), corners.end());
    kept.begin.push_back(static_cast<std::uint32_t>(kept.corner.size()));
    kept.plane.push_back(facets.plane[f]);
    kept.jump.push_back(facets.jump[f]);
    kept.origin.push_back(facets.origin[f]);
  }
  return kept;
}

}  // namespace

std::vector<MeshReport::FacePair> merge_doubled(MeshFacets& facets, MeshLinks& links,
                                                std::size_t vertex_count) {
  std::vector<MeshReport::FacePair> doubled;
  const std::vector<std::uint32_t> same = Doubles(facets, links).find();
  for (std::uint32_t f = 0; f < same.size(); ++f) {
    if (same[f] != f) doubled.emplace_back(facets.origin[f], facets.origin[same[f]]);
  }
  if (!doubled.empty()) {
    facets = merged(facets, same);
    links = link_corners(facets, vertex_count);
  }
  return doubled;
}

namespace {

/// Returns a point straight above or below p, seen along an axis. The other coordinates do not
/// change, so the plane through p, another point and this one is exactly parallel to the axis. The
/// coordinate becomes 0 or 1, which keeps numbers short.
Point3 moved_along(Point3 p, std::size_t axis) {
  double& c = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
  c = c == 0 ? 1 : 0;
  return p;
}

/// The second planes and directions of edges of which the first plane and both ends are known.
class EdgePlanes {
 public:
  EdgePlanes(SpaceComplex& complex, SpaceTables& tables) : c_(complex), tables_(tables) {}

  /// Gives each edge a second plane: through the edge, parallel to the axis along which the first
  /// one is seen. It differs from the first one, which is not parallel to that axis.
  void add_second(std::span<const std::uint32_t> edges) {
    std::vector<std::array<InputPointId, 3>> triples;
    std::vector<std::uint32_t> of_inputs;
    for (const std::uint32_t e : edges) {
      // The first plane is certainly not parallel to the axis of its largest normal component.
      const std::size_t axis = FlatView::of_plane(tables_.planes, c_.edge_planes[e][0]).axis;
      const SpacePoint a = end(2 * e), b = end(2 * e + 1);
      if (a.is_input() && b.is_input()) {
        triples.push_back({a.input(), b.input(), above(a.input(), axis)});
        of_inputs.push_back(e);
      } else {
        c_.edge_planes[e][1] = rational_plane(a, b, axis);
      }
    }
    std::vector<OrientedPlane> planes(triples.size());
    tables_.planes.intern_triangles(triples, planes);
    for (std::size_t i = 0; i < of_inputs.size(); ++i) {
      c_.edge_planes[of_inputs[i]][1] = planes[i].plane();
    }
  }

  /// Whether half-edge 2e has the direction n_p x n_q. The two directions are compared along an
  /// axis in which the ends of the edge differ. The axis in which they differ most is decided
  /// fastest.
  bool is_along(std::uint32_t e) const {
    // minor_sign() is the sign of the component of n_p x n_q along the axis.
    const SpacePoint from = end(2 * e), to = end(2 * e + 1);
    const bool are_inputs = from.is_input() && to.is_input();
    const auto [axis, runs] =
        are_inputs ? longest_axis(from.input(), to.input()) : longest_axis(from, to);
    const auto [p, q] = c_.edge_planes[e];
    return runs == minor_sign(tables_.planes, p, q, axis);
  }

 private:
  SpacePoint end(std::uint32_t halfedge) const { return c_.vertex_point[c_.origin[halfedge]]; }

  /// Returns the point straight above an input point, which is added once.
  InputPointId above(InputPointId p, std::size_t axis) {
    if (above_.empty()) above_.resize(tables_.planes.points().size());
    InputPointId& known = above_[p.value()][axis];
    if (!known.is_valid()) {
      known = tables_.planes.add_point(moved_along(tables_.planes.point(p), axis));
    }
    return known;
  }

  /// Returns the plane through a and b parallel to the axis, by coefficients.
  PlaneId rational_plane(SpacePoint a, SpacePoint b, std::size_t axis) {
    const RationalPoint3 p = exact(tables_.points, a), q = exact(tables_.points, b);
    const std::array<Rational, 3> at{p.x, p.y, p.z};
    const std::array<Rational, 3> d{q.x - p.x, q.y - p.y, q.z - p.z};
    const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
    std::array<Rational, 3> n;
    n[i] = d[j];
    n[j] = -d[i];
    return tables_.planes.intern(n[0], n[1], n[2], -(n[i] * at[i] + n[j] * at[j])).plane();
  }

  /// An axis, and the direction of an edge along it.
  struct Run {
    std::size_t axis;
    Sign sign;
  };

  /// Computes the same result for input points. A difference of doubles has the right sign unless
  /// it is flushed to zero.
  Run longest_axis(InputPointId a, InputPointId b) const {
    const Point3 &p = tables_.planes.point(a), &q = tables_.planes.point(b);
    const std::array<double, 3> d{q.x - p.x, q.y - p.y, q.z - p.z};
    std::size_t best = std::fabs(d[1]) > std::fabs(d[0]) ? 1 : 0;
    if (std::fabs(d[2]) > std::fabs(d[best])) best = 2;
    if (d[best] == 0) return longest_axis(SpacePoint(a), SpacePoint(b));
    return {best, d[best] > 0 ? Sign::Positive : Sign::Negative};
  }

  /// Returns an axis in which two points differ, and which way b is from a. Where doubles decide,
  /// it is the axis in which they differ most.
  Run longest_axis(SpacePoint a, SpacePoint b) const {
    const auto p = tables_.points.box(a).mid, q = tables_.points.box(b).mid;
    std::size_t best = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (std::fabs(q[i] - p[i]) > std::fabs(q[best] - p[best])) best = i;
    }
    if (q[best] - p[best] != 0) {
      const Sign sign = compare_axis(tables_.points, b, a, best);
      if (sign != Sign::Zero) return {best, sign};
    }
    best = 0;
    while (compare_axis(tables_.points, a, b, best) == Sign::Zero) ++best;
    return {best, compare_axis(tables_.points, b, a, best)};
  }

  SpaceComplex& c_;
  SpaceTables& tables_;
  std::vector<std::array<InputPointId, 3>> above_;  // One entry for each input point and axis.
};

/// Makes the arrays of the complex.
class Linker {
 public:
  Linker(const MeshFacets& facets, const MeshLinks& links, std::span<const SpacePoint> points,
         SpaceTables& tables)
      : facets_(facets), links_(links), points_(points), tables_(tables) {}

  SpaceComplex run() {
    fill_vertices();
    fill_edges();
    fill_uses();
    fill_facets();
    out_.list_stars(points_.size());
    return std::move(out_);
  }

 private:
  void fill_vertices() {
    const std::size_t n = points_.size();
    out_.vertex_point.assign(points_.begin(), points_.end());
    out_.vertex_mark.assign(n, 0);
    out_.vertex_volume.resize(n);
    out_.vertex_facet.resize(n);
  }

  // ---------------------------------------------------------------- edges

  PlaneId plane_of(std::uint32_t use) const { return facets_.plane[links_.facet[use]]; }

  void fill_edges() {
    const std::size_t n = links_.edge_count();
    out_.edge_mark.assign(n, 0);
    out_.edge_volume.resize(n);
    out_.edge_use.resize(n);
    out_.origin.resize(2 * n);
    for (std::size_t e = 0; e < n; ++e) {
      out_.origin[2 * e] = VertexId(links_.end[e][0]);
      out_.origin[2 * e + 1] = VertexId(links_.end[e][1]);
    }
    choose_planes();
  }

  /// Whether an edge with one plane may get its second plane later. This is the case if it lies
  /// between two triangles of input points.
  bool can_be_open(std::span<const std::uint32_t> uses) const {
    return uses.size() == 2 && is_input_triangle(uses[0]) && is_input_triangle(uses[1]);
  }
  bool is_input_triangle(std::uint32_t use) const {
    const std::uint32_t f = links_.facet[use];
    const auto corners = std::span(facets_.corner)
                             .subspan(facets_.begin[f], facets_.begin[f + 1] - facets_.begin[f]);
    return corners.size() == 3 &&
           std::ranges::all_of(corners, [this](std::uint32_t v) { return points_[v].is_input(); });
  }

  /// Chooses two planes through every edge: the plane of the first use, and the first plane that
  /// differs from it. Planes with a common line are not parallel. If there is no second plane, one
  /// is made, or the edge stays open.
  void choose_planes() {
    out_.edge_planes.resize(links_.edge_count());
    EdgePlanes planes(out_, tables_);
    const auto direct = [&](std::uint32_t e) {
      if (!planes.is_along(e)) std::swap(out_.origin[2 * e], out_.origin[2 * e + 1]);
    };
    std::vector<std::uint32_t> flat;
    for (std::uint32_t e = 0; e < links_.edge_count(); ++e) {
      const auto uses = links_.uses_of(e);
      const PlaneId first = plane_of(uses[0]);
      std::size_t i = 1;
      while (i < uses.size() && plane_of(uses[i]) == first) ++i;
      out_.edge_planes[e] = {first, i < uses.size() ? plane_of(uses[i]) : PlaneId()};
      if (i < uses.size()) {
        direct(e);
      } else if (!can_be_open(uses)) {
        flat.push_back(e);
      }
    }
    planes.add_second(flat);
    for (const std::uint32_t e : flat) direct(e);
  }

  // ---------------------------------------------------------------- uses

  void fill_uses() {
    const std::size_t n = facets_.corner.size();
    out_.use_halfedge.resize(n);
    out_.use_next.resize(n);
    out_.use_prev.resize(n);
    out_.use_radial.resize(n);
    out_.use_facet.resize(n);
    for (std::uint32_t u = 0; u < n; ++u) {
      out_.use_next[u] = UseId(links_.next[u]);
      out_.use_prev[links_.next[u]] = UseId(u);
      out_.use_facet[u] = FacetId(links_.facet[u]);
    }
    for (std::uint32_t e = 0; e < links_.edge_count(); ++e) link_ring(e);
  }

  /// Links the uses of an edge in radial order.
  void link_ring(std::uint32_t e) {
    const auto uses = links_.uses_of(e);
    for (const std::uint32_t u : uses) {
      const bool is_reverse = out_.origin[2 * e].value() != facets_.corner[u];
      out_.use_halfedge[u] = HalfedgeId(2 * e + (is_reverse ? 1 : 0));
    }
    // For two uses, both orders are the same.
    if (uses.size() == 2) {
      out_.use_radial[uses[0]] = UseId(uses[1]);
      out_.use_radial[uses[1]] = UseId(uses[0]);
      out_.edge_use[e] = UseId(uses[0]);
      return;
    }
    ring_.assign(uses.begin(), uses.end());
    sort_ring(e);
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      out_.use_radial[ring_[i]] = UseId(ring_[i + 1 < ring_.size() ? i + 1 : 0]);
    }
    out_.edge_use[e] = UseId(ring_[0]);
  }

  /// Sorts the uses around an edge. Uses leave a half-edge's line along n x d (of 2e) or -n x d (of
  /// 2e + 1), so their angles about d are those of n and -n. Counted from the plane p =
  /// edge_planes[e][0] these fall into classes: 0 along n_p, 1 in the half-turn after it, 2 along
  /// -n_p, 3 in the other half-turn. Within a half-turn the sign of the turn between two normals
  /// orders them.
  void sort_ring(std::uint32_t e) {
    const PlaneId p = out_.edge_planes[e][0], q = out_.edge_planes[e][1];
    const auto sense = [&](std::uint32_t u) {
      return SpaceComplex::is_reverse(out_.use_halfedge[u]) ? Sign::Negative : Sign::Positive;
    };
    const auto turn = [&](PlaneId m1, PlaneId m2) {
      return m1 == m2 ? Sign::Zero : turn_about_line(tables_.planes, p, q, m1, m2);
    };
    // The class of a use by its angle about d, counted from n_p.
    const auto quarter = [&](std::uint32_t u) {
      const Sign s = turn(p, plane_of(u)) * sense(u);
      if (s == Sign::Zero) return sense(u) == Sign::Positive ? 0 : 2;
      return s == Sign::Positive ? 1 : 3;
    };
    std::ranges::sort(ring_, [&](std::uint32_t u, std::uint32_t v) {
      const int i = quarter(u), j = quarter(v);
      if (i != j) return i < j;
      const Sign s = turn(plane_of(u), plane_of(v)) * sense(u) * sense(v);
      return s != Sign::Zero ? s == Sign::Positive : u < v;
    });
  }

  // ---------------------------------------------------------------- facets, stars

  void fill_facets() {
    const std::size_t n = facets_.size();
    out_.facet_plane = facets_.plane;
    out_.facet_mark.assign(n, 0);
    out_.facet_volume.resize(n);
    out_.facet_origin = facets_.origin;
    out_.inner_begin.assign(n + 1, 0);
    out_.cycle_begin.resize(n + 1);
    out_.cycle.resize(n);
    for (std::uint32_t f = 0; f < n; ++f) {
      out_.cycle_begin[f] = f;
      out_.cycle[f] = UseId(facets_.begin[f]);
    }
    out_.cycle_begin[n] = static_cast<std::uint32_t>(n);
  }

  const MeshFacets& facets_;
  const MeshLinks& links_;
  std::span<const SpacePoint> points_;
  SpaceTables& tables_;
  SpaceComplex out_;
  std::vector<std::uint32_t> ring_;
};

/// Exchanges the ids of half-edges 2e and 2e + 1. Requires an edge with two uses.
void turn_edge(SpaceComplex& complex, std::uint32_t e) {
  const HalfedgeId h(2 * e), twin(2 * e + 1);
  const auto turned = [&](HalfedgeId g) { return g == h ? twin : h; };
  for (const HalfedgeId g : {h, twin}) {
    const VertexId v = complex.origin[g.value()];
    const auto begin = complex.star.begin();
    *std::find(begin + complex.star_begin[v], begin + complex.star_begin[v.value() + 1], g) =
        turned(g);
  }
  std::swap(complex.origin[h.value()], complex.origin[twin.value()]);
  const UseId first = complex.edge_use[e];
  for (const UseId u : {first, complex.use_radial[first]}) {
    complex.use_halfedge[u] = turned(complex.use_halfedge[u]);
  }
}

}  // namespace

SpaceComplex link_facets(const MeshFacets& facets, const MeshLinks& links,
                         std::span<const SpacePoint> points,
                         const std::shared_ptr<SpaceTables>& tables, FlatEdges flat_edges) {
  SpaceComplex complex = Linker(facets, links, points, *tables).run();
  complex.tables = tables;
  if (flat_edges == FlatEdges::Complete) complete_flat_edges(complex, *tables);
  return complex;
}

// All second planes are interned at once, before any half-edge is reversed.
void complete_flat_edges(SpaceComplex& complex, SpaceTables& tables) {
  std::vector<std::uint32_t> flat;
  for (std::uint32_t e = 0; e < complex.edge_count(); ++e) {
    if (!complex.edge_planes[e][1].is_valid()) flat.push_back(e);
  }
  EdgePlanes planes(complex, tables);
  planes.add_second(flat);
  for (const std::uint32_t e : flat) {
    if (!planes.is_along(e)) turn_edge(complex, e);
  }
}

}  // namespace plumb
