#include "plumb/space/hull_polytope.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "plumb/predicates/point3_signs.h"
#include "plumb/space/tidy_tables.h"

namespace plumb {

std::vector<std::uint8_t> HullPolytope::facets_left(std::size_t bounds) const {
  std::vector<std::uint8_t> is_left(bounds, 0);
  for (const Halfedge& h : halfedge) {
    if (h.facet != kNone) is_left[h.facet] = 1;
  }
  return is_left;
}

namespace {

constexpr std::uint32_t kNone = HullPolytope::kNone;

class ComplexMaker {
 public:
  ComplexMaker(const HullPolytope& polytope, std::span<const HullBound> bounds)
      : polytope_(polytope), bounds_(bounds) {}

  SpaceComplex run(std::span<const std::uint32_t> touching, std::shared_ptr<SpaceTables> tables) {
    SpaceComplex c;
    c.tables = std::move(tables);
    number_items();
    fill_vertices(c);
    fill_edges(c);
    fill_facets(c);
    for (const std::uint32_t b : touching) clear_touched(bounds_[b].plane.plane(), c);
    c.volume_mark = {0, 1};
    return c;
  }

 private:
  const HullBound& bound_of(std::uint32_t h) const { return bounds_[polytope_.halfedge[h].facet]; }

  void number_items() {
    std::uint32_t count = 0;
    vertex_number_.assign(polytope_.vertex.size(), kNone);
    for (std::size_t v = 0; v < polytope_.vertex.size(); ++v) {
      if (polytope_.vertex[v].half != kNone) vertex_number_[v] = count++;
    }
    count = 0;
    edge_number_.assign(polytope_.halfedge.size() / 2, kNone);
    for (std::size_t e = 0; e < edge_number_.size(); ++e) {
      if (polytope_.halfedge[2 * e].facet != kNone) edge_number_[e] = count++;
    }
    facet_number_.assign(bounds_.size(), kNone);
    std::uint32_t facets = 0;
    const std::vector<std::uint8_t> is_left = polytope_.facets_left(bounds_.size());
    for (std::size_t b = 0; b < bounds_.size(); ++b) {
      if (is_left[b] != 0) facet_number_[b] = facets++;
    }
  }

  void fill_vertices(SpaceComplex& c) const {
    for (std::uint32_t v = 0; v < polytope_.vertex.size(); ++v) {
      if (vertex_number_[v] == kNone) continue;
      c.vertex_point.push_back(polytope_.vertex[v].point);
      c.star_begin.push_back(static_cast<std::uint32_t>(c.star.size()));
      bool is_closed = true;
      polytope_.for_each_leaving(v, [&](std::uint32_t h) {
        is_closed = is_closed && !bound_of(h).is_open;
        c.star.push_back(halfedge_of(h));
      });
      c.vertex_mark.push_back(is_closed ? 1 : 0);
    }
    c.star_begin.push_back(static_cast<std::uint32_t>(c.star.size()));
    c.vertex_volume.resize(c.vertex_count());
    c.vertex_facet.resize(c.vertex_count());
    for (std::size_t v = 0; v < c.vertex_count(); ++v) {
      std::sort(c.star.begin() + c.star_begin[v], c.star.begin() + c.star_begin[v + 1]);
    }
  }

  HalfedgeId halfedge_of(std::uint32_t h) const {
    return HalfedgeId(2 * edge_number_[h / 2] + h % 2);
  }
  /// Uses are the half-edges.
  UseId use_of(std::uint32_t h) const { return UseId(2 * edge_number_[h / 2] + h % 2); }

  /// A half-edge with its facet to the left runs along the product of the outward normals of that facet and of
  /// the one to its right: the edge is convex.
  void fill_edges(SpaceComplex& c) const {
    for (std::uint32_t e = 0; e < edge_number_.size(); ++e) {
      if (edge_number_[e] == kNone) continue;
      const HullBound &left = bound_of(2 * e), &right = bound_of(2 * e + 1);
      const bool is_turned = left.plane.is_opposite() != right.plane.is_opposite();
      const PlaneId p = left.plane.plane(), q = right.plane.plane();
      c.edge_planes.push_back(is_turned ? std::array{q, p} : std::array{p, q});
      c.edge_mark.push_back(left.is_open || right.is_open ? 0 : 1);
      c.edge_use.push_back(use_of(2 * e));
      for (const std::uint32_t h : {2 * e, 2 * e + 1}) {
        c.origin.emplace_back(vertex_number_[polytope_.halfedge[h].origin]);
        c.use_radial.push_back(use_of(HullPolytope::twin(h)));
        fill_use(h, c);
      }
    }
    c.edge_volume.resize(c.edge_count());
  }

  /// Uses have the positive side of the canonical plane in view: where that is the inside, they run back.
  void fill_use(std::uint32_t h, SpaceComplex& c) const {
    const auto& half = polytope_.halfedge[h];
    const bool is_back = bound_of(h).plane.is_opposite();
    c.use_halfedge.push_back(halfedge_of(is_back ? HullPolytope::twin(h) : h));
    c.use_next.push_back(use_of(is_back ? half.prev : half.next));
    c.use_prev.push_back(use_of(is_back ? half.next : half.prev));
    c.use_facet.emplace_back(facet_number_[half.facet]);
  }

  void fill_facets(SpaceComplex& c) const {
    for (std::size_t b = 0; b < bounds_.size(); ++b) {
      if (facet_number_[b] == kNone) continue;
      const bool is_opposite = bounds_[b].plane.is_opposite();
      c.facet_plane.push_back(bounds_[b].plane.plane());
      c.facet_mark.push_back(bounds_[b].is_open ? 0 : 1);
      c.facet_volume.push_back({VolumeId(is_opposite ? 1 : 0), VolumeId(is_opposite ? 0 : 1)});
      c.facet_origin.push_back(kNone);
    }
    c.cycle.resize(c.facet_count());
    for (std::size_t u = c.use_count(); u-- > 0;) c.cycle[c.use_facet[u].value()] = UseId(u);
    c.cycle_begin.resize(c.facet_count() + 1);
    std::iota(c.cycle_begin.begin(), c.cycle_begin.end(), 0U);
    c.inner_begin.assign(c.facet_count() + 1, 0);
  }

  void clear_touched(PlaneId plane, SpaceComplex& c) const {
    std::vector<std::uint8_t> is_on(c.vertex_count());
    for (std::size_t v = 0; v < c.vertex_count(); ++v) {
      is_on[v] = side(c.points(), c.vertex_point[v], plane) == Sign::Zero ? 1 : 0;
      if (is_on[v] != 0) c.vertex_mark[v] = 0;
    }
    for (std::size_t e = 0; e < c.edge_count(); ++e) {
      if (is_on[c.origin[2 * e].value()] != 0 && is_on[c.origin[2 * e + 1].value()] != 0) {
        c.edge_mark[e] = 0;
      }
    }
  }

  const HullPolytope& polytope_;
  std::span<const HullBound> bounds_;
  std::vector<std::uint32_t> vertex_number_, edge_number_, facet_number_;
};

}  // namespace

SpaceComplex complex_of_polytope(const HullPolytope& polytope, std::span<const HullBound> bounds,
                                 std::span<const std::uint32_t> touching,
                                 std::shared_ptr<SpaceTables> tables) {
  return with_used_tables(ComplexMaker(polytope, bounds).run(touching, std::move(tables)));
}

}  // namespace plumb
