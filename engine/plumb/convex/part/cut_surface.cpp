// The surface of a solid in half-edges: read from a complex, and written back piece by piece as
// sets.
//
// SurfaceReader makes each edge use of a facet (Weiler's radial-edge structure) a half-edge,
// reversed if the body is behind the facet's canonical side, and pairs two uses with the body
// between them as twins. So an edge at which several wedges of the body meet becomes several edges,
// and a vertex with several rings keeps one id; the first wedge and the first ring own the mark.
// PieceWriter does the reverse: half-edges become edge uses, and the complex has two volumes,
// outside and piece. Superfluous cells, such as the boundary between two parts of a divided face,
// are removed in simplified().
//
// All orientation tests are signs of plane triples and need no points: with d the direction of h,
// an edge is convex if (n1 x n2) . d > 0, and a corner turns left if n det(n, m1, m2) > 0.
// Tested by tests/convex/cut_surface_test.cpp.
#include "plumb/convex/part/cut_surface.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "plumb/convex/decompose.h"
#include "plumb/convex/part/surface_cut.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/space/boolean/frame.h"
#include "plumb/space/boolean/simplify.h"
#include "plumb/space/planar/facet_site.h"

namespace plumb {

// If d is the direction of h, (n1 x n2) . d is positive if the edge is convex.
bool CutSurface::is_reflex_at(HalfedgeId h) const {
  const Half& at = half(h);
  const OrientedPlane n1 = plane_of(h), n2 = plane_of(at.twin);
  if (n1.plane() == n2.plane()) return n1 != n2;
  const Sign common = at.other == n2.plane()
                          ? Sign::Positive
                          : same_direction(planes(), n1.plane(), n2.plane(), n1.plane(), at.other);
  return common * at.along * n1.orientation() * n2.orientation() == Sign::Negative;
}

// The turn is the sign of (n x m1) x (n x m2) = n det(n, m1, m2).
Sign CutSurface::turn_at(HalfedgeId h) const {
  const Half& before = half(half(h).prev);
  const OrientedPlane n = plane_of(h);
  return det3_sign(planes(), n.plane(), before.other, half(h).other) * before.along *
         half(h).along * n.orientation();
}

namespace {

/// Reads the surface from a complex. Each edge use of a facet, seen from outside, becomes a
/// half-edge.
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
  /// Whether every facet has the body on one side, and there are no free edges or vertices.
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

  bool is_outward(FacetId f) const { return c_.facet_volume[f][1] == body_; }

  void add_face(FacetId f) {
    const bool is_positive = is_outward(f);
    const FaceId id(surface_.faces.size());
    CutSurface::Face face{
        OrientedPlane(c_.facet_plane[f], !is_positive), {}, c_.facet_origin[f], c_.facet_mark[f]};
    HalfedgeId* link = &face.cycle;
    for (const UseId cycle : c_.cycles_of(f)) {
      *link = HalfedgeId(cycle.value());
      link = &surface_.halves[cycle.value()].next_cycle;
      UseId u = cycle;
      do {
        add_half(u, id, is_positive);
        u = c_.use_next[u];
      } while (u != cycle);
    }
    surface_.faces.push_back(face);
  }

  /// Seen from behind, a use has the opposite direction. Therefore next and previous are exchanged,
  /// and the origin is the other end.
  void add_half(UseId u, FaceId face, bool is_positive) {
    CutSurface::Half& h = surface_.halves[u.value()];
    const HalfedgeId run = c_.use_halfedge[u];
    const HalfedgeId seen = is_positive ? run : SpaceComplex::twin(run);
    const UseId next = is_positive ? c_.use_next[u] : c_.use_prev[u];
    const UseId prev = is_positive ? c_.use_prev[u] : c_.use_next[u];
    const std::size_t e = run.value() / 2;
    h.origin = c_.origin[seen];
    h.next = HalfedgeId(next.value());
    h.prev = HalfedgeId(prev.value());
    h.face = face;
    h.edge = EdgeId(e);
    name_line(h, c_.facet_plane[c_.use_facet[u]], EdgeId(e),
              SpaceComplex::is_reverse(seen) ? Sign::Negative : Sign::Positive);
  }

  // Represents the line by the plane of the face and a second plane. If the complex represents the
  // edge by two other planes p and q, `other` is q, and the sign compares the directions n x q and
  // p x q.
  void name_line(CutSurface::Half& h, PlaneId plane, EdgeId e, Sign runs) {
    const auto& [p, q] = c_.edge_planes[e];
    h.other = plane == p ? q : p;
    h.along = plane == p ? runs
                         : runs * (plane == q ? Sign::Negative
                                              : same_direction(c_.planes(), plane, p, p, q));
    const SpacePoint a = c_.vertex_point[c_.origin[2 * e.value()]];
    const SpacePoint b = c_.vertex_point[c_.origin[2 * e.value() + 1]];
    if (a.is_input() && b.is_input()) h.line = {a.input(), b.input()};
  }

