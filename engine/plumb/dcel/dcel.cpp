// The half-edge structure: construction from cycles or links, compaction, and the Euler operators.
//
// Invariants (dcel.h lists them, dcel_audit.cpp checks them): next is a permutation with the
// inverse prev; it keeps loops and leads from a half-edge to one that leaves its target; every loop
// is in the ring of its face; a vertex refers to a half-edge that leaves it, or, if it is isolated,
// to its loop. Every operator keeps them: it changes links first, then loops, then vertices. An
// operator takes constant time, or the time for relabelling one loop. Operators refuse structures
// with pinches, in which a vertex has several rings, because the ring of an edge would be unknown.
//
// Sources: L. J. Guibas, J. Stolfi, Primitives for the manipulation of general subdivisions and the
// computation of Voronoi diagrams, ACM Transactions on Graphics 4 (1985); M. Mäntylä, An
// Introduction to Solid Modeling, Computer Science Press (1988), for Euler operators.
//
// Tested by tests/dcel/dcel_test.cpp and tests/dcel/dcel_euler_test.cpp.

#include "plumb/dcel/dcel.h"

#include <algorithm>

#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::size_t kMaxHalfedges = (std::size_t{1} << 31U) - 2;

/// Returns the half-edge of each corner position. Of the two half-edges of an edge, the even one is
/// at the lower position.
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

/// Returns new ids for those among `slots` that are present.
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

/// Copies the links and derives prev and the first half-edge of each vertex.
void Dcel::link_halfedges(std::span<const VertexId> origin, std::span<const HalfedgeId> next,
                          std::span<const std::uint32_t> loop_of) {
  halfedges_.resize(origin.size());
  for (std::size_t i = 0; i < origin.size(); ++i) {
    PLUMB_CHECK(next[i].value() < next.size() && origin[i].value() < vertices_.size());
    halfedges_[i].origin = origin[i];
    halfedges_[i].next = next[i];
    halfedges_[i].loop = LoopId(loop_of[i]);
    halfedges_[next[i]].prev = HalfedgeId(i);
    if (auto& leaving = vertices_[origin[i]]; !leaving.is_valid()) {
      leaving = HalfedgeId(i);
      ++counts_.vertices;
    }
  }
}

void Dcel::place_isolated(std::span<const IsolatedVertex> isolated) {
  for (const auto& [v, f] : isolated) {
    PLUMB_CHECK(v.value() < vertices_.size() && !vertices_[v].is_valid());
    vertices_[v] = new_loop(v, f);
    ++counts_.vertices;
  }
}

/// Fills in the half-edges of one listed cycle. Apart from the first half-edges of its vertices, it
/// writes only entries of this cycle.
void Dcel::fill_cycle(LoopId l, std::span<const std::uint32_t> vertices,
                      const HalfedgeId* halfedges) {
  HalfedgeId prev = halfedges[vertices.size() - 1];
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const HalfedgeId h = halfedges[i];
    const HalfedgeId next = halfedges[i + 1 < vertices.size() ? i + 1 : 0];
    PLUMB_CHECK(vertices[i] < vertices_.size());
    halfedges_[h] = {VertexId(vertices[i]), next, prev, l};
    prev = h;
    if (auto& first = vertices_[vertices[i]]; !first.is_valid()) {
      first = h;
      ++counts_.vertices;
    }
  }
}

/// Checks that twins run between the same two vertices.
void Dcel::check_targets() const {
  for (std::size_t i = 0; i < halfedges_.size(); ++i) {
    PLUMB_CHECK(origin(next(HalfedgeId(i))) == target(HalfedgeId(i)));
  }
}

/// Whether there is a pinch. Without pinches, the ring of each vertex's first half-edge contains
/// all half-edges that leave the vertex.
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

/// Elements are moved first, in the order of their ids, and then all links are renamed.
DcelCompaction Dcel::compact() {
  const auto contains = [this](auto id) { return this->contains(id); };
  DcelCompaction to{
      renumber<VertexId>(vertex_slots(), contains), renumber<EdgeId>(edge_slots(), contains),
      renumber<LoopId>(loop_slots(), contains), renumber<FaceId>(face_slots(), contains)};
  const auto vertex = [&to](VertexId v) { return v.is_valid() ? to.vertex[v] : v; };
  const auto loop = [&to](LoopId l) { return l.is_valid() ? to.loop[l] : l; };
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
    l = {l.first, to.face[l.face], loop(l.next), loop(l.prev)};
  }
  for (LoopId& l : faces_) l = loop(l);
  return to;
}

// The Euler operators. Each operator links the half-edges first and then updates loops and
// vertices. The half-edges h and t = twin(h) form the new or removed edge. Half-edge h leaves
// corner a, and t leaves corner b.

// --- faces, loops, isolated vertices -----------------------------------------------------------

