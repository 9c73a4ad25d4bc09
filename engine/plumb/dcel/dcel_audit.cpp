// The audits of a half-edge structure: its links, and whether it represents a map of the plane.
//
// DcelAudit checks the invariants of dcel.h in an order in which each check relies only on the
// checks before it. So links can be followed safely in any structure. Many invariants follow from a
// count: if every chain that is found has one label, and together they reach all half-edges, there
// is one chain for each label.
//
// audit_planar() checks Euler's formula, rings - edges + loops = 2, for each component, which makes
// it a map of the sphere; and that faces and components, joined by loops, form a tree, which makes
// the whole a subdivision of the plane.
//
// Declared in plumb/dcel/dcel.h.
// Tested by tests/dcel/dcel_audit_test.cpp.

#include <algorithm>
#include <numeric>

#include "plumb/base/internal/union_find.h"
#include "plumb/dcel/dcel.h"

namespace plumb {

/// One audit. Each check relies on the checks before it, so that it can follow links safely.
class DcelAudit {
 public:
  explicit DcelAudit(const Dcel& dcel) : d_(dcel) {}

  std::optional<DcelFlaw> run() {
    sizes() && edges() && vertices() && loops() && faces() && counts() && chains() &&
        loop_chains() && vertex_rings() && face_rings();
    return flaw_;
  }

 private:
  static std::string name(const char* place) { return place; }
  static std::string name(VertexId v) { return "vertex " + std::to_string(v.value()); }
  static std::string name(HalfedgeId h) { return "half-edge " + std::to_string(h.value()); }
  static std::string name(LoopId l) { return "loop " + std::to_string(l.value()); }
  static std::string name(FaceId f) { return "face " + std::to_string(f.value()); }

  template <class Place>
  bool require(bool holds, const char* invariant, Place place) {
    if (!holds) flaw_ = DcelFlaw{invariant, name(place)};
    return holds;
  }

  /// Calls check(id) for all present elements until one fails.
  template <class Id, class Check>
  bool all(std::size_t slots, Check check) {
    for (std::size_t i = 0; i < slots; ++i) {
      if (d_.contains(Id(i)) && !check(Id(i))) return false;
    }
    return true;
  }

  bool sizes() {
    return require(d_.halfedges_.size() % 2 == 0, "half-edges come in pairs", "the array");
  }

  bool edges() {
    for (std::size_t i = 0; i < d_.halfedge_slots(); ++i) {
      if (!edge(HalfedgeId(i))) return false;
    }
    return true;
  }
  bool edge(HalfedgeId h) {
    const Dcel::Halfedge& r = d_.halfedges_[h];
    if (!d_.contains(h)) {
      return require(!d_.contains(twin(h)), "both half-edges of an edge are present, or none", h) &&
             require(!r.next.is_valid() && !r.prev.is_valid() && !r.loop.is_valid(),
                     "a removed half-edge has no links", h);
    }
    return require(d_.contains(twin(h)), "both half-edges of an edge are present, or none", h) &&
           require(d_.contains(r.origin), "origin is a present vertex", h) &&
           require(d_.contains(r.next), "next is a present half-edge", h) &&
           require(d_.contains(r.prev), "prev is a present half-edge", h) &&
           require(d_.contains(r.loop), "loop is a present loop", h);
  }

  bool vertices() {
    return all<VertexId>(d_.vertex_slots(), [this](VertexId v) {
      if (d_.is_isolated(v)) {
        const LoopId l = d_.isolated_loop(v);
        return require(d_.contains(l) && d_.first(l) == Corner(v),
                       "the loop of an isolated vertex begins with it", v);
      }
      return require(d_.contains(d_.halfedge(v)) && d_.origin(d_.halfedge(v)) == v,
                     "the half-edge of a vertex leaves it", v);
    });
  }

