// The half-edge structure shared by plane, sphere and surface maps (a doubly connected edge list).
//
// Topology only: no coordinates here; geometry and marks are parallel arrays of the owner, indexed
// by VertexId, EdgeId, FaceId. Half-edges come in pairs: edge e has half-edges 2e and 2e+1, twin =
// xor 1.
//
//   half-edge h : origin(h), next(h), prev(h), loop(h); its face lies to its left
//   loop l      : one boundary cycle of a face: first half-edge, or an isolated vertex; next
//                 loop of the same face
//   face f      : first loop (which loop is the outer one is geometry, known to the owner)
//   vertex v    : one half-edge leaving it, or its isolated loop
//   corner      : a place at a vertex inside a face, where an edge can be attached: the one just
//                 before half-edge h, at origin(h); or the only one of an isolated vertex
//
// A half-edge knows its loop, a loop its face: merging two faces touches loops, not half-edges.
//
// Building (1) and editing (2):
//  1. Dcel::from_cycles      listed cycles of vertex ids, every directed edge used once, with
//                            its twin
//     Dcel::from_links       half-edges that already know their next
//  2. Euler operators, each undone by its partner:
//     add_face/remove_face              a face without any loop (a whole plane or sphere)
//     add_vertex/remove_vertex          an isolated vertex in a face
//     add_edge/remove_edge              between two corners: within a loop splits the loop, between
//                                       two loops of one face joins them
//     split_edge/join_edge              a vertex of degree 2 inside an edge
//     split_face/join_faces             moves chosen loops into a new face and back
//  3. audit                             every invariant from scratch
//
// Deleted elements leave holes until compact(): ids stay valid, new ones are appended, so parallel
// arrays only ever grow by push_back. All operations O(1) unless said otherwise. Operators stop the
// program (PLUMB_CHECK) when their precondition does not hold.
//
// A pinch is a vertex whose half-edges form several rings: listed cycles may touch at a vertex
// without passing through each other. from_cycles keeps such a vertex as listed; the operators
// require a structure without pinches, because a vertex knows one of its rings only.
//
// Memory: 16 bytes a half-edge, 16 a loop, 4 a vertex, 4 a face. At most 2^31 - 2 half-edges.
// Source: Muller and Preparata 1978; Mäntylä's Euler operators.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plumb/base/ids.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The other direction of the same edge.
constexpr HalfedgeId twin(HalfedgeId h) { return HalfedgeId(h.value() ^ 1U); }
/// The edge that it is a direction of.
constexpr EdgeId edge_of(HalfedgeId h) { return EdgeId(h.value() >> 1U); }
/// The direction of an edge with the even id.
constexpr HalfedgeId first_half(EdgeId e) { return HalfedgeId(e.value() << 1U); }

/// A half-edge or, told by the top bit, an `Other`; or neither.
template <class Other>
class HalfedgeOr {
 public:
  constexpr HalfedgeOr() = default;
  constexpr HalfedgeOr(HalfedgeId h) : bits_(h.value()) {}               ///< A half-edge.
  constexpr HalfedgeOr(Other other) : bits_(other.value() | kTopBit) {}  ///< The other kind.

  constexpr bool is_valid() const { return bits_ != HalfedgeId::kInvalid; }  ///< Is it either?
  /// Is it a half-edge? Requires is_valid().
  constexpr bool is_halfedge() const { return (bits_ & kTopBit) == 0; }
  /// Is it valid and no half-edge?
  constexpr bool is_other() const { return is_valid() && !is_halfedge(); }
  /// The half-edge; invalid if this is none.
  constexpr HalfedgeId halfedge() const { return is_halfedge() ? HalfedgeId(bits_) : HalfedgeId(); }
  /// The other; invalid if this is none.
  constexpr Other other() const { return is_other() ? Other(bits_ & ~kTopBit) : Other(); }
  friend constexpr bool operator==(HalfedgeOr, HalfedgeOr) = default;

 private:
  static constexpr std::uint32_t kTopBit = std::uint32_t{1} << 31U;
  std::uint32_t bits_ = HalfedgeId::kInvalid;
};

