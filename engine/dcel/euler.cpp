// The Euler operators of Dcel. Each moves the half-edges first and settles loops and vertices
// after; the names h, t are the new or removed edge: h leaves corner a, t = twin(h) leaves corner
// b.
#include <algorithm>

#include "plumb/base/error.h"
#include "plumb/dcel/dcel.h"

namespace plumb {

// --- faces, loops, isolated vertices -----------------------------------------------------------

FaceId Dcel::add_face() {
  faces_.emplace_back();
  ++counts_.faces;
  return FaceId(faces_.size() - 1);
}

void Dcel::remove_face(FaceId f) {
  PLUMB_CHECK(contains(f) && !first_loop(f).is_valid());
  faces_[f.value()] = kRemoved;
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
  vertices_[v.value()] = {};
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
  loops_[l.value()] = {};
  --counts_.loops;
}

/// Appends l to the ring of f's loops.
void Dcel::enter_face(LoopId l, FaceId f) {
  Loop& loop = loops_[l.value()];
  loop.face = f;
  LoopId& first = faces_[f.value()];
  if (!first.is_valid()) first = loop.next = loop.prev = l;
  loop.next = first;
  loop.prev = std::exchange(loops_[first.value()].prev, l);
  loops_[loop.prev.value()].next = l;
}

void Dcel::leave_face(LoopId l) {
  const Loop loop = loops_[l.value()];
  LoopId& first = faces_[loop.face.value()];
  if (first == l) first = loop.next == l ? LoopId() : loop.next;
  loops_[loop.prev.value()].next = loop.next;
  loops_[loop.next.value()].prev = loop.prev;
}

FaceId Dcel::split_face(std::span<const LoopId> loops) {
  PLUMB_CHECK(!loops.empty() && contains(loops.front()));
  const FaceId old = face(loops.front());
  const FaceId f = add_face();
  for (const LoopId l : loops) {
    PLUMB_CHECK(contains(l) && face(l) == old);  // a loop named twice has left already
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

/// Lets h leave corner `at`, its twin arrive there.
void Dcel::attach(HalfedgeId h, Corner at) {
  if (!at.is_halfedge()) return link(twin(h), h);
  link(prev(at.halfedge()), h);
  link(twin(h), at.halfedge());
}

/// h alone becomes a loop; its twin runs round it.
void Dcel::attach_self_loop(HalfedgeId h, Corner at) {
  attach(twin(h), at);
  if (at.is_halfedge())
    link(twin(h), at.halfedge());
  else
    link(twin(h), twin(h));
  link(h, h);
}

/// Labels the half-edges from `from` up to, without, `stop`.
void Dcel::relabel(HalfedgeId from, HalfedgeId stop, LoopId l) {
  for (HalfedgeId h = from; h != stop; h = next(h)) halfedges_[h.value()].loop = l;
}

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
  if (!a.is_halfedge()) vertices_[a.other().value()] = h;
  if (!b.is_halfedge()) vertices_[b.other().value()] = b == a ? h : t;
  if (la == lb) {
    const LoopId l = new_loop(h, face(la));
    halfedges_[h.value()].loop = l;
    relabel(next(h), h, l);
  } else {
    drop_loop(lb);
    relabel(h, t, la);
  }
  halfedges_[t.value()].loop = la;
  loops_[la.value()].first = t;
  return h;
}

/// A half-edge leaving origin(h) that is not of h's edge; invalid if there is none.
HalfedgeId Dcel::other_leaving(HalfedgeId h) const {
  HalfedgeId other = turn_right(h);
  if (other == twin(h)) other = turn_right(other);  // a self-loop: both its halves leave
  return edge_of(other) == edge_of(h) ? HalfedgeId() : other;
}

/// Takes h away from origin(h), and its twin, that arrives there.
void Dcel::detach(HalfedgeId h) {
  const HalfedgeId before = prev(h), after = next(twin(h));
  link(before, after);
}

/// After an edge at v is gone: v's half-edge, or its isolated loop l if it has none.
void Dcel::settle(VertexId v, HalfedgeId leaving, LoopId l) {
  if (leaving.is_valid()) {
    vertices_[v.value()] = leaving;
  } else {
    vertices_[v.value()] = l;
    loops_[l.value()].first = v;
  }
}

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
    loops_[la.value()].first = on_h != h ? on_h : on_t;  // neither: settle() says isolated
  } else {
    lb = new_loop(on_h, face(la));
    relabel(on_h, t, lb);
    loops_[la.value()].first = on_t;
  }
  detach(h);
  detach(t);
  settle(a, at_a, la);
  settle(b, at_b, lb);
  halfedges_[h.value()] = halfedges_[t.value()] = {};
  --counts_.edges;
}

// --- vertices inside edges -----------------------------------------------------------------------

HalfedgeId Dcel::split_edge(HalfedgeId h) {
  PLUMB_CHECK(!has_pinches_ && contains(h));
  const HalfedgeId t = twin(h);
  const VertexId w(vertices_.size()), v = origin(t);
  const HalfedgeId n = new_edge(w, v), m = twin(n);
  vertices_.emplace_back(n);
  ++counts_.vertices;
  halfedges_[n.value()].loop = loop(h);
  halfedges_[m.value()].loop = loop(t);
  if (next(h) == t) {
    link(n, m);
  } else {
    link(n, next(h));
    link(prev(t), m);
  }
  link(h, n);
  link(m, t);
  halfedges_[t.value()].origin = w;
  if (halfedge(v) == t) vertices_[v.value()] = m;
  return n;
}

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
  halfedges_[t.value()].origin = v;
  if (halfedge(v) == m) vertices_[v.value()] = t;
  if (first(loop(n)) == Corner(n)) loops_[loop(n).value()].first = h;
  if (first(loop(m)) == Corner(m)) loops_[loop(m).value()].first = t;
  halfedges_[n.value()] = halfedges_[m.value()] = {};
  vertices_[w.value()] = {};
  --counts_.edges;
  --counts_.vertices;
}

}  // namespace plumb
