// Doubly connected edge list (half-edge structure), shared by plane, sphere and surface maps.
//
// The structure stores topology only. The owner of the structure, such as a planar map, keeps
// geometry and marks in parallel arrays, indexed by VertexId, EdgeId and FaceId. Edge e consists of
// the half-edges 2 e and 2 e + 1. Therefore the ids of twins differ only in the lowest bit.
//
//   half-edge h : has origin(h), next(h), prev(h) and loop(h); its face lies to its left
//   loop l      : is one boundary cycle of a face, or an isolated vertex in a face. A loop refers
//                 to its first half-edge or to its isolated vertex. A loop also refers to its face,
//                 and to the next loop of this face
//   face f      : refers to its first loop. The structure does not know which loop is the outer
//                 loop, because this depends on the geometry. Only the owner knows the
//                 outer loop
//   vertex v    : refers to one half-edge that leaves v; an isolated vertex refers to its loop
//   corner      : is a position at a vertex, inside a face, where an edge can be attached. A corner
//                 at a half-edge h lies at origin(h), just before h on the loop of h. An isolated
//                 vertex has only one corner.
//
// A half-edge refers to its loop, and a loop refers to its face. Therefore merging two faces
// changes loops, but no half-edges.
//
// Main flow:
//  1. Building
//     Dcel::from_cycles      takes listed cycles of vertex ids. Every edge must occur in the cycles
//                            exactly twice, once in each direction
//     Dcel::from_links       takes half-edges with known successors
//  2. Editing by Euler operators. The two operators of each pair undo each other
//     add_face/remove_face       add and remove a face without loops (a whole plane or sphere)
//     add_vertex/remove_vertex   add and remove an isolated vertex in a face
//     add_edge/remove_edge       add and remove an edge between two corners. If both corners lie in
//                                the same loop, the new edge splits this loop. Otherwise the new
//                                edge joins the two loops
//     split_edge/join_edge       insert and remove a vertex of degree 2 inside an edge
//     split_face/join_faces      move chosen loops into a new face, and move them back
//  3. audit                      checks every invariant from scratch
//
// Removed cells leave holes in the numbering until compact() is called. The ids of all cells that
// are not removed stay valid. A new cell gets the next id after all ids of its kind. So the owner
// can append the entry of the new cell to its parallel array by push_back. All operations take O(1)
// time unless stated otherwise. In the comments on costs, n is the number of half-edges, vertices
// and faces together. If an operator finds that a precondition is violated, the operator reports a
// broken invariant (PLUMB_CHECK in error.h).
//
// The half-edges that leave a vertex form a ring in counter-clockwise order. A pinch is a vertex
// whose half-edges form several rings. A pinch arises if listed cycles touch at a vertex without
// passing through each other. from_cycles keeps pinches. The operators require a structure without
// pinches, because a vertex refers to only one of its rings.
//
// Memory: 16 bytes for each half-edge, 16 for each loop, 4 for each vertex, and 4 for each face. A
// structure has at most 2^31 - 2 half-edges. Sources: D. E. Muller and F. P. Preparata, Finding the
// intersection of two convex polyhedra, Theoretical Computer Science 7 (1978); M. Mäntylä, An
// Introduction to Solid Modeling, Computer Science Press (1988), for the Euler operators.
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

/// Returns the other half-edge of the same edge.
constexpr HalfedgeId twin(HalfedgeId h) { return HalfedgeId(h.value() ^ 1U); }
/// Returns the edge of a half-edge.
constexpr EdgeId edge_of(HalfedgeId h) { return EdgeId(h.value() >> 1U); }
/// Returns the half-edge with the even id of an edge.
constexpr HalfedgeId first_half(EdgeId e) { return HalfedgeId(e.value() << 1U); }

/// The id of a half-edge, an id of type `Other`, or no id. The top bit of the stored number
/// distinguishes the two kinds of ids.
template <class Other>
class HalfedgeOr {
 public:
  constexpr HalfedgeOr() = default;
  constexpr HalfedgeOr(HalfedgeId h) : bits_(h.value()) {}               ///< Holds a half-edge.
  constexpr HalfedgeOr(Other other) : bits_(other.value() | kTopBit) {}  ///< Holds an `Other`.