/// A place where an edge can be attached: before a half-edge, or at an isolated vertex.
using Corner = HalfedgeOr<VertexId>;

/// A closed chain of ids, walked once: for (HalfedgeId h : dcel.along(l)). No allocation. The
/// structure must not be edited while it is walked.
template <class Id, class Step>
class Ring {
 public:
  /// Ends where it began.
  class Iterator {
   public:
    using value_type = Id;                   ///< of the standard's iterators
    using difference_type = std::ptrdiff_t;  ///< of the standard's iterators
    Iterator() = default;
    Iterator(Id first, Step step) : at_(first), first_(first), step_(step) {}  ///< At the first id.
    Id operator*() const { return at_; }                                       ///< Where it is.
    /// To the next id; after the last, to the end.
    Iterator& operator++() {
      at_ = step_(at_);
      if (at_ == first_) at_ = Id();
      return *this;
    }
    /// The same; gives where it was.
    Iterator operator++(int) {
      Iterator old = *this;
      ++*this;
      return old;
    }
    friend bool operator==(const Iterator& i, std::default_sentinel_t) { return !i.at_.is_valid(); }

   private:
    Id at_, first_;
    Step step_;
  };

  /// The chain first, step(first), ...; none for an invalid first.
  Ring(Id first, Step step) : first_(first), step_(step) {}
  Iterator begin() const { return {first_, step_}; }  ///< At the first id.
  std::default_sentinel_t end() const { return {}; }  ///< What every walk ends with.

 private:
  Id first_;
  Step step_;
};

/// Where each element went: new id by old id, invalid where there was a hole. Order is kept.
struct DcelCompaction {
  std::vector<VertexId> vertex;  ///< per old vertex
  std::vector<EdgeId> edge;      ///< per old edge
  std::vector<LoopId> loop;      ///< per old loop
  std::vector<FaceId> face;      ///< per old face

  /// The new half-edge in the old one's direction; invalid if its edge is gone.
  HalfedgeId halfedge(HalfedgeId old) const {
    const EdgeId e = edge[edge_of(old).value()];
    return e.is_valid() ? HalfedgeId(first_half(e).value() | (old.value() & 1U)) : HalfedgeId();
  }
};

/// Moves an owner's parallel array along: `new_ids` is the matching member of DcelCompaction.
template <class Id, class T>
void follow(const std::vector<Id>& new_ids, std::vector<T>& payload) {
  std::size_t kept = 0;
  for (std::size_t old = 0; old < new_ids.size(); ++old) {
    if (!new_ids[old].is_valid()) continue;
    if (kept != old) payload[kept] = std::move(payload[old]);
    ++kept;
  }
  payload.erase(payload.begin() + static_cast<std::ptrdiff_t>(kept), payload.end());
}

/// A broken invariant: which, and at which element.
struct DcelFlaw {
  std::string invariant;  ///< what does not hold
  std::string place;      ///< such as "half-edge 7"
};

struct DcelFromCycles;

/// Vertices, half-edges, loops and faces, without coordinates.
class Dcel {
 public:
  /// The empty structure: not even a face.
  Dcel() = default;

  /// An isolated vertex and the face in which it lies.
  struct IsolatedVertex {
    VertexId vertex;  ///< a vertex without edges
    FaceId face;      ///< where it lies
  };

  /// Builds the structure of listed cycles. Corner position p stands for the directed edge from
  /// corners[p] to the next corner of its cycle.
  ///   cycle_begin    cycle c is corners[cycle_begin[c], cycle_begin[c+1])
  ///   twin           twin[p]: the position of the opposite directed edge
  ///   face_of_cycle  several cycles may share a face; faces are 0..max
  ///   isolated       vertices without edges; one that is in no cycle and not listed here is a
  ///                  hole of the numbering (contains() is false)
  /// Cycle c becomes loop c; isolated vertices become the loops after them; loops of a face are in
  /// this order. The first half-edge of a vertex is the one at its lowest corner position. Edges
  /// are numbered by their lower corner position, which gets the even half-edge.
  /// Requires twin to be an involution without fixed points that joins opposite directed edges,
  /// no empty cycle, ids in range (all checked). O(n).
  static DcelFromCycles from_cycles(std::size_t vertex_count,
                                    std::span<const std::uint32_t> corners,
                                    std::span<const std::uint32_t> cycle_begin,
                                    std::span<const std::uint32_t> twin,
                                    std::span<const std::uint32_t> face_of_cycle,
                                    std::span<const IsolatedVertex> isolated = {});