FaceId Dcel::add_face() {
  faces_.emplace_back();
  ++counts_.faces;
  return FaceId(faces_.size() - 1);
}

void Dcel::remove_face(FaceId f) {
  PLUMB_CHECK(contains(f) && !first_loop(f).is_valid());
  faces_[f] = kRemoved;
  --counts_.faces;
}

VertexId Dcel::add_vertex(FaceId f) {
  PLUMB_CHECK(!has_pinches_ && contains(f));
  const VertexId v(vertices_.size());
  vertices_.emplace_back(new_loop(v, f));
  ++counts_.vertices;
  return v;
}

void Dcel::remove_vertex(VertexId v) {
  PLUMB_CHECK(contains(v) && is_isolated(v));
  drop_loop(isolated_loop(v));
  vertices_[v] = {};
  --counts_.vertices;
}

LoopId Dcel::new_loop(Corner first, FaceId f) {
  const LoopId l(loops_.size());
  loops_.push_back({first, {}, {}, {}});
  ++counts_.loops;
  enter_face(l, f);
  return l;
}

void Dcel::drop_loop(LoopId l) {
  leave_face(l);
  loops_[l] = {};
  --counts_.loops;
}

/// Appends l to the ring of f's loops.
void Dcel::enter_face(LoopId l, FaceId f) {
  Loop& loop = loops_[l];
  loop.face = f;
  LoopId& first = faces_[f];
  if (!first.is_valid()) first = loop.next = loop.prev = l;
  loop.next = first;
  loop.prev = std::exchange(loops_[first].prev, l);
  loops_[loop.prev].next = l;
}

/// Takes l out of the ring of its face's loops.
void Dcel::leave_face(LoopId l) {
  const Loop loop = loops_[l];
  LoopId& first = faces_[loop.face];
  if (first == l) first = loop.next == l ? LoopId() : loop.next;
  loops_[loop.prev].next = loop.next;
  loops_[loop.next].prev = loop.prev;
}

/// Only loops are moved, each in constant time, because half-edges refer to their faces through
/// their loops.
FaceId Dcel::split_face(std::span<const LoopId> loops) {
  PLUMB_CHECK(!loops.empty() && contains(loops.front()));
  const FaceId old = face(loops.front());
  const FaceId f = add_face();
  for (const LoopId l : loops) {
    // A loop that is given twice has left the face already.
    PLUMB_CHECK(contains(l) && face(l) == old);
    leave_face(l);
    enter_face(l, f);
  }
  return f;
}

void Dcel::join_faces(FaceId kept, FaceId gone) {
  PLUMB_CHECK(contains(kept) && contains(gone) && kept != gone);
  while (first_loop(gone).is_valid()) {
    const LoopId l = first_loop(gone);
    leave_face(l);
    enter_face(l, kept);
  }
  remove_face(gone);
}

// --- edges between corners -----------------------------------------------------------------------

HalfedgeId Dcel::new_edge(VertexId from, VertexId to) {
  const HalfedgeId h(halfedges_.size());
  PLUMB_CHECK(h.value() < (std::uint32_t{1} << 31U) - 3);
  halfedges_.push_back({from, {}, {}, {}});
  halfedges_.push_back({to, {}, {}, {}});
  ++counts_.edges;
  return h;
}

bool Dcel::is_corner(Corner c) const {
  if (c.is_halfedge()) return contains(c.halfedge());
  return contains(c.other()) && is_isolated(c.other());
}

/// Links an edge at one end: h leaves corner `at`, and its twin arrives there.
void Dcel::attach(HalfedgeId h, Corner at) {
  if (!at.is_halfedge()) return link(twin(h), h);
  link(prev(at.halfedge()), h);
  link(twin(h), at.halfedge());
}

/// Links an edge from a corner to itself: h alone becomes a loop, and its twin runs around it.
void Dcel::attach_self_loop(HalfedgeId h, Corner at) {
  attach(twin(h), at);
  if (at.is_halfedge())
    link(twin(h), at.halfedge());
  else
    link(twin(h), twin(h));
  link(h, h);
}

/// Labels the half-edges from `from` to the one before `stop`.
void Dcel::relabel(HalfedgeId from, HalfedgeId stop, LoopId l) {
  for (HalfedgeId h = from; h != stop; h = next(h)) halfedges_[h].loop = l;
}