  constexpr bool is_valid() const {
    return bits_ != HalfedgeId::kInvalid;
  }  ///< Whether the object holds an id.
  /// Whether the object holds a half-edge. Requires is_valid().
  constexpr bool is_halfedge() const { return (bits_ & kTopBit) == 0; }
  /// Whether the object holds an `Other`.
  constexpr bool is_other() const { return is_valid() && !is_halfedge(); }
  /// Returns the half-edge, or an invalid id if the object holds no half-edge.
  constexpr HalfedgeId halfedge() const { return is_halfedge() ? HalfedgeId(bits_) : HalfedgeId(); }
  /// Returns the `Other`, or an invalid id if the object holds no `Other`.
  constexpr Other other() const { return is_other() ? Other(bits_ & ~kTopBit) : Other(); }
  friend constexpr bool operator==(HalfedgeOr, HalfedgeOr) = default;

 private:
  static constexpr std::uint32_t kTopBit = std::uint32_t{1} << 31U;
  std::uint32_t bits_ = HalfedgeId::kInvalid;
};

/// A position where an edge can be attached. A corner is given by the half-edge that follows the
/// corner, or by an isolated vertex.
using Corner = HalfedgeOr<VertexId>;

/// A range that visits each id of a closed chain once, as in for (HalfedgeId h : dcel.along(l)).
/// The range allocates no memory. The structure must not be edited during the iteration.
template <class Id, class Step>
class Ring {
 public:
  /// Iterator that stops when it reaches the first id again.
  class Iterator {
   public:
    using value_type = Id;                   ///< A member that every iterator must have.
    using difference_type = std::ptrdiff_t;  ///< A member that every iterator must have.
    Iterator() = default;
    Iterator(Id first, Step step)
        : at_(first), first_(first), step_(step) {}  ///< Starts at `first`.
    Id operator*() const { return at_; }             ///< Returns the current id.
    /// Advances to the next id, or from the last id to the end.
    Iterator& operator++() {
      at_ = step_(at_);
      if (at_ == first_) at_ = Id();
      return *this;
    }
    /// Advances to the next id, and returns the iterator as it was before this step.
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

  /// Constructs the range first, step(first), step(step(first)), and so on. The range is empty if
  /// `first` is invalid.
  Ring(Id first, Step step) : first_(first), step_(step) {}
  Iterator begin() const { return {first_, step_}; }  ///< Returns an iterator to the first id.
  std::default_sentinel_t end() const { return {}; }  ///< Returns the end of the range.

 private:
  Id first_;
  Step step_;
};

/// The new ids after compact(). Each array is indexed by old ids and contains new ids. The entry of
/// a removed cell is the invalid id. The new ids are in the same order as the old ids.
struct DcelCompaction {
  IdVector<VertexId, VertexId> vertex;  ///< New id of each old vertex.
  IdVector<EdgeId, EdgeId> edge;        ///< New id of each old edge.
  IdVector<LoopId, LoopId> loop;        ///< New id of each old loop.
  IdVector<FaceId, FaceId> face;        ///< New id of each old face.

  /// Returns the new id of the half-edge `old`, or an invalid id if its edge was removed. The new
  /// half-edge has the same direction.
  HalfedgeId halfedge(HalfedgeId old) const {
    const EdgeId e = edge[edge_of(old)];
    return e.is_valid() ? HalfedgeId(first_half(e).value() | (old.value() & 1U)) : HalfedgeId();
  }
};

/// Compacts `payload`, an array of the owner with one entry for each cell of one kind. `new_ids` is
/// the member of DcelCompaction for this kind of cell. Requires that `payload` has one entry for
/// each old id. Cost: O(n).
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

/// A violated invariant and the cell at which it is violated.
struct DcelFlaw {
  std::string invariant;  ///< The invariant.
  std::string place;      ///< The cell, such as "half-edge 7".
};

struct DcelFromCycles;

/// Vertices, half-edges, loops and faces, without coordinates.
class Dcel {
 public:
  /// Constructs an empty structure, without any face.
  Dcel() = default;

  /// An isolated vertex and the face in which it lies.
  struct IsolatedVertex {
    VertexId vertex;  ///< A vertex without edges.
    FaceId face;      ///< The face that contains it.
  };