  /// Builds the structure of linked half-edges, keeping all ids.
  ///   origin        per half-edge; twins are 2e and 2e + 1
  ///   next          per half-edge
  ///   loop_of       per half-edge: its loop, one for each closed chain of next
  ///   face_of_loop  per loop; loops are 0..max and so are faces
  ///   isolated      vertices without edges; they become the loops after the others
  /// The first half-edge of a loop and of a vertex is its least. Requires ids in range, next to end
  /// where its half-edge's twin begins (checked), and equal loops along next. O(n).
  static Dcel from_links(std::size_t vertex_count, std::span<const VertexId> origin,
                         std::span<const HalfedgeId> next, std::span<const std::uint32_t> loop_of,
                         std::span<const FaceId> face_of_loop,
                         std::span<const IsolatedVertex> isolated = {});

  // --- reading -------------------------------------------------------------------------------

  /// Where a half-edge begins.
  VertexId origin(HalfedgeId h) const { return halfedges_[h.value()].origin; }
  VertexId target(HalfedgeId h) const { return origin(twin(h)); }  ///< Where a half-edge ends.
  /// The half-edge after it along the face to its left.
  HalfedgeId next(HalfedgeId h) const { return halfedges_[h.value()].next; }
  /// The half-edge before it along the face to its left.
  HalfedgeId prev(HalfedgeId h) const { return halfedges_[h.value()].prev; }
  /// The boundary cycle that a half-edge is part of.
  LoopId loop(HalfedgeId h) const { return halfedges_[h.value()].loop; }
  FaceId face(LoopId l) const { return loops_[l.value()].face; }  ///< The face that a loop bounds.
  FaceId face(HalfedgeId h) const { return face(loop(h)); }       ///< The face to the left.

  /// A half-edge leaving v; invalid if v is isolated.
  HalfedgeId halfedge(VertexId v) const { return vertices_[v.value()].halfedge(); }
  /// Has it no half-edge?
  bool is_isolated(VertexId v) const { return vertices_[v.value()].is_other(); }
  /// The loop of an isolated vertex; invalid otherwise.
  LoopId isolated_loop(VertexId v) const { return vertices_[v.value()].other(); }
  /// Where a loop begins: a half-edge or an isolated vertex.
  Corner first(LoopId l) const { return loops_[l.value()].first; }
  /// Invalid if f has no loop.
  LoopId first_loop(FaceId f) const {
    const LoopId l = faces_[f.value()];
    return l == kRemoved ? LoopId() : l;
  }
  /// The vertex that a corner is at.
  VertexId vertex_at(Corner c) const { return c.is_halfedge() ? origin(c.halfedge()) : c.other(); }
  /// The loop that a corner is part of.
  LoopId loop_at(Corner c) const {
    return c.is_halfedge() ? loop(c.halfedge()) : isolated_loop(c.other());
  }

  /// The next half-edge leaving origin(h), counter-clockwise.
  HalfedgeId turn_left(HalfedgeId h) const { return twin(prev(h)); }
  /// The next half-edge leaving origin(h), clockwise.
  HalfedgeId turn_right(HalfedgeId h) const { return next(twin(h)); }

  /// Half-edges of a loop, in their direction; none for an isolated vertex.
  auto along(LoopId l) const { return ring<&Dcel::next>(first(l).halfedge()); }
  /// Half-edges leaving v counter-clockwise (at a pinch: one ring of them).
  auto around(VertexId v) const { return ring<&Dcel::turn_left>(halfedge(v)); }
  /// Loops of a face.
  auto loops_of(FaceId f) const { return ring<&Dcel::next_loop>(first_loop(f)); }
  /// The loop after it in the ring of its face.
  LoopId next_loop(LoopId l) const { return loops_[l.value()].next; }