  bool loops() {
    for (std::size_t i = 0; i < d_.loop_slots(); ++i) {
      if (!loop(LoopId(i))) return false;
    }
    return true;
  }
  bool loop(LoopId l) {
    const Dcel::Loop& r = d_.loops_[l];
    if (!d_.contains(l)) {
      return require(!r.face.is_valid() && !r.next.is_valid() && !r.prev.is_valid(),
                     "a removed loop has no links", l);
    }
    return require(d_.contains(r.face), "the face of a loop is present", l) &&
           require(d_.contains(r.next), "the next loop of the face is present", l) &&
           require(d_.contains(r.prev), "the previous loop of the face is present", l) &&
           require(begins_well(l), "a loop begins with its own half-edge or isolated vertex", l);
  }
  bool begins_well(LoopId l) const {
    const Corner first = d_.first(l);
    if (first.is_halfedge()) return d_.contains(first.halfedge()) && d_.loop(first.halfedge()) == l;
    return d_.contains(first.other()) && d_.isolated_loop(first.other()) == l;
  }

  bool faces() {
    return all<FaceId>(d_.face_slots(), [this](FaceId f) {
      const LoopId l = d_.first_loop(f);
      return require(!l.is_valid() || (d_.contains(l) && d_.face(l) == f),
                     "the first loop of a face belongs to it", f);
    });
  }

  bool counts() {
    Dcel::Counts seen;
    all<VertexId>(d_.vertex_slots(), [&](VertexId) { return ++seen.vertices > 0; });
    all<EdgeId>(d_.edge_slots(), [&](EdgeId) { return ++seen.edges > 0; });
    all<LoopId>(d_.loop_slots(), [&](LoopId) { return ++seen.loops > 0; });
    all<FaceId>(d_.face_slots(), [&](FaceId) { return ++seen.faces > 0; });
    return require(seen == d_.counts_, "the counts are those of the arrays", "the counts");
  }

  /// If prev(next(h)) = h for all h, next is one-to-one, and prev is its inverse.
  bool chains() {
    return all<HalfedgeId>(d_.halfedge_slots(), [this](HalfedgeId h) {
      return require(d_.prev(d_.next(h)) == h, "prev undoes next", h) &&
             require(d_.origin(d_.next(h)) == d_.target(h), "next begins where this one ends", h) &&
             require(d_.loop(d_.next(h)) == d_.loop(h), "next is in the same loop", h);
    });
  }

  /// Labels are constant along chains, so if one chain for each loop reaches all half-edges, every
  /// loop is one chain.
  bool loop_chains() {
    std::size_t reached = 0;
    all<LoopId>(d_.loop_slots(), [&](LoopId l) {
      for ([[maybe_unused]] const HalfedgeId h : d_.along(l)) ++reached;
      return true;
    });
    return require(reached == d_.halfedge_count(), "a loop is one chain of half-edges",
                   "all loops");
  }

  bool vertex_rings() {
    std::size_t reached = 0;
    all<VertexId>(d_.vertex_slots(), [&](VertexId v) {
      for ([[maybe_unused]] const HalfedgeId h : d_.around(v)) ++reached;
      return true;
    });
    return require((reached != d_.halfedge_count()) == d_.has_pinches_,
                   "a vertex without a pinch has one ring of half-edges", "all vertices");
  }

  bool face_rings() {
    const auto linked = [this](LoopId l) {
      const Dcel::Loop& r = d_.loops_[l];
      return require(d_.loops_[r.next].prev == l, "the loops of a face form a ring", l) &&
             require(d_.face(r.next) == r.face, "the loops of a ring belong to one face", l);
    };
    if (!all<LoopId>(d_.loop_slots(), linked)) return false;
    std::size_t reached = 0;
    all<FaceId>(d_.face_slots(), [&](FaceId f) {
      for ([[maybe_unused]] const LoopId l : d_.loops_of(f)) ++reached;
      return true;
    });
    return require(reached == d_.loop_count(), "the loops of a face form one ring", "all faces");
  }