  /// Makes two edge uses with the body between them twins. The first wedge around an edge owns its
  /// mark.
  void pair(UseId u) {
    if (c_.volume_after(u) != body_) return;
    const UseId v = c_.use_radial[u];
    const EdgeId e = SpaceComplex::edge_of(c_.use_halfedge[u]);
    const bool is_first = std::exchange(is_paired_[e], 1) == 0;
    CutSurface::Half& a = surface_.halves[u.value()];
    CutSurface::Half& b = surface_.halves[v.value()];
    a.twin = HalfedgeId(v.value());
    b.twin = HalfedgeId(u.value());
    a.mark = b.mark = is_first ? c_.edge_mark[e] : Mark{0};
  }

  /// Gives the mark of a vertex to the first ring around it.
  void give_vertices() {
    IdVector<VertexId, std::uint8_t> is_given(c_.vertex_count(), 0);
    IdVector<HalfedgeId, std::uint8_t> is_seen(c_.use_count(), 0);
    for (std::size_t u = 0; u < c_.use_count(); ++u) {
      if (is_seen[u] != 0) continue;
      const VertexId v = surface_.halves[u].origin;
      const bool is_first = std::exchange(is_given[v], 1) == 0;
      HalfedgeId h(u);
      do {
        is_seen[h] = 1;
        surface_.half(h).origin_mark = is_first ? c_.vertex_mark[v] : Mark{0};
        h = surface_.half(surface_.half(h).prev).twin;
      } while (h != HalfedgeId(u));
    }
  }

  bool is_connected() const {
    IdVector<FaceId, std::uint8_t> is_seen(surface_.faces.size(), 0);
    std::vector<FaceId> left{FaceId(0)};
    is_seen[0] = 1;
    std::size_t count = 0;
    while (!left.empty()) {
      const FaceId f = left.back();
      left.pop_back();
      ++count;
      surface_.for_each_half(f, [&](HalfedgeId h) {
        const FaceId g = surface_.half(surface_.half(h).twin).face;
        if (std::exchange(is_seen[g], 1) == 0) left.push_back(g);
      });
    }
    return count == surface_.faces.size();
  }

  const SpaceComplex& c_;
  VolumeId body_;
  CutSurface surface_;
  IdVector<EdgeId, std::uint8_t> is_paired_ = IdVector<EdgeId, std::uint8_t>(c_.edge_count(), 0);
};

}  // namespace

std::optional<CutSurface> cut_surface_of(const SpaceComplex& part) {
  const auto& marks = part.volume_mark;
  // The part is not bounded.
  if (has_frame(part) || part.volume_mark[0] == 1) return std::nullopt;
  if (std::count(marks.begin(), marks.end(), Mark{1}) != 1) return std::nullopt;
  const auto body = std::find(marks.begin(), marks.end(), Mark{1});
  return SurfaceReader(part, VolumeId(static_cast<std::size_t>(body - marks.begin()))).run();
}

// Makes a set from a piece of a surface.

namespace {

/// Writes a complex with two volumes, the outer volume and the piece. Each half-edge becomes the
/// edge use of a facet.
class PieceWriter {
 public:
  PieceWriter(CutSurface& surface, std::span<const FaceId> faces, bool closed)
      : s_(surface), faces_(faces), closed_(closed) {}

  SpaceComplex run() {
    number();
    c_.tables = s_.tables;
    c_.volume_mark = {0, 1};
    write_vertices();
    write_edges();
    write_uses();
    write_facets();
    c_.list_stars(vertices_.size());
    return std::move(c_);
  }

 private:
  Mark marked(Mark mark) const { return closed_ ? Mark{1} : mark; }

  /// Numbers half-edges and vertices in the order in which faces are listed.
  void number() {
    s_.half_number.resize(s_.halves.size());
    s_.vertex_number.resize(s_.point.size());
    for (const FaceId f : faces_) {
      s_.for_each_half(f, [this](HalfedgeId h) {
        s_.half_number[h] = static_cast<std::uint32_t>(halves_.size());
        halves_.push_back(h);
        const VertexId v = s_.half(h).origin;
        // A number that may belong to another piece.
        const std::uint32_t known = s_.vertex_number[v];
        if (known < vertices_.size() && vertices_[known] == v) return;
        s_.vertex_number[v] = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back(v);
      });
    }
  }
  std::size_t place(HalfedgeId h) const { return s_.half_number[h]; }
  std::size_t place(VertexId v) const { return s_.vertex_number[v]; }
  UseId use_of(HalfedgeId h) const { return UseId(place(h)); }

  void write_vertices() {
    const std::size_t n = vertices_.size();
    c_.vertex_mark.assign(n, marked(0));
    c_.vertex_volume.resize(n);
    c_.vertex_facet.resize(n);
    for (const VertexId v : vertices_) c_.vertex_point.push_back(s_.point[v]);
  }

