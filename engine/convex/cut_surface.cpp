#include "plumb/convex/cut_surface.h"

#include <algorithm>
#include <utility>

#include "plumb/predicates/plane_signs.h"
#include "plumb/space/frame.h"
#include "plumb/space/plane_cycles.h"

namespace plumb {

// With d the direction of h: (n1 x n2) . d is positive where the edge is convex.
bool CutSurface::is_reflex_at(HalfedgeId h) const {
  const Half& at = half(h);
  const OrientedPlane n1 = plane_of(h), n2 = plane_of(at.twin);
  if (n1.plane() == n2.plane()) return n1 != n2;
  const Sign common = at.other == n2.plane()
                          ? Sign::Positive
                          : same_direction(planes(), n1.plane(), n2.plane(), n1.plane(), at.other);
  return common * at.along * n1.orientation() * n2.orientation() == Sign::Negative;
}

// (n x m1) x (n x m2) = n det(n, m1, m2).
Sign CutSurface::turn_at(HalfedgeId h) const {
  const Half& before = half(half(h).prev);
  const OrientedPlane n = plane_of(h);
  return det3_sign(planes(), n.plane(), before.other, half(h).other) * before.along *
         half(h).along * n.orientation();
}

namespace {

/// Reads the surface off a complex: each use of a facet, seen from outside, is a half-edge.
class SurfaceReader {
 public:
  SurfaceReader(const SpaceComplex& complex, VolumeId body) : c_(complex), body_(body) {}

  std::optional<CutSurface> run() {
    if (!is_surface_of_body()) return std::nullopt;
    surface_.tables = copy(*c_.tables);
    surface_.point = c_.vertex_point;
    surface_.halves.resize(c_.use_count());
    for (std::size_t f = 0; f < c_.facet_count(); ++f) add_face(FacetId(f));
    for (std::size_t u = 0; u < c_.use_count(); ++u) pair(UseId(u));
    give_vertices();
    for (std::size_t u = 0; u < c_.use_count(); ++u) {
      surface_.halves[u].is_reflex = surface_.is_reflex_at(HalfedgeId(u));
    }
    if (!is_connected()) return std::nullopt;
    return std::move(surface_);
  }

 private:
  /// Every facet has the body on one side; no free edges or vertices.
  bool is_surface_of_body() const {
    for (const auto& [above, below] : c_.facet_volume) {
      if ((above == body_) == (below == body_)) return false;
    }
    for (const UseId u : c_.edge_use) {
      if (!u.is_valid()) return false;
    }
    for (std::size_t v = 0; v < c_.vertex_count(); ++v) {
      if (c_.star_of(VertexId(v)).empty()) return false;
      if (c_.vertex_facet[v].is_valid()) return false;
    }
    return true;
  }

  bool is_outward(FacetId f) const { return c_.facet_volume[f.value()][1] == body_; }

  void add_face(FacetId f) {
    const bool is_positive = is_outward(f);
    const FaceId id(surface_.faces.size());
    CutSurface::Face face{OrientedPlane(c_.facet_plane[f.value()], !is_positive),
                          {},
                          c_.facet_origin[f.value()],
                          c_.facet_mark[f.value()]};
    HalfedgeId* link = &face.cycle;
    for (const UseId cycle : c_.cycles_of(f)) {
      *link = HalfedgeId(cycle.value());
      link = &surface_.halves[cycle.value()].next_cycle;
      UseId u = cycle;
      do {
        add_half(u, id, is_positive);
        u = c_.use_next[u.value()];
      } while (u != cycle);
    }
    surface_.faces.push_back(face);
  }

