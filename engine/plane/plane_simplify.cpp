#include "plumb/plane/plane_simplify.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "plumb/plane/plane_draft.h"

namespace plumb {
namespace {

// Faces merged so far, by the least of each set.
class MergedFaces {
 public:
  explicit MergedFaces(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }

  std::uint32_t find(FaceId f) {
    std::uint32_t i = f.value();
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void merge(FaceId f, FaceId g) {
    const std::uint32_t a = find(f);
    const std::uint32_t b = find(g);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

class Simplifier {
 public:
  explicit Simplifier(PlaneComplex& complex)
      : complex_(complex),
        dcel_(complex.dcel),
        faces_(complex.dcel.face_count()),
        is_kept_(complex.edge_count(), 0),
        continues_(complex.edge_count()),
        vertex_(complex.vertex_count()),
        halfedge_(2 * complex.edge_count()) {}

  /// Moves the points out of the complex.
  PlaneComplex run();

 private:
  void drop_edges();
  void place_vertices();
  void place_vertex(VertexId v);
  void collect_kept(VertexId v);
  bool is_straight() const;
  void chain_edges();
  void add_chain(EdgeId first);
  void link_vertices();
  void collect_ends();
  PlaneFaceClasses class_loops(const PlaneLoops& loops);

  FaceId left(EdgeId e) const { return dcel_.face(first_half(e)); }
  FaceId right(EdgeId e) const { return dcel_.face(twin(first_half(e))); }
  bool goes_through(VertexId v) const {
    return !complex_.is_at_infinity(v) && !vertex_[v.value()].is_valid();
  }
  FaceId any_face(VertexId v) const {
    return dcel_.is_isolated(v) ? dcel_.face(dcel_.isolated_loop(v))
                                : dcel_.face(dcel_.halfedge(v));
  }

  PlaneComplex& complex_;
  const Dcel& dcel_;
  MergedFaces faces_;
  PlaneDraft draft_;
  std::vector<std::uint8_t> is_kept_;     // per old edge
  std::vector<EdgeId> continues_;         // per old edge: the one it goes on with, to the right
  std::vector<VertexId> vertex_;          // new by old; invalid: gone
  std::vector<HalfedgeId> halfedge_;      // new by old, at the ends of chains
  std::vector<HalfedgeId> old_halfedge_;  // old by new, any one of the chain
  std::vector<FaceId> isolated_face_;     // per entry of draft_.isolated: old face
  std::vector<HalfedgeId> kept_here_;     // leaving half-edges, counter-clockwise
};

void Simplifier::drop_edges() {
  for (std::size_t i = 0; i < is_kept_.size(); ++i) {
    const EdgeId e(i);
    const bool mark = complex_.mark(e);
    is_kept_[i] = complex_.mark(left(e)) != mark || complex_.mark(right(e)) != mark ? 1 : 0;
    if (is_kept_[i] == 0) faces_.merge(left(e), right(e));
  }
}

void Simplifier::collect_kept(VertexId v) {
  kept_here_.clear();
  if (dcel_.is_isolated(v)) return;
  for (const HalfedgeId h : dcel_.around(v)) {
    if (is_kept_[edge_of(h).value()] != 0) kept_here_.push_back(h);
  }
}

bool Simplifier::is_straight() const {
  const PlaneLine& k = complex_.line[edge_of(kept_here_[0]).value()];
  const PlaneLine& l = complex_.line[edge_of(kept_here_[1]).value()];
  return k == l || cross_sign(complex_.points.inputs, k.a, k.b, l.a, l.b) == Sign::Zero;
}

void Simplifier::place_vertex(VertexId v) {
  const bool mark = complex_.mark(v);
  collect_kept(v);
  if (kept_here_.empty()) {
    if (mark == complex_.mark(any_face(v))) return;
  } else if (kept_here_.size() == 2) {
    const EdgeId e = edge_of(kept_here_[0]);
    const EdgeId f = edge_of(kept_here_[1]);
    if (complex_.mark(e) == mark && complex_.mark(f) == mark && is_straight()) {
      // The even half-edge is the one that leaves to the right.
      const bool first_leaves = (kept_here_[0].value() & 1U) == 0;
      continues_[(first_leaves ? f : e).value()] = first_leaves ? e : f;
      return;
    }
  }
  vertex_[v.value()] = draft_.add_vertex(complex_.vertex_point[v.value()], mark);
  if (kept_here_.empty()) {
    draft_.isolated.push_back(vertex_[v.value()]);
    isolated_face_.push_back(any_face(v));
  }
}

void Simplifier::place_vertices() {
  for (std::size_t i = 0; i < complex_.vertex_count(); ++i) place_vertex(VertexId(i));
}

void Simplifier::add_chain(EdgeId first) {
  const VertexId from = dcel_.origin(first_half(first));
  const EdgeId e =
      draft_.add_edge(complex_.is_at_infinity(from) ? VertexId() : vertex_[from.value()],
                      complex_.line[first.value()], complex_.mark(first),
                      complex_.mark(left(first)), complex_.mark(right(first)));
  EdgeId last = first;
  while (continues_[last.value()].is_valid()) last = continues_[last.value()];
  const VertexId to = dcel_.target(first_half(last));
  if (!complex_.is_at_infinity(to)) draft_.end_edge(e, vertex_[to.value()]);
  halfedge_[first_half(first).value()] = first_half(e);
  halfedge_[twin(first_half(last)).value()] = twin(first_half(e));
  old_halfedge_.push_back(first_half(first));
  old_halfedge_.push_back(twin(first_half(first)));
}

// A chain begins where an edge is not gone on to from the left.
void Simplifier::chain_edges() {
  for (std::size_t i = 0; i < is_kept_.size(); ++i) {
    const EdgeId e(i);
    if (is_kept_[i] != 0 && !goes_through(dcel_.origin(first_half(e)))) add_chain(e);
  }
}

void Simplifier::link_vertices() {
  for (std::size_t i = 0; i < complex_.vertex_count(); ++i) {
    if (!vertex_[i].is_valid()) continue;
    collect_kept(VertexId(i));
    for (HalfedgeId& h : kept_here_) h = halfedge_[h.value()];
    draft_.link_ring(kept_here_);
  }
}

// The frame's vertices are numbered counter-clockwise from face 0.
void Simplifier::collect_ends() {
  for (std::size_t v = complex_.vertex_count(); v < dcel_.vertex_count(); ++v) {
    for (const HalfedgeId h : dcel_.around(VertexId(v))) {
      if (complex_.is_frame(h) || is_kept_[edge_of(h).value()] == 0) continue;
      draft_.ends.push_back(twin(halfedge_[h.value()]));
    }
  }
}

PlaneFaceClasses Simplifier::class_loops(const PlaneLoops& loops) {
  const std::uint32_t beyond = static_cast<std::uint32_t>(dcel_.face_count());
  PlaneFaceClasses classes;
  classes.class_count = dcel_.face_count() + 1;
  classes.bottom = faces_.find(FaceId(0));
  for (const HalfedgeId h : loops.first) {
    const bool is_ordinary = h.value() < old_halfedge_.size();
    classes.of_loop.push_back(is_ordinary ? faces_.find(dcel_.face(old_halfedge_[h.value()]))
                                          : beyond);
  }
  for (const FaceId f : isolated_face_) classes.of_isolated.push_back(faces_.find(f));
  return classes;
}

PlaneComplex Simplifier::run() {
  drop_edges();
  place_vertices();
  chain_edges();
  link_vertices();
  collect_ends();
  draft_.bottom_mark = complex_.marks.face[0];
  close_frame(draft_);
  const PlaneLoops loops = trace_loops(draft_);
  const PlaneFaceClasses classes = class_loops(loops);
  return finish(draft_, loops, classes, std::move(complex_.points)).complex;
}

template <class Combine>
PlaneMarks neighbourhood_marks(const PlaneComplex& complex, Combine combine) {
  PlaneMarks marks = complex.marks;
  for (std::size_t i = 0; i < complex.edge_count(); ++i) {
    const HalfedgeId h = first_half(EdgeId(i));
    marks.edge[i] = combine(marks.edge[i], combine(complex.mark(complex.dcel.face(h)),
                                                   complex.mark(complex.dcel.face(twin(h)))))
                        ? 1
                        : 0;
  }
  for (std::size_t i = 0; i < complex.vertex_count(); ++i) {
    const VertexId v(i);
    bool mark = complex.mark(v);
    if (complex.dcel.is_isolated(v)) {
      mark = combine(mark, complex.mark(complex.dcel.face(complex.dcel.isolated_loop(v))));
    } else {
      // The new marks of the edges already hold those of the faces beside them.
      for (const HalfedgeId h : complex.dcel.around(v)) {
        mark = combine(mark, marks.edge[edge_of(h).value()] != 0);
      }
    }
    marks.vertex[i] = mark ? 1 : 0;
  }
  return marks;
}

}  // namespace

PlaneComplex simplify(PlaneComplex complex) { return Simplifier(complex).run(); }

PlaneMarks interior_marks(const PlaneComplex& complex) {
  return neighbourhood_marks(complex, [](bool a, bool b) { return a && b; });
}

PlaneMarks closure_marks(const PlaneComplex& complex) {
  return neighbourhood_marks(complex, [](bool a, bool b) { return a || b; });
}

}  // namespace plumb