  /// Each pair of twins becomes one edge. Half-edge 2e has the direction of the cross product of
  /// the canonical normals that represent its line.
  void write_edges() {
    c_.use_halfedge.resize(halves_.size());
    for (std::size_t i = 0; i < halves_.size(); ++i) {
      const CutSurface::Half& h = s_.half(halves_[i]);
      if (place(h.twin) < i) continue;
      const std::size_t e = c_.edge_planes.size(), from = place(h.origin),
                        to = place(s_.target(halves_[i]));
      const bool runs_back = h.along == Sign::Negative;
      c_.edge_planes.push_back({s_.plane_of(halves_[i]).plane(), h.other});
      c_.edge_mark.push_back(marked(h.mark));
      c_.edge_use.push_back(UseId(i));
      c_.origin.push_back(VertexId(runs_back ? to : from));
      c_.origin.push_back(VertexId(runs_back ? from : to));
      set_use(halves_[i], HalfedgeId(2 * e + (runs_back ? 1 : 0)));
      set_use(h.twin, HalfedgeId(2 * e + (runs_back ? 0 : 1)));
    }
    c_.edge_volume.resize(c_.edge_planes.size());
  }
  /// Sets the half-edge of a use. `run` has the direction of h, seen from outside.
  void set_use(HalfedgeId h, HalfedgeId run) {
    const bool is_seen_from_behind = s_.plane_of(h).is_opposite();
    c_.use_halfedge[use_of(h)] = is_seen_from_behind ? SpaceComplex::twin(run) : run;
  }

  void write_uses() {
    for (const HalfedgeId h : halves_) {
      const CutSurface::Half& half = s_.half(h);
      UseId next = use_of(half.next), prev = use_of(half.prev);
      if (s_.plane_of(h).is_opposite()) std::swap(next, prev);
      c_.use_next.push_back(next);
      c_.use_prev.push_back(prev);
      c_.use_radial.push_back(use_of(half.twin));
      if (half.origin_mark == 1) c_.vertex_mark[place(half.origin)] = 1;
    }
  }

  /// Returns the cycles, the outer cycle first. Cuts leave them in any order.
  std::vector<HalfedgeId> cycles_of(const CutSurface::Face& face) const {
    std::vector<HalfedgeId> cycles;
    for (HalfedgeId h = face.cycle; h.is_valid(); h = s_.half(h).next_cycle) cycles.push_back(h);
    if (cycles.size() > 1) {
      const auto outer = std::ranges::find_if(
          cycles, [&](HalfedgeId h) { return !is_hole(s_, face.plane, ring_of(s_, h)); });
      PLUMB_CHECK(outer != cycles.end());
      std::iter_swap(cycles.begin(), outer);
    }
    return cycles;
  }

  void write_facets() {
    c_.use_facet.resize(halves_.size());
    c_.cycle_begin = {0};
    for (const FaceId f : faces_) {
      const CutSurface::Face& face = s_.face(f);
      const FacetId id(c_.facet_plane.size());
      const bool is_opposite = face.plane.is_opposite();
      c_.facet_plane.push_back(face.plane.plane());
      c_.facet_mark.push_back(marked(face.mark));
      c_.facet_volume.push_back({VolumeId(is_opposite ? 1 : 0), VolumeId(is_opposite ? 0 : 1)});
      c_.facet_origin.push_back(face.origin);
      for (const HalfedgeId h : cycles_of(face)) c_.cycle.push_back(use_of(h));
      c_.cycle_begin.push_back(static_cast<std::uint32_t>(c_.cycle.size()));
      s_.for_each_half(f, [&](HalfedgeId h) { c_.use_facet[use_of(h)] = id; });
    }
    c_.inner_begin.assign(faces_.size() + 1, 0);
  }

  CutSurface& s_;
  std::span<const FaceId> faces_;
  bool closed_;
  SpaceComplex c_;
  std::vector<HalfedgeId> halves_;
  std::vector<VertexId> vertices_;
};

}  // namespace

bool touches_itself(const CutSurface& surface, std::span<const FaceId> faces) {
  std::vector<std::pair<VertexId, VertexId>> edges;
  std::vector<OrientedPlane> cuts;
  for (const FaceId f : faces) {
    surface.for_each_half(f, [&](HalfedgeId h) {
      const HalfedgeId t = surface.half(h).twin;
      const VertexId a = surface.half(h).origin, b = surface.half(t).origin;
      if (h < t) edges.emplace_back(std::min(a, b), std::max(a, b));
    });
    const CutSurface::Face& face = surface.face(f);
    if (face.origin == kWallOrigin) cuts.push_back(face.plane);
  }
  std::sort(edges.begin(), edges.end());
  std::sort(cuts.begin(), cuts.end());
  return std::adjacent_find(edges.begin(), edges.end()) != edges.end() ||
         std::adjacent_find(cuts.begin(), cuts.end(), [](OrientedPlane p, OrientedPlane q) {
           return p.plane() == q.plane() && p != q;
         }) != cuts.end();
}

Nef3 set_of_piece(CutSurface& surface, std::span<const FaceId> faces, bool closed,
                  Context& context) {
  return Nef3::from_minimal_unchecked(
      simplified(PieceWriter(surface, faces, closed).run(), context));
}

}  // namespace plumb
