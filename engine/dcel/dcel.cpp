#include "plumb/dcel/dcel.h"

#include <algorithm>

#include "plumb/base/error.h"

namespace plumb {
namespace {

constexpr std::size_t kMaxHalfedges = (std::size_t{1} << 31U) - 2;

/// The even half-edge of each edge goes to its lower corner position.
std::vector<HalfedgeId> number_halfedges(std::span<const std::uint32_t> twin_of) {
  std::vector<HalfedgeId> halfedge_of(twin_of.size());
  std::size_t edges = 0;
  for (std::size_t p = 0; p < twin_of.size(); ++p) {
    const std::size_t t = twin_of[p];
    PLUMB_CHECK(t < twin_of.size() && t != p && twin_of[t] == p);
    if (t < p) continue;
    halfedge_of[p] = HalfedgeId(2 * edges);
    halfedge_of[t] = HalfedgeId(2 * edges + 1);
    ++edges;
  }
  return halfedge_of;
}

std::size_t face_count_of(std::span<const std::uint32_t> face_of_cycle,
                          std::span<const Dcel::IsolatedVertex> isolated) {
  std::size_t count = 0;
  for (const std::uint32_t f : face_of_cycle) count = std::max<std::size_t>(count, f + 1U);
  for (const auto& i : isolated) count = std::max<std::size_t>(count, i.face.value() + 1U);
  return count;
}

/// New ids for the present ones among `slots`.
template <class Id, class Contains>
std::vector<Id> renumber(std::size_t slots, Contains contains) {
  std::vector<Id> ids(slots);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < slots; ++i) {
    if (contains(Id(i))) ids[i] = Id(kept++);
  }
  return ids;
}

}  // namespace

DcelFromCycles Dcel::from_cycles(std::size_t vertex_count, std::span<const std::uint32_t> corners,
                                 std::span<const std::uint32_t> cycle_begin,
                                 std::span<const std::uint32_t> twin,
                                 std::span<const std::uint32_t> face_of_cycle,
                                 std::span<const IsolatedVertex> isolated) {
  const std::size_t cycles = face_of_cycle.size();
  PLUMB_CHECK(corners.size() <= kMaxHalfedges && twin.size() == corners.size());
  PLUMB_CHECK(cycle_begin.size() == cycles + 1 && cycle_begin.back() == corners.size());
  DcelFromCycles result{{}, number_halfedges(twin)};
  Dcel& d = result.dcel;
  d.halfedges_.resize(corners.size());
  d.counts_.edges = corners.size() / 2;
  d.vertices_.resize(vertex_count);
  d.faces_.resize(face_count_of(face_of_cycle, isolated));
  d.counts_.faces = d.faces_.size();
  d.loops_.reserve(cycles + isolated.size());
  for (std::size_t c = 0; c < cycles; ++c) {
    const std::size_t begin = cycle_begin[c];
    PLUMB_CHECK(begin < cycle_begin[c + 1]);
    d.fill_cycle(LoopId(c), corners.subspan(begin, cycle_begin[c + 1] - begin),
                 result.halfedge_of_corner.data() + begin);
    d.new_loop(result.halfedge_of_corner[begin], FaceId(face_of_cycle[c]));
  }
  d.check_targets();
  d.place_isolated(isolated);
  d.has_pinches_ = d.find_pinches();
  return result;
}

Dcel Dcel::from_links(std::size_t vertex_count, std::span<const VertexId> origin,
                      std::span<const HalfedgeId> next, std::span<const std::uint32_t> loop_of,
                      std::span<const FaceId> face_of_loop,
                      std::span<const IsolatedVertex> isolated) {
  PLUMB_CHECK(origin.size() <= kMaxHalfedges && origin.size() % 2 == 0);
  PLUMB_CHECK(next.size() == origin.size() && loop_of.size() == origin.size());
  Dcel d;
  d.vertices_.resize(vertex_count);
  d.counts_.edges = origin.size() / 2;
  d.link_halfedges(origin, next, loop_of);
  std::size_t faces = 0;
  for (const FaceId f : face_of_loop) faces = std::max<std::size_t>(faces, f.value() + 1U);
  for (const auto& i : isolated) faces = std::max<std::size_t>(faces, i.face.value() + 1U);
  d.faces_.resize(faces);
  d.counts_.faces = faces;
  std::vector<HalfedgeId> first(face_of_loop.size());
  for (std::size_t h = loop_of.size(); h-- > 0;) first[loop_of[h]] = HalfedgeId(h);
  d.loops_.reserve(face_of_loop.size() + isolated.size());
  for (std::size_t l = 0; l < first.size(); ++l) {
    PLUMB_CHECK(first[l].is_valid());
    d.new_loop(first[l], face_of_loop[l]);
  }
  d.check_targets();
  d.place_isolated(isolated);
  d.has_pinches_ = d.find_pinches();
  return d;
}