/// An edge between two corners of one loop splits that loop, and the part that begins with h
/// becomes a new loop. An edge between two loops joins them: the loop of b becomes a part of the
/// loop of a.
HalfedgeId Dcel::add_edge(Corner a, Corner b) {
  PLUMB_CHECK(!has_pinches_ && is_corner(a) && is_corner(b));
  const LoopId la = loop_at(a), lb = loop_at(b);
  PLUMB_CHECK(face(la) == face(lb));
  const HalfedgeId h = new_edge(vertex_at(a), vertex_at(b)), t = twin(h);
  if (a == b) {
    attach_self_loop(h, a);
  } else {
    attach(h, a);
    attach(t, b);
  }
  if (!a.is_halfedge()) vertices_[a.other()] = h;
  if (!b.is_halfedge()) vertices_[b.other()] = b == a ? h : t;
  if (la == lb) {
    const LoopId l = new_loop(h, face(la));
    halfedges_[h].loop = l;
    relabel(next(h), h, l);
  } else {
    drop_loop(lb);
    relabel(h, t, la);
  }
  halfedges_[t].loop = la;
  loops_[la].first = t;
  return h;
}

/// Returns a half-edge that leaves origin(h) and does not belong to the edge of h; an invalid id if
/// there is none.
HalfedgeId Dcel::other_leaving(HalfedgeId h) const {
  HalfedgeId other = turn_right(h);
  if (other == twin(h)) other = turn_right(other);  // Both halves of a self-loop leave the vertex.
  return edge_of(other) == edge_of(h) ? HalfedgeId() : other;
}

/// Unlinks h from origin(h), and its twin, which arrives there.
void Dcel::detach(HalfedgeId h) {
  const HalfedgeId before = prev(h), after = next(twin(h));
  link(before, after);
}

/// After an edge at v was removed, gives v another half-edge, or the isolated loop l if v has no
/// edge left.
void Dcel::settle(VertexId v, HalfedgeId leaving, LoopId l) {
  if (leaving.is_valid()) {
    vertices_[v] = leaving;
  } else {
    vertices_[v] = l;
    loops_[l].first = v;
  }
}

/// The inverse of add_edge(). If the edge lies between two loops of one face, the loops are joined
/// into the loop of the twin. If both sides of the edge are on one loop, the loop is split, and the
/// part that begins with next(h) becomes a new loop.
void Dcel::remove_edge(HalfedgeId h) {
  PLUMB_CHECK(!has_pinches_ && contains(h) && face(h) == face(twin(h)));
  const HalfedgeId t = twin(h);
  const VertexId a = origin(h), b = origin(t);
  const HalfedgeId at_a = other_leaving(h), at_b = other_leaving(t);
  const HalfedgeId on_h = next(h), on_t = next(t);
  LoopId la = loop(t), lb = la;
  if (loop(h) != la) {
    relabel(next(h), h, la);
    drop_loop(loop(h));
    // If neither half-edge is left, settle() makes the loop of an isolated vertex.
    loops_[la].first = on_h != h ? on_h : on_t;
  } else {
    lb = new_loop(on_h, face(la));
    relabel(on_h, t, lb);
    loops_[la].first = on_t;
  }
  detach(h);
  detach(t);
  settle(a, at_a, la);
  settle(b, at_b, lb);
  halfedges_[h] = halfedges_[t] = {};
  --counts_.edges;
}

// --- vertices inside edges -----------------------------------------------------------------------

/// Half-edge h now ends at the new vertex w, and n leads on to the former target v. If h was the
/// last edge at v, n is followed by its own twin. Loops do not change, so no half-edge is
/// relabelled.
HalfedgeId Dcel::split_edge(HalfedgeId h) {
  PLUMB_CHECK(!has_pinches_ && contains(h));
  const HalfedgeId t = twin(h);
  const VertexId w(vertices_.size()), v = origin(t);
  const HalfedgeId n = new_edge(w, v), m = twin(n);
  vertices_.emplace_back(n);
  ++counts_.vertices;
  halfedges_[n].loop = loop(h);
  halfedges_[m].loop = loop(t);
  if (next(h) == t) {
    link(n, m);
  } else {
    link(n, next(h));
    link(prev(t), m);
  }
  link(h, n);
  link(m, t);
  halfedges_[t].origin = w;
  if (halfedge(v) == t) vertices_[v] = m;
  return n;
}

/// The inverse of split_edge(). Half-edge h replaces both edges, and references to the removed
/// half-edges are replaced by references to the half-edges of h.
void Dcel::join_edge(HalfedgeId n) {
  PLUMB_CHECK(!has_pinches_ && contains(n));
  const HalfedgeId h = prev(n), t = twin(h), m = twin(n);
  PLUMB_CHECK(edge_of(h) != edge_of(n) && next(m) == t);
  const VertexId w = origin(n), v = origin(m);
  if (next(n) == m) {
    link(h, t);
  } else {
    link(h, next(n));
    link(prev(m), t);
  }
  halfedges_[t].origin = v;
  if (halfedge(v) == m) vertices_[v] = t;
  if (first(loop(n)) == Corner(n)) loops_[loop(n)].first = h;
  if (first(loop(m)) == Corner(m)) loops_[loop(m)].first = t;
  halfedges_[n] = halfedges_[m] = {};
  vertices_[w] = {};
  --counts_.edges;
  --counts_.vertices;
}

}  // namespace plumb