  std::size_t vertex_count() const { return counts_.vertices; }  ///< Present vertices.
  /// Present half-edges: twice the edges.
  std::size_t halfedge_count() const { return 2 * counts_.edges; }
  std::size_t edge_count() const { return counts_.edges; }  ///< Present edges.
  std::size_t loop_count() const { return counts_.loops; }  ///< Present loops.
  std::size_t face_count() const { return counts_.faces; }  ///< Present faces.

  /// Ids run from 0 to slots - 1, holes included; parallel arrays have this size.
  std::size_t vertex_slots() const { return vertices_.size(); }
  std::size_t halfedge_slots() const { return halfedges_.size(); }  ///< The same for half-edges.
  std::size_t edge_slots() const { return halfedges_.size() / 2; }  ///< The same for edges.
  std::size_t loop_slots() const { return loops_.size(); }          ///< The same for loops.
  std::size_t face_slots() const { return faces_.size(); }          ///< The same for faces.

  /// Is it present: in range, and not removed?
  bool contains(VertexId v) const {
    return v.value() < vertices_.size() && vertices_[v.value()].is_valid();
  }
  /// Is it present: in range, and not removed?
  bool contains(HalfedgeId h) const {
    return h.value() < halfedges_.size() && halfedges_[h.value()].origin.is_valid();
  }
  /// Is it present: in range, and not removed?
  bool contains(EdgeId e) const { return e.is_valid() && contains(first_half(e)); }
  /// Is it present: in range, and not removed?
  bool contains(LoopId l) const {
    return l.value() < loops_.size() && loops_[l.value()].first.is_valid();
  }
  /// Is it present: in range, and not removed?
  bool contains(FaceId f) const {
    return f.value() < faces_.size() && faces_[f.value()] != kRemoved;
  }

  /// Is there a vertex whose half-edges form several rings?
  bool has_pinches() const { return has_pinches_; }

  // --- Euler operators (all require !has_pinches()) --------------------------------------------

  FaceId add_face();  ///< A new face without any loop.
  /// Requires: no loops.
  void remove_face(FaceId f);

  /// An isolated vertex: a new loop of f.
  VertexId add_vertex(FaceId f);
  /// Requires: isolated.
  void remove_vertex(VertexId v);

  /// A new edge from vertex_at(a) to vertex_at(b); returns its even half-edge h, which runs that
  /// way. Requires both corners in one face.
  ///   one loop   splits it: left of h lies a new loop of the same face, from b round to a (a == b:
  ///              h alone, a self-loop); twin(h) stays in the old one. O(length of the new loop)
  ///   two loops  become one, which keeps the id of a's. O(length of b's)
  HalfedgeId add_edge(Corner a, Corner b);
  /// Requires the same face on both sides (join_faces first).
  ///   two loops  become one, which keeps the id of twin(h)'s. O(length of h's)
  ///   one loop   falls in two: the part at origin(h) keeps the id, the part at target(h) gets a
  ///              new one; a part without half-edges is an isolated vertex. O(length at target(h))
  void remove_edge(HalfedgeId h);

  /// Puts a new vertex w on h: h then ends at w and its successor, which is returned, leads on to
  /// the old target. twin(h) starts at w.
  HalfedgeId split_edge(HalfedgeId h);
  /// Undoes split_edge: removes h, its twin and origin(h); prev(h) then ends at target(h).
  /// Requires a vertex with exactly two half-edges, of different edges.
  void join_edge(HalfedgeId h);

  /// A new face that takes over `loops`, in this order. Requires distinct loops of one face.
  /// O(number of loops).
  FaceId split_face(std::span<const LoopId> loops);
  /// Gives all loops of `gone` to `kept` (behind its own) and removes `gone`. Requires distinct
  /// faces. O(number of loops of `gone`).
  void join_faces(FaceId kept, FaceId gone);