  /// Builds a structure from listed cycles. Corner position p represents the directed edge from
  /// corners[p] to the next corner of its cycle.
  ///   cycle_begin    the corners of cycle c have the positions from cycle_begin[c] to
  ///                  cycle_begin[c+1] - 1
  ///   twin           twin[p] is the position of the opposite directed edge
  ///   face_of_cycle  the face of each cycle; several cycles may share a face; the structure gets
  ///                  all faces from 0 to the largest id in this array
  ///   isolated       vertices without edges; a vertex id that occurs neither in a cycle nor in
  ///                  this array is a hole of the numbering (contains() returns false)
  /// Cycle c becomes loop c. The loops of the isolated vertices have the ids after the loops of the
  /// cycles. The loops of a face are ordered by their ids. A vertex stores the half-edge that has
  /// the lowest corner position among those that leave the vertex. Each edge has two corner
  /// positions. Edges are numbered in the order of the lower of these positions, and the half-edge
  /// at the lower position gets the even id. The function requires and checks the following
  /// conditions:
  ///   - twin is an involution without fixed points that pairs opposite directed edges;
  ///   - no cycle is empty;
  ///   - all ids are in range.
  /// Cost: O(n).
  static DcelFromCycles from_cycles(std::size_t vertex_count,
                                    std::span<const std::uint32_t> corners,
                                    std::span<const std::uint32_t> cycle_begin,
                                    std::span<const std::uint32_t> twin,
                                    std::span<const std::uint32_t> face_of_cycle,
                                    std::span<const IsolatedVertex> isolated = {});

  /// Builds a structure from linked half-edges and keeps all ids.
  ///   origin        the origin of each half-edge; the half-edges 2 e and 2 e + 1 are twins
  ///   next          the successor of each half-edge
  ///   loop_of       the loop of each half-edge; each closed chain of `next` is one loop
  ///   face_of_loop  the face of each loop; the ids of loops and of faces are numbered from 0
  ///                 without gaps
  ///   isolated      vertices without edges; their loops have the ids after the other loops
  /// A loop or a vertex stores its half-edge with the least id. Requires that all ids are in range
  /// and that next(h) begins where twin(h) begins. The function checks these two conditions. The
  /// function also requires that all half-edges of a chain of `next` have the same entry in
  /// `loop_of`, but does not check this condition. Cost: O(n).
  static Dcel from_links(std::size_t vertex_count, std::span<const VertexId> origin,
                         std::span<const HalfedgeId> next, std::span<const std::uint32_t> loop_of,
                         std::span<const FaceId> face_of_loop,
                         std::span<const IsolatedVertex> isolated = {});

  // --- reading -------------------------------------------------------------------------------

  /// Returns the vertex where a half-edge begins.
  VertexId origin(HalfedgeId h) const { return halfedges_[h].origin; }
  VertexId target(HalfedgeId h) const {
    return origin(twin(h));
  }  ///< Returns the vertex where a half-edge ends.
  /// Returns the next half-edge along the face to its left.
  HalfedgeId next(HalfedgeId h) const { return halfedges_[h].next; }
  /// Returns the previous half-edge along the face to its left.
  HalfedgeId prev(HalfedgeId h) const { return halfedges_[h].prev; }
  /// Returns the loop that contains a half-edge.
  LoopId loop(HalfedgeId h) const { return halfedges_[h].loop; }
  FaceId face(LoopId l) const { return loops_[l].face; }     ///< Returns the face of a loop.
  FaceId face(HalfedgeId h) const { return face(loop(h)); }  ///< Returns the face to the left.

  /// Returns a half-edge that leaves v, or an invalid id if v is isolated.
  HalfedgeId halfedge(VertexId v) const { return vertices_[v].halfedge(); }
  /// Whether v is an isolated vertex.
  bool is_isolated(VertexId v) const { return vertices_[v].is_other(); }
  /// Returns the loop of an isolated vertex, or an invalid id for other vertices.
  LoopId isolated_loop(VertexId v) const { return vertices_[v].other(); }
  /// Returns the beginning of a loop: a half-edge or an isolated vertex.
  Corner first(LoopId l) const { return loops_[l].first; }
  /// Returns the first loop of f, or an invalid id if f has no loop.
  LoopId first_loop(FaceId f) const {
    const LoopId l = faces_[f];
    return l == kRemoved ? LoopId() : l;
  }
  /// Returns the vertex of a corner.
  VertexId vertex_at(Corner c) const { return c.is_halfedge() ? origin(c.halfedge()) : c.other(); }
  /// Returns the loop of a corner.
  LoopId loop_at(Corner c) const {
    return c.is_halfedge() ? loop(c.halfedge()) : isolated_loop(c.other());
  }

  /// Returns the next half-edge that leaves origin(h), counter-clockwise.
  HalfedgeId turn_left(HalfedgeId h) const { return twin(prev(h)); }
  /// Returns the next half-edge that leaves origin(h), clockwise.
  HalfedgeId turn_right(HalfedgeId h) const { return next(twin(h)); }