  void add_half(UseId u, FaceId face, bool is_positive) {
    CutSurface::Half& h = surface_.halves[u.value()];
    const HalfedgeId run = c_.use_halfedge[u.value()];
    const HalfedgeId seen = is_positive ? run : SpaceComplex::twin(run);
    const UseId next = is_positive ? c_.use_next[u.value()] : c_.use_prev[u.value()];
    const UseId prev = is_positive ? c_.use_prev[u.value()] : c_.use_next[u.value()];
    const std::size_t e = run.value() / 2;
    h.origin = c_.origin[seen.value()];
    h.next = HalfedgeId(next.value());
    h.prev = HalfedgeId(prev.value());
    h.face = face;
    h.edge = EdgeId(e);
    name_line(h, c_.facet_plane[c_.use_facet[u.value()].value()], EdgeId(e),
              SpaceComplex::is_reverse(seen) ? Sign::Negative : Sign::Positive);
  }

  void name_line(CutSurface::Half& h, PlaneId plane, EdgeId e, Sign runs) {
    const auto& [p, q] = c_.edge_planes[e.value()];
    h.other = plane == p ? q : p;
    h.along = plane == p ? runs
                         : runs * (plane == q ? Sign::Negative
                                              : same_direction(c_.planes(), plane, p, p, q));
    const SpacePoint a = c_.vertex_point[c_.origin[2 * e.value()].value()];
    const SpacePoint b = c_.vertex_point[c_.origin[2 * e.value() + 1].value()];
    if (a.is_input() && b.is_input()) h.line = {a.input(), b.input()};
  }

  /// Of two uses with the body between them. The first wedge around an edge owns it.
  void pair(UseId u) {
    if (c_.volume_after(u) != body_) return;
    const UseId v = c_.use_radial[u.value()];
    const EdgeId e = SpaceComplex::edge_of(c_.use_halfedge[u.value()]);
    const bool is_first = std::exchange(is_paired_[e.value()], 1) == 0;
    CutSurface::Half& a = surface_.halves[u.value()];
    CutSurface::Half& b = surface_.halves[v.value()];
    a.twin = HalfedgeId(v.value());
    b.twin = HalfedgeId(u.value());
    a.mark = b.mark = is_first ? c_.edge_mark[e.value()] : Mark{0};
  }

  /// The first ring around a vertex owns it.
  void give_vertices() {
    std::vector<std::uint8_t> is_given(c_.vertex_count(), 0), is_seen(c_.use_count(), 0);
    for (std::size_t u = 0; u < c_.use_count(); ++u) {
      if (is_seen[u] != 0) continue;
      const VertexId v = surface_.halves[u].origin;
      const bool is_first = std::exchange(is_given[v.value()], 1) == 0;
      HalfedgeId h(u);
      do {
        is_seen[h.value()] = 1;
        surface_.half(h).origin_mark = is_first ? c_.vertex_mark[v.value()] : Mark{0};
        h = surface_.half(surface_.half(h).prev).twin;
      } while (h != HalfedgeId(u));
    }
  }

  bool is_connected() const {
    std::vector<std::uint8_t> is_seen(surface_.faces.size(), 0);
    std::vector<FaceId> left{FaceId(0)};
    is_seen[0] = 1;
    std::size_t count = 0;
    while (!left.empty()) {
      const FaceId f = left.back();
      left.pop_back();
      ++count;
      surface_.for_each_half(f, [&](HalfedgeId h) {
        const FaceId g = surface_.half(surface_.half(h).twin).face;
        if (std::exchange(is_seen[g.value()], 1) == 0) left.push_back(g);
      });
    }
    return count == surface_.faces.size();
  }

  const SpaceComplex& c_;
  VolumeId body_;
  CutSurface surface_;
  std::vector<std::uint8_t> is_paired_ = std::vector<std::uint8_t>(c_.edge_count(), 0);
};

}  // namespace

std::optional<CutSurface> cut_surface_of(const SpaceComplex& part) {
  const auto& marks = part.volume_mark;
  if (has_frame(part) || part.volume_mark[0] == 1) return std::nullopt;  // not bounded
  if (std::count(marks.begin(), marks.end(), Mark{1}) != 1) return std::nullopt;
  const auto body = std::find(marks.begin(), marks.end(), Mark{1});
  return SurfaceReader(part, VolumeId(static_cast<std::size_t>(body - marks.begin()))).run();
}

}  // namespace plumb