  const Dcel& d_;
  std::optional<DcelFlaw> flaw_;
};

namespace {

/// The components of the structure: sets of edges that next and twin connect, and isolated
/// vertices. Fans that share only a pinch are different components.
class Components {
 public:
  explicit Components(const Dcel& d) : d_(d), sets_(d.edge_slots() + d.vertex_slots()) {
    for (std::size_t i = 0; i < d.halfedge_slots(); ++i) {
      const HalfedgeId h(i);
      if (d.contains(h)) sets_.unite(edge_of(h).value(), edge_of(d.next(h)).value());
    }
  }

  std::uint32_t of(Corner c) {
    const auto isolated = static_cast<std::uint32_t>(d_.edge_slots() + c.other().value());
    return sets_.root(c.is_halfedge() ? edge_of(c.halfedge()).value() : isolated);
  }

  /// Whether number i represents a component.
  bool contains(std::size_t i) {
    if (sets_.root(static_cast<std::uint32_t>(i)) != i) return false;
    if (i < d_.edge_slots()) return d_.contains(EdgeId(i));
    const VertexId v(i - d_.edge_slots());
    return d_.contains(v) && d_.is_isolated(v);
  }

  std::string name(std::size_t i) const {
    return i < d_.edge_slots() ? "the component of edge " + std::to_string(i)
                               : "isolated vertex " + std::to_string(i - d_.edge_slots());
  }

  /// Returns rings - edges + loops for each representative.
  std::vector<std::int64_t> characteristics() {
    std::vector<std::int64_t> sum(d_.edge_slots() + d_.vertex_slots());
    for (std::size_t i = 0; i < d_.edge_slots(); ++i) {
      if (d_.contains(EdgeId(i))) --sum[of(first_half(EdgeId(i)))];
    }
    for (std::size_t i = 0; i < d_.loop_slots(); ++i) {
      if (d_.contains(LoopId(i))) ++sum[of(d_.first(LoopId(i)))];
    }
    for (std::size_t i = 0; i < d_.vertex_slots(); ++i) {
      if (d_.contains(VertexId(i)) && d_.is_isolated(VertexId(i))) ++sum[of(VertexId(i))];
    }
    add_rings(sum);
    return sum;
  }

 private:
  void add_rings(std::vector<std::int64_t>& sum) {
    IdVector<HalfedgeId, bool> seen(d_.halfedge_slots());
    for (std::size_t i = 0; i < seen.size(); ++i) {
      HalfedgeId h(i);
      if (!d_.contains(h) || seen[i]) continue;
      ++sum[of(h)];
      for (; !seen[h]; h = d_.turn_right(h)) seen[h] = true;
    }
  }

  const Dcel& d_;
  UnionFind sets_;
};

}  // namespace

std::optional<DcelFlaw> Dcel::audit() const { return DcelAudit(*this).run(); }

std::optional<DcelFlaw> Dcel::audit_planar() const {
  Components components(*this);
  const auto sums = components.characteristics();
  std::size_t parts = 0;
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (!components.contains(i)) continue;
    ++parts;
    if (sums[i] != 2) return DcelFlaw{"rings - edges + loops = 2", components.name(i)};
  }
  // Faces and components, joined by loops, must form a tree: no cycle, and all connected.
  UnionFind nodes(sums.size() + face_slots());
  std::size_t joined = 0;
  for (std::size_t i = 0; i < loop_slots(); ++i) {
    if (!contains(LoopId(i))) continue;
    const auto f = static_cast<std::uint32_t>(sums.size() + face(LoopId(i)).value());
    if (!nodes.unite(components.of(first(LoopId(i))), f)) {
      return DcelFlaw{"faces and components form a tree", "loop " + std::to_string(i)};
    }
    ++joined;
  }
  if (face_count() + parts != joined + 1) {
    return DcelFlaw{"faces and components are connected", "all faces"};
  }
  return std::nullopt;
}

}  // namespace plumb