  /// Returns the range of the half-edges of a loop, in their direction. For the loop of an isolated
  /// vertex, the range is empty.
  auto along(LoopId l) const { return ring<&Dcel::next>(first(l).halfedge()); }
  /// Returns the range of the half-edges that leave v, counter-clockwise. If v is a pinch, the
  /// range contains only one of the rings of v.
  auto around(VertexId v) const { return ring<&Dcel::turn_left>(halfedge(v)); }
  /// Returns the range of the loops of a face.
  auto loops_of(FaceId f) const { return ring<&Dcel::next_loop>(first_loop(f)); }
  /// Returns the next loop in the ring of its face.
  LoopId next_loop(LoopId l) const { return loops_[l].next; }

  std::size_t vertex_count() const {
    return counts_.vertices;
  }  ///< Returns the number of present vertices.
  /// Returns the number of present half-edges, which is twice the number of edges.
  std::size_t halfedge_count() const { return 2 * counts_.edges; }
  std::size_t edge_count() const {
    return counts_.edges;
  }  ///< Returns the number of present edges.
  std::size_t loop_count() const {
    return counts_.loops;
  }  ///< Returns the number of present loops.
  std::size_t face_count() const {
    return counts_.faces;
  }  ///< Returns the number of present faces.

  /// Returns the size that an array indexed by VertexId needs. This size is the number of vertex
  /// ids, including the ids of removed vertices. The functions below return the corresponding sizes
  /// for the other kinds of cells.
  std::size_t vertex_slots() const { return vertices_.size(); }
  std::size_t halfedge_slots() const { return halfedges_.size(); }  ///< Number of half-edge ids.
  std::size_t edge_slots() const { return halfedges_.size() / 2; }  ///< Number of edge ids.
  std::size_t loop_slots() const { return loops_.size(); }          ///< Number of loop ids.
  std::size_t face_slots() const { return faces_.size(); }          ///< Number of face ids.

  /// Whether vertex v is present: its id is in range, and the vertex was not removed.
  bool contains(VertexId v) const {
    return v.value() < vertices_.size() && vertices_[v].is_valid();
  }
  /// Whether half-edge h is present: its id is in range, and the half-edge was not removed.
  bool contains(HalfedgeId h) const {
    return h.value() < halfedges_.size() && halfedges_[h].origin.is_valid();
  }
  /// Whether edge e is present: its id is in range, and the edge was not removed.
  bool contains(EdgeId e) const { return e.is_valid() && contains(first_half(e)); }
  /// Whether loop l is present: its id is in range, and the loop was not removed.
  bool contains(LoopId l) const { return l.value() < loops_.size() && loops_[l].first.is_valid(); }
  /// Whether face f is present: its id is in range, and the face was not removed.
  bool contains(FaceId f) const { return f.value() < faces_.size() && faces_[f] != kRemoved; }

  /// Whether the half-edges of some vertex form several rings.
  bool has_pinches() const { return has_pinches_; }

  // --- Euler operators (all require !has_pinches()) --------------------------------------------

  FaceId add_face();  ///< Adds a face without loops and returns it.
  /// Removes a face. Requires that the face has no loops.
  void remove_face(FaceId f);

  /// Adds an isolated vertex to face f, together with its loop, and returns the vertex.
  VertexId add_vertex(FaceId f);
  /// Removes a vertex and its loop. Requires that the vertex is isolated.
  void remove_vertex(VertexId v);

  /// Adds an edge from vertex_at(a) to vertex_at(b). Returns the half-edge of the new edge that has
  /// the even id. This half-edge, called h below, leads from vertex_at(a) to vertex_at(b). Requires
  /// that both corners lie in the same face.
  ///   - If the corners lie in the same loop, this loop is split. A new loop of the same face
  ///     consists of h and of the part of the old loop from b to a. (If a == b, the new loop
  ///     consists of h alone, which is a self-loop.) The rest of the old loop and twin(h) form the
  ///     old loop. Cost: O(length of the new loop).
  ///   - If the corners lie in two loops, the loops are joined. The joined loop keeps the id of the
  ///     loop of a. Cost: O(length of the loop of b).
  HalfedgeId add_edge(Corner a, Corner b);
  /// Removes the edge of h. Requires that both sides of h have the same face. If the faces differ,
  /// call join_faces first.
  ///   - If h and twin(h) lie in two loops, the loops are joined. The joined loop keeps the id of
  ///     the loop of twin(h). Cost: O(length of the loop of h).
  ///   - If h and twin(h) lie in the same loop, the loop is split in two. The part at origin(h)
  ///     keeps the id, and the part at target(h) gets a new id. A part without half-edges becomes
  ///     an isolated vertex. Cost: O(length of the part at target(h)).
  void remove_edge(HalfedgeId h);