void Dcel::link_halfedges(std::span<const VertexId> origin, std::span<const HalfedgeId> next,
                          std::span<const std::uint32_t> loop_of) {
  halfedges_.resize(origin.size());
  for (std::size_t i = 0; i < origin.size(); ++i) {
    PLUMB_CHECK(next[i].value() < next.size() && origin[i].value() < vertices_.size());
    halfedges_[i].origin = origin[i];
    halfedges_[i].next = next[i];
    halfedges_[i].loop = LoopId(loop_of[i]);
    halfedges_[next[i].value()].prev = HalfedgeId(i);
    if (auto& leaving = vertices_[origin[i].value()]; !leaving.is_valid()) {
      leaving = HalfedgeId(i);
      ++counts_.vertices;
    }
  }
}

void Dcel::place_isolated(std::span<const IsolatedVertex> isolated) {
  for (const auto& [v, f] : isolated) {
    PLUMB_CHECK(v.value() < vertices_.size() && !vertices_[v.value()].is_valid());
    vertices_[v.value()] = new_loop(v, f);
    ++counts_.vertices;
  }
}

/// The half-edges of one listed cycle; every array entry written is one of this cycle's.
void Dcel::fill_cycle(LoopId l, std::span<const std::uint32_t> vertices,
                      const HalfedgeId* halfedges) {
  HalfedgeId prev = halfedges[vertices.size() - 1];
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const HalfedgeId h = halfedges[i];
    const HalfedgeId next = halfedges[i + 1 < vertices.size() ? i + 1 : 0];
    PLUMB_CHECK(vertices[i] < vertices_.size());
    halfedges_[h.value()] = {VertexId(vertices[i]), next, prev, l};
    prev = h;
    if (auto& first = vertices_[vertices[i]]; !first.is_valid()) {
      first = h;
      ++counts_.vertices;
    }
  }
}

/// Twins must run between the same two vertices.
void Dcel::check_targets() const {
  for (std::size_t i = 0; i < halfedges_.size(); ++i) {
    PLUMB_CHECK(origin(next(HalfedgeId(i))) == target(HalfedgeId(i)));
  }
}

/// Without a pinch the ring of each vertex's first half-edge holds all that leave it.
bool Dcel::find_pinches() const {
  std::size_t reached = 0;
  for (const auto first : vertices_) {
    if (!first.is_halfedge()) continue;
    HalfedgeId h = first.halfedge();
    do {
      ++reached;
      h = turn_right(h);
    } while (h != first.halfedge());
  }
  return reached != 2 * counts_.edges;
}

DcelCompaction Dcel::compact() {
  const auto contains = [this](auto id) { return this->contains(id); };
  DcelCompaction to{
      renumber<VertexId>(vertex_slots(), contains), renumber<EdgeId>(edge_slots(), contains),
      renumber<LoopId>(loop_slots(), contains), renumber<FaceId>(face_slots(), contains)};
  const auto vertex = [&to](VertexId v) { return v.is_valid() ? to.vertex[v.value()] : v; };
  const auto loop = [&to](LoopId l) { return l.is_valid() ? to.loop[l.value()] : l; };
  const auto halfedge = [&to](HalfedgeId h) { return h.is_valid() ? to.halfedge(h) : h; };

  std::vector<EdgeId> edge_of_slot(halfedge_slots());
  for (std::size_t i = 0; i < edge_of_slot.size(); ++i) edge_of_slot[i] = to.edge[i / 2];
  follow(edge_of_slot, halfedges_);
  follow(to.vertex, vertices_);
  follow(to.loop, loops_);
  follow(to.face, faces_);

  for (Halfedge& h : halfedges_) {
    h = {vertex(h.origin), halfedge(h.next), halfedge(h.prev), loop(h.loop)};
  }
  for (auto& v : vertices_) {
    if (v.is_halfedge())
      v = halfedge(v.halfedge());
    else
      v = loop(v.other());
  }
  for (Loop& l : loops_) {
    if (l.first.is_halfedge())
      l.first = halfedge(l.first.halfedge());
    else
      l.first = vertex(l.first.other());
    l = {l.first, to.face[l.face.value()], loop(l.next), loop(l.prev)};
  }
  for (LoopId& l : faces_) l = loop(l);
  return to;
}

}  // namespace plumb