  /// Closes the holes of all numberings, keeping their order. Owners let their arrays follow():
  /// follow(compaction.vertex, coordinates). O(n).
  DcelCompaction compact();

  // --- auditing ------------------------------------------------------------------------------

  /// Checks every invariant from scratch; names the first one broken and where. Works on any
  /// content of the arrays. O(n).
  ///   sizes, ranges     ids of present elements name present elements; counts agree
  ///   next/prev         inverse of each other; target(h) = origin(next(h))
  ///   loop              exactly one closed chain of next per loop, labelled with it
  ///   vertex            its half-edge leaves it, or its isolated loop begins with it
  ///   pinches           rings around vertices as has_pinches() says
  ///   face              its loops form one ring, and each knows it
  std::optional<DcelFlaw> audit() const;

  /// Is it a map of the plane or sphere? A component is a set of edges connected by next and twin
  /// (fans that only share a pinch are different ones), or an isolated vertex; a ring is one fan of
  /// half-edges around a vertex, or an isolated vertex. For each component rings - edges + loops =
  /// 2; and faces and components, joined by loops, form a tree. So V - E + F = 1 + components
  /// without pinches. Requires a clean audit(). O(n a(n)), a the inverse Ackermann function.
  std::optional<DcelFlaw> audit_planar() const;

 private:
  friend class DcelAudit;
  friend class DcelSurgeon;  // tests break arrays on purpose through it

  struct Halfedge {
    VertexId origin;  ///< invalid: removed
    HalfedgeId next, prev;
    LoopId loop;
  };
  struct Loop {
    Corner first;  ///< invalid: removed
    FaceId face;
    LoopId next, prev;  ///< ring of the loops of a face
  };
  struct Counts {
    std::size_t vertices = 0, edges = 0, loops = 0, faces = 0;
    friend bool operator==(const Counts&, const Counts&) = default;
  };
  static constexpr LoopId kRemoved{LoopId::kInvalid - 1};

  template <auto Move>
  struct Step {
    const Dcel* dcel = nullptr;
    auto operator()(auto id) const { return (dcel->*Move)(id); }
  };
  template <auto Move, class Id>
  Ring<Id, Step<Move>> ring(Id first) const {
    return {first, Step<Move>{this}};
  }

  void fill_cycle(LoopId l, std::span<const std::uint32_t> vertices, const HalfedgeId* halfedges);
  void link_halfedges(std::span<const VertexId> origin, std::span<const HalfedgeId> next,
                      std::span<const std::uint32_t> loop_of);
  void place_isolated(std::span<const IsolatedVertex> isolated);
  void check_targets() const;
  bool find_pinches() const;

  HalfedgeId new_edge(VertexId from, VertexId to);
  LoopId new_loop(Corner first, FaceId f);
  void drop_loop(LoopId l);
  void enter_face(LoopId l, FaceId f);
  void leave_face(LoopId l);
  void link(HalfedgeId a, HalfedgeId b) {
    halfedges_[a.value()].next = b;
    halfedges_[b.value()].prev = a;
  }
  bool is_corner(Corner c) const;
  void attach(HalfedgeId h, Corner at);
  void attach_self_loop(HalfedgeId h, Corner at);
  void detach(HalfedgeId h);
  void relabel(HalfedgeId from, HalfedgeId stop, LoopId l);
  void settle(VertexId v, HalfedgeId leaving, LoopId l);
  HalfedgeId other_leaving(HalfedgeId h) const;

  std::vector<Halfedge> halfedges_;
  std::vector<HalfedgeOr<LoopId>> vertices_;  ///< invalid: removed
  std::vector<Loop> loops_;
  std::vector<LoopId> faces_;  ///< first loop; invalid: none; kRemoved: removed
  Counts counts_;
  bool has_pinches_ = false;
};

/// What from_cycles returns: the structure, and the half-edge of each corner position.
struct DcelFromCycles {
  Dcel dcel;  ///< the structure
  /// Per corner position: the half-edge that stands for it.
  std::vector<HalfedgeId> halfedge_of_corner;
};

}  // namespace plumb
#pragma GCC visibility pop