  /// Inserts a new vertex w into the edge of h and returns the new half-edge next(h). Afterwards h
  /// ends at w, twin(h) begins at w, and next(h) leads from w to the old target of h.
  HalfedgeId split_edge(HalfedgeId h);
  /// Undoes split_edge: removes h, twin(h) and origin(h). Afterwards the previous half-edge of h
  /// ends at the target of h. Requires that exactly two half-edges leave origin(h) and that they
  /// belong to different edges.
  void join_edge(HalfedgeId h);

  /// Adds a face, moves the loops of the list to this face in the order of the list, and returns
  /// the face. Requires that the list is not empty and that its loops are distinct and belong to
  /// the same face. Cost: O(number of loops).
  FaceId split_face(std::span<const LoopId> loops);
  /// Appends all loops of the face `gone` to the loops of the face `kept`, and removes `gone`.
  /// Requires that the two faces are distinct. Cost: O(number of loops of `gone`).
  void join_faces(FaceId kept, FaceId gone);

  /// Gives all cells new ids without holes, in the same order, and returns the new ids. Owners
  /// compact their arrays with follow(), for example follow(compaction.vertex, coordinates). Cost:
  /// O(n).
  DcelCompaction compact();

  // --- auditing ------------------------------------------------------------------------------

  /// Checks every invariant from scratch. Returns the first violated invariant, or no value if all
  /// invariants hold. The arrays may have arbitrary contents. Cost: O(n).
  ///   sizes, ranges     present cells refer only to present cells, and the counts are right
  ///   next/prev         next and prev are inverse to each other, and target(h) = origin(next(h))
  ///   loop              each loop is one closed chain of next, and its half-edges refer to this
  ///                     loop
  ///   vertex            the half-edge of a vertex leaves the vertex, and the loop of an isolated
  ///                     vertex begins with this vertex
  ///   pinches           has_pinches() is true exactly if some vertex has several rings
  ///   face              the loops of a face form one ring, and each of them refers to the face
  std::optional<DcelFlaw> audit() const;

  /// Checks that the structure represents a map of the plane or of the sphere. Returns the first
  /// flaw, or no value if there is no flaw. A component is an isolated vertex, or a set of
  /// half-edges that are connected by next and twin. Half-edges that are connected only through a
  /// pinch belong to different components. A ring is an isolated vertex, or a cycle of half-edges
  /// around a vertex in which turn_left() leads from each half-edge to the next. The function
  /// checks two conditions:
  ///   - rings - edges + loops = 2 in each component;
  ///   - the graph whose nodes are the faces and the components, and whose arcs are the loops, is a
  ///     tree.
  /// Without pinches, these conditions imply V - E + F = 1 + components. Requires that audit()
  /// finds no flaw. Cost: O(n a(n)), where a is the inverse Ackermann function.
  std::optional<DcelFlaw> audit_planar() const;

 private:
  friend class DcelAudit;
  friend class DcelSurgeon;  // Tests use this class to damage the arrays on purpose.

  struct Halfedge {
    VertexId origin;  ///< Invalid if the half-edge was removed.
    HalfedgeId next, prev;
    LoopId loop;
  };
  struct Loop {
    Corner first;  ///< Invalid if the loop was removed.
    FaceId face;
    LoopId next, prev;  ///< The next and the previous loop in the ring of all loops of the face.
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
    halfedges_[a].next = b;
    halfedges_[b].prev = a;
  }
  bool is_corner(Corner c) const;
  void attach(HalfedgeId h, Corner at);
  void attach_self_loop(HalfedgeId h, Corner at);
  void detach(HalfedgeId h);
  void relabel(HalfedgeId from, HalfedgeId stop, LoopId l);
  void settle(VertexId v, HalfedgeId leaving, LoopId l);
  HalfedgeId other_leaving(HalfedgeId h) const;

  IdVector<HalfedgeId, Halfedge> halfedges_;
  IdVector<VertexId, HalfedgeOr<LoopId>> vertices_;  ///< Invalid for removed vertices.
  IdVector<LoopId, Loop> loops_;
  IdVector<FaceId, LoopId>
      faces_;  ///< The first loop, or an invalid id if the face has no loop; kRemoved if removed.
  Counts counts_;
  bool has_pinches_ = false;
};

/// The result of Dcel::from_cycles.
struct DcelFromCycles {
  Dcel dcel;  ///< The structure.
  /// The half-edge of each corner position.
  std::vector<HalfedgeId> halfedge_of_corner;
};

}  // namespace plumb
#pragma GCC visibility pop
