// A piece of a surface as a set of its own (cut_surface.h).

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "plumb/base/error.h"
#include "plumb/convex/cut_surface.h"
#include "plumb/convex/decompose.h"
#include "plumb/convex/plane_ring.h"
#include "plumb/space/simplify.h"

namespace plumb {
namespace {

/// Two volumes, the outer one and the piece; each half-edge becomes the use of a facet.
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
    write_stars();
    return std::move(c_);
  }

 private:
  Mark marked(Mark mark) const { return closed_ ? Mark{1} : mark; }

  /// In the order in which faces are listed.
  void number() {
    s_.half_number.resize(s_.halves.size());
    s_.vertex_number.resize(s_.point.size());
    for (const FaceId f : faces_) {
      s_.for_each_half(f, [this](HalfedgeId h) {
        s_.half_number[h.value()] = static_cast<std::uint32_t>(halves_.size());
        halves_.push_back(h);
        const VertexId v = s_.half(h).origin;
        const std::uint32_t known = s_.vertex_number[v.value()];  // of another piece, perhaps
        if (known < vertices_.size() && vertices_[known] == v) return;
        s_.vertex_number[v.value()] = static_cast<std::uint32_t>(vertices_.size());
        vertices_.push_back(v);
      });
    }
  }
  std::size_t place(HalfedgeId h) const { return s_.half_number[h.value()]; }
  std::size_t place(VertexId v) const { return s_.vertex_number[v.value()]; }
  UseId use_of(HalfedgeId h) const { return UseId(place(h)); }

  void write_vertices() {
    const std::size_t n = vertices_.size();
    c_.vertex_mark.assign(n, marked(0));
    c_.vertex_volume.resize(n);
    c_.vertex_facet.resize(n);
    for (const VertexId v : vertices_) c_.vertex_point.push_back(s_.point[v.value()]);
  }

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
  /// `run`: along h as seen from outside.
  void set_use(HalfedgeId h, HalfedgeId run) {
    const bool is_seen_from_behind = s_.plane_of(h).is_opposite();
    c_.use_halfedge[use_of(h).value()] = is_seen_from_behind ? SpaceComplex::twin(run) : run;
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

  /// The outer one first; cuts leave them in any order.
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
      s_.for_each_half(f, [&](HalfedgeId h) { c_.use_facet[use_of(h).value()] = id; });
    }
    c_.inner_begin.assign(faces_.size() + 1, 0);
  }

  void write_stars() {
    c_.star_begin.assign(vertices_.size() + 1, 0);
    for (const VertexId v : c_.origin) ++c_.star_begin[v.value() + 1];
    for (std::size_t v = 0; v < vertices_.size(); ++v) {
      c_.star_begin[v + 1] += c_.star_begin[v];
    }
    c_.star.resize(c_.origin.size());
    std::vector<std::uint32_t> at(c_.star_begin.begin(), c_.star_begin.end() - 1);
    for (std::size_t h = 0; h < c_.origin.size(); ++h) {
      c_.star[at[c_.origin[h].value()]++] = HalfedgeId(h);
    }
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
  return Nef3::from_minimal(simplified(PieceWriter(surface, faces, closed).run(), context));
}

}  // namespace plumb
