// Complexes under construction, and the minimal form in linear time.
//
// Numbering is canonical, so that equal sets have equal arrays: vertices in lexicographic order,
// edges as a sweep meets them, loops by least half-edge, faces by least half-edge with face 0 first
// and the face beyond the frame last, and input points in their order, without points to which
// nothing refers.
//
// simplify() drops edges first. Whether an edge is dropped depends on the marks of its old faces,
// which are equal where faces are joined, so the order does not matter. After the edges are
// settled, the order of the vertices does not matter either (docs/design/sweep.md, Lemma 3).
// without_edges() drops the edges that its caller names, and vertices by the same rule, but without
// marks. Kept edges stay in the order of the sweep, because a chain takes the place of its first
// edge.
//
// Tested by tests/plane/nef2_test.cpp, tests/plane/sweep_unbounded_test.cpp and
// tests/plane/without_edges_test.cpp.

#include "plumb/plane/complex/plane_draft.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNoFace = FaceId::kInvalid;

// ---------------------------------------------------------------- faces

// Numbers the faces: face 0 first, then by least half-edge. Only face 0 may have no half-edge. The
// face beyond the frame has the greatest half-edges and comes last.
class FaceNumbers {
 public:
  FaceNumbers(const PlaneLoops& loops, const PlaneFaceClasses& classes)
      : face_of_class_(classes.class_count, kNoFace) {
    add(classes.bottom, HalfedgeId());
    for (std::size_t l = 0; l < loops.count(); ++l) add(classes.of_loop[l], loops.first[l]);
  }

  FaceId operator[](std::uint32_t face_class) const { return FaceId(face_of_class_[face_class]); }
  std::vector<HalfedgeId> take_first() { return std::move(first_); }

 private:
  void add(std::uint32_t face_class, HalfedgeId first) {
    std::uint32_t& face = face_of_class_[face_class];
    if (face == kNoFace) {
      face = static_cast<std::uint32_t>(first_.size());
      first_.push_back(first);
    } else if (!first_[face].is_valid()) {
      first_[face] = first;
    }
  }

  std::vector<std::uint32_t> face_of_class_;
  std::vector<HalfedgeId> first_;  // The least half-edge of each face.
};

// ---------------------------------------------------------------- points

// Keeps the points to which vertices, lines and kept crossings refer, in their order.
class PointCompaction {
 public:
  PointCompaction(const PlaneDraft& draft, const PlanePoints& points)
      : inputs_(points.inputs.size()), used_(points.size(), 0), to_(points.size(), 0) {
    for (const std::uint32_t p : draft.vertex_point) used_[p] = 1;
    for (const PlaneLine& l : draft.line) used_[l.a] = used_[l.b] = 1;
    for (std::size_t k = inputs_; k < points.size(); ++k) {
      if (used_[k] == 0) continue;
      const Crossing2& c = points.crossings[k - inputs_];
      used_[c.a] = used_[c.b] = used_[c.c] = used_[c.d] = 1;
    }
    std::uint32_t kept = 0;
    for (std::size_t p = 0; p < used_.size(); ++p) {
      to_[p] = kept;
      kept += used_[p];
    }
    keeps_all_ = kept == used_.size();
  }

  PlanePoints apply(PlanePoints points) const {
    if (keeps_all_) return points;
    PlanePoints kept{points.inputs.subset({used_.data(), inputs_}), {}};
    for (std::size_t k = 0; k < points.crossings.size(); ++k) {
      if (used_[inputs_ + k] == 0) continue;
      Crossing2 c = points.crossings[k];
      c.a = to_[c.a];
      c.b = to_[c.b];
      c.c = to_[c.c];
      c.d = to_[c.d];
      kept.crossings.push_back(c);
    }
    return kept;
  }

  std::uint32_t operator[](std::uint32_t point) const { return to_[point]; }

 private:
  std::size_t inputs_;
  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> to_;
  bool keeps_all_ = false;
};

void copy_geometry(const PlaneDraft& draft, PlanePoints points, PlaneComplex& complex) {
  const PointCompaction compaction(draft, points);
  complex.vertex_point.reserve(draft.vertex_count());
  for (const std::uint32_t p : draft.vertex_point) complex.vertex_point.push_back(compaction[p]);
  complex.line.reserve(draft.edge_count());
  for (const PlaneLine& l : draft.line) complex.line.push_back({compaction[l.a], compaction[l.b]});
  complex.points = compaction.apply(std::move(points));
}

PlaneMarks marks_of(const PlaneDraft& draft, const std::vector<HalfedgeId>& first_of_face) {
  PlaneMarks marks{draft.vertex_mark, draft.edge_mark, {}};
  marks.face.reserve(first_of_face.size());
  for (const HalfedgeId h : first_of_face) {
    marks.face.push_back(h.is_valid() ? draft.left_mark[h] : draft.bottom_mark);
  }
  return marks;
}

}  // namespace

// ---------------------------------------------------------------- filling

VertexId PlaneDraft::add_vertex(std::uint32_t point, bool mark) {
  vertex_point.push_back(point);
  vertex_mark.push_back(mark ? 1 : 0);
  return VertexId(vertex_point.size() - 1);
}

EdgeId PlaneDraft::add_edge(VertexId left, PlaneLine edge_line, bool mark, bool mark_above,
                            bool mark_below) {
  const EdgeId e(line.size());
  line.push_back(edge_line);
  edge_mark.push_back(mark ? 1 : 0);
  origin.push_back(left);
  origin.push_back(VertexId());
  next.resize(next.size() + 2);
  left_mark.push_back(mark_above ? 1 : 0);
  left_mark.push_back(mark_below ? 1 : 0);
  return e;
}

// Between two consecutive half-edges, counter-clockwise, there is a corner of the face to the left
// of the first one. Therefore the half-edge that arrives along the second one is followed by the
// first one.
void PlaneDraft::link_ring(std::span<const HalfedgeId> leaving) {
  for (std::size_t i = 0; i < leaving.size(); ++i) {
    const HalfedgeId after = leaving[i + 1 < leaving.size() ? i + 1 : 0];
    next[twin(after)] = leaving[i];
  }
}

// The ends are counter-clockwise around the plane. Therefore the frame edge from each end to the
// next has the face between the two ends on its left, and its twin has the face beyond the frame.
HalfedgeId close_frame(PlaneDraft& draft) {
  const std::size_t n = draft.ends.size();
  if (n == 0) return HalfedgeId();
  const std::size_t vertices = draft.vertex_count();
  const std::size_t edges = draft.edge_count();
  const auto frame_edge = [&](std::size_t i) { return first_half(EdgeId(edges + i)); };
  draft.origin.resize(2 * (edges + n));
  draft.next.resize(2 * (edges + n));
  draft.left_mark.resize(2 * (edges + n), 0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t after = i + 1 < n ? i + 1 : 0;
    const HalfedgeId end = draft.ends[i];
    const HalfedgeId along = frame_edge(i);
    draft.origin[twin(end)] = VertexId(vertices + i);
    draft.origin[along] = VertexId(vertices + i);
    draft.origin[twin(along)] = VertexId(vertices + after);
    draft.next[end] = along;
    draft.next[along] = twin(draft.ends[after]);
    draft.next[twin(frame_edge(after))] = twin(along);
    draft.left_mark[along] = draft.left_mark[end];
  }
  return frame_edge(n - 1);
}

PlaneLoops trace_loops(const PlaneDraft& draft) {
  PlaneLoops loops;
  loops.loop_of.assign(draft.next.size(), LoopId::kInvalid);
  for (std::size_t start = 0; start < draft.next.size(); ++start) {
    if (loops.loop_of[start] != LoopId::kInvalid) continue;
    HalfedgeId h(start);
    do {
      loops.loop_of[h] = static_cast<std::uint32_t>(loops.first.size());
      h = draft.next[h];
    } while (h.value() != start);
    loops.first.emplace_back(start);
  }
  return loops;
}

// Vertices are in lexicographic order, so the least id is the least vertex. Frame vertices have ids
// beyond all others and no place in that order.
std::vector<VertexId> least_vertices(const PlaneDraft& draft, const PlaneLoops& loops) {
  std::vector<VertexId> least(loops.count());
  std::vector<std::uint8_t> is_along_frame(loops.count(), 0);
  for (std::size_t h = 0; h < draft.origin.size(); ++h) {
    const std::uint32_t l = loops.loop_of[h];
    if (draft.origin[h].value() >= draft.vertex_count()) is_along_frame[l] = 1;
    least[l] = std::min(least[l], draft.origin[h]);
  }
  for (std::size_t l = 0; l < least.size(); ++l) {
    if (is_along_frame[l] != 0) least[l] = VertexId();
  }
  return least;
}

// ---------------------------------------------------------------- finishing

FinishedDraft finish(const PlaneDraft& draft, const PlaneLoops& loops,
                     const PlaneFaceClasses& classes, PlanePoints points) {
  FaceNumbers faces(loops, classes);
  std::vector<FaceId> face_of_loop;
  face_of_loop.reserve(loops.count());
  for (const std::uint32_t c : classes.of_loop) face_of_loop.push_back(faces[c]);
  std::vector<Dcel::IsolatedVertex> isolated;
  for (std::size_t i = 0; i < draft.isolated.size(); ++i) {
    isolated.push_back({draft.isolated[i], faces[classes.of_isolated[i]]});
  }
  FinishedDraft finished;
  finished.first_of_face = faces.take_first();
  if (!draft.ends.empty()) finished.first_of_face.pop_back();
  PlaneComplex& complex = finished.complex;
  complex.dcel = Dcel::from_links(draft.vertex_count() + draft.ends.size(), draft.origin,
                                  draft.next, loops.loop_of, face_of_loop, isolated);
  if (complex.dcel.face_count() == 0) complex.dcel.add_face();
  complex.marks = marks_of(draft, finished.first_of_face);
  copy_geometry(draft, std::move(points), complex);
  PLUMB_CHECK(complex.face_count() == complex.marks.face.size());
  return finished;
}

namespace {

// The classes of joined faces, as a union-find in which the root of each class is its least face.
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

// One run of simplify() or without_edges().
class Simplifier {
 public:
  explicit Simplifier(const PlaneComplex& complex)
      : complex_(complex),
        dcel_(complex.dcel),
        faces_(complex.dcel.face_count()),
        is_kept_(complex.edge_count(), 0),
        continues_(complex.edge_count()),
        vertex_(complex.vertex_count()),
        halfedge_(2 * complex.edge_count()) {}

  /// Returns the minimal form. `points` are the points of the complex, which are moved into the
  /// result at the end.
  PlaneComplex minimal(PlanePoints&& points);
  /// Returns the complex of the edges that are kept.
  ReducedComplex reduced(std::span<const std::uint8_t> is_kept,
                         std::span<const std::uint8_t> is_corner);

 private:
  void drop_edges();
  void drop_edge(EdgeId e);
  void place_vertices();
  void place_vertex(VertexId v);
  void place_corner(VertexId v, bool is_corner);
  void pass_through();
  FinishedDraft finished(PlanePoints&& points);
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
    return !complex_.is_at_infinity(v) && !vertex_[v].is_valid();
  }
  FaceId any_face(VertexId v) const {
    return dcel_.is_isolated(v) ? dcel_.face(dcel_.isolated_loop(v))
                                : dcel_.face(dcel_.halfedge(v));
  }

  const PlaneComplex& complex_;
  const Dcel& dcel_;
  MergedFaces faces_;
  PlaneDraft draft_;
  IdVector<EdgeId, std::uint8_t> is_kept_;  // Whether each old edge is kept.
  // For each old edge, the edge with which it continues to the right.
  IdVector<EdgeId, EdgeId> continues_;
  // The new vertex of each old vertex, or an invalid id if it is dropped.
  IdVector<VertexId, VertexId> vertex_;
  IdVector<HalfedgeId, HalfedgeId>
      halfedge_;  // The new half-edges of old half-edges at the ends of chains.
  IdVector<HalfedgeId, HalfedgeId> old_halfedge_;  // For each new half-edge, an old half-edge.
  // For each entry of draft_.isolated, the old face.
  std::vector<FaceId> isolated_face_;
  // The kept half-edges that leave a vertex, counter-clockwise.
  std::vector<HalfedgeId> kept_here_;
};

void Simplifier::drop_edges() {
  for (std::size_t i = 0; i < is_kept_.size(); ++i) {
    const EdgeId e(i);
    const bool mark = complex_.mark(e);
    is_kept_[i] = complex_.mark(left(e)) != mark || complex_.mark(right(e)) != mark ? 1 : 0;
    if (is_kept_[i] == 0) drop_edge(e);
  }
}

void Simplifier::drop_edge(EdgeId e) { faces_.merge(left(e), right(e)); }

void Simplifier::collect_kept(VertexId v) {
  kept_here_.clear();
  if (dcel_.is_isolated(v)) return;
  for (const HalfedgeId h : dcel_.around(v)) {
    if (is_kept_[edge_of(h)] != 0) kept_here_.push_back(h);
  }
}

// Whether the two kept edges at a vertex lie on one line. Pieces of one curve have the same two
// points, so arithmetic is rarely needed.
bool Simplifier::is_straight() const {
  const PlaneLine& k = complex_.line[edge_of(kept_here_[0])];
  const PlaneLine& l = complex_.line[edge_of(kept_here_[1])];
  return k == l || cross_sign(complex_.points.inputs, k.a, k.b, l.a, l.b) == Sign::Zero;
}

// Drops or keeps a vertex. A vertex between two kept edges on one line is dropped if all three have
// the same mark. The edge that arrives from the left then continues in the edge that leaves to the
// right.
void Simplifier::place_vertex(VertexId v) {
  const bool mark = complex_.mark(v);
  collect_kept(v);
  if (kept_here_.empty()) {
    if (mark == complex_.mark(any_face(v))) return;
  } else if (kept_here_.size() == 2) {
    const EdgeId e = edge_of(kept_here_[0]);
    const EdgeId f = edge_of(kept_here_[1]);
    if (complex_.mark(e) == mark && complex_.mark(f) == mark && is_straight()) {
      pass_through();
      return;
    }
  }
  vertex_[v] = draft_.add_vertex(complex_.vertex_point[v], mark);
  if (kept_here_.empty()) {
    draft_.isolated.push_back(vertex_[v]);
    isolated_face_.push_back(any_face(v));
  }
}

// Lets the edge that arrives from the left continue in the one that leaves to the right. The even
// half-edge is the one that leaves to the right.
void Simplifier::pass_through() {
  const EdgeId e = edge_of(kept_here_[0]);
  const EdgeId f = edge_of(kept_here_[1]);
  const bool first_leaves = (kept_here_[0].value() & 1U) == 0;
  continues_[(first_leaves ? f : e)] = first_leaves ? e : f;
}

// Keeps a vertex that has kept edges, unless it is no corner and has exactly two kept edges that
// lie on one line.
void Simplifier::place_corner(VertexId v, bool is_corner) {
  collect_kept(v);
  if (kept_here_.empty()) return;
  if (!is_corner && kept_here_.size() == 2 && is_straight()) {
    pass_through();
    return;
  }
  vertex_[v] = draft_.add_vertex(complex_.vertex_point[v], complex_.mark(v));
}

void Simplifier::place_vertices() {
  for (std::size_t i = 0; i < complex_.vertex_count(); ++i) place_vertex(VertexId(i));
}

// Makes one edge of a chain. All edges of the chain have the line and the marks of the first one.
// Only the half-edges at the two ends get new numbers, because only these are looked up at
// vertices.
void Simplifier::add_chain(EdgeId first) {
  const VertexId from = dcel_.origin(first_half(first));
  const EdgeId e = draft_.add_edge(complex_.is_at_infinity(from) ? VertexId() : vertex_[from],
                                   complex_.line[first], complex_.mark(first),
                                   complex_.mark(left(first)), complex_.mark(right(first)));
  EdgeId last = first;
  while (continues_[last].is_valid()) last = continues_[last];
  const VertexId to = dcel_.target(first_half(last));
  if (!complex_.is_at_infinity(to)) draft_.end_edge(e, vertex_[to]);
  halfedge_[first_half(first)] = first_half(e);
  halfedge_[twin(first_half(last))] = twin(first_half(e));
  old_halfedge_.push_back(first_half(first));
  old_halfedge_.push_back(twin(first_half(first)));
}

// A chain begins with each kept edge whose left end is kept or is at infinity.
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
    for (HalfedgeId& h : kept_here_) h = halfedge_[h];
    draft_.link_ring(kept_here_);
  }
}

// The vertices of the frame are numbered counter-clockwise from face 0, so the kept ends are in
// order.
void Simplifier::collect_ends() {
  for (std::size_t v = complex_.vertex_count(); v < dcel_.vertex_count(); ++v) {
    for (const HalfedgeId h : dcel_.around(VertexId(v))) {
      if (complex_.is_frame(h) || is_kept_[edge_of(h)] == 0) continue;
      draft_.ends.push_back(twin(halfedge_[h]));
    }
  }
}

// The class of a loop is the joined face of any of its old half-edges. Loops along the outer side
// of the frame have a class of their own.
PlaneFaceClasses Simplifier::class_loops(const PlaneLoops& loops) {
  const std::uint32_t beyond = static_cast<std::uint32_t>(dcel_.face_count());
  PlaneFaceClasses classes;
  classes.class_count = dcel_.face_count() + 1;
  classes.bottom = faces_.find(FaceId(0));
  for (const HalfedgeId h : loops.first) {
    const bool is_ordinary = h.value() < old_halfedge_.size();
    classes.of_loop.push_back(is_ordinary ? faces_.find(dcel_.face(old_halfedge_[h])) : beyond);
  }
  for (const FaceId f : isolated_face_) classes.of_isolated.push_back(faces_.find(f));
  return classes;
}

FinishedDraft Simplifier::finished(PlanePoints&& points) {
  chain_edges();
  link_vertices();
  collect_ends();
  draft_.bottom_mark = complex_.marks.face[0];
  close_frame(draft_);
  const PlaneLoops loops = trace_loops(draft_);
  const PlaneFaceClasses classes = class_loops(loops);
  return finish(draft_, loops, classes, std::move(points));
}

PlaneComplex Simplifier::minimal(PlanePoints&& points) {
  drop_edges();
  place_vertices();
  return finished(std::move(points)).complex;
}

ReducedComplex Simplifier::reduced(std::span<const std::uint8_t> is_kept,
                                   std::span<const std::uint8_t> is_corner) {
  for (std::size_t i = 0; i < is_kept.size(); ++i) {
    is_kept_[i] = is_kept[i];
    if (is_kept[i] == 0) drop_edge(EdgeId(i));
  }
  for (std::size_t i = 0; i < is_corner.size(); ++i) place_corner(VertexId(i), is_corner[i] != 0);
  FinishedDraft result = finished(PlanePoints(complex_.points));
  ReducedComplex reduced{std::move(result.complex), {}};
  reduced.merged.reserve(result.first_of_face.size());
  for (const HalfedgeId h : result.first_of_face) {
    reduced.merged.push_back(h.is_valid() ? dcel_.face(old_halfedge_[h]) : FaceId(0));
  }
  return reduced;
}

// Combines the mark of each edge with those of the faces beside it, and the mark of each vertex
// with those of all cells around it.
template <class Combine>
PlaneMarks neighbourhood_marks(const PlaneComplex& complex, Combine boolean_op) {
  PlaneMarks marks = complex.marks;
  for (std::size_t i = 0; i < complex.edge_count(); ++i) {
    const HalfedgeId h = first_half(EdgeId(i));
    marks.edge[i] = boolean_op(marks.edge[i], boolean_op(complex.mark(complex.dcel.face(h)),
                                                         complex.mark(complex.dcel.face(twin(h)))))
                        ? 1
                        : 0;
  }
  for (std::size_t i = 0; i < complex.vertex_count(); ++i) {
    const VertexId v(i);
    bool mark = complex.mark(v);
    if (complex.dcel.is_isolated(v)) {
      mark = boolean_op(mark, complex.mark(complex.dcel.face(complex.dcel.isolated_loop(v))));
    } else {
      // The new marks of the edges already include the marks of the faces beside them.
      for (const HalfedgeId h : complex.dcel.around(v)) {
        mark = boolean_op(mark, marks.edge[edge_of(h)] != 0);
      }
    }
    marks.vertex[i] = mark ? 1 : 0;
  }
  return marks;
}

}  // namespace

PlaneComplex simplify(PlaneComplex complex) {
  return Simplifier(complex).minimal(std::move(complex.points));
}

ReducedComplex without_edges(const PlaneComplex& complex, std::span<const std::uint8_t> is_kept,
                             std::span<const std::uint8_t> is_corner) {
  PLUMB_CHECK(is_kept.size() == complex.edge_count());
  PLUMB_CHECK(is_corner.size() == complex.vertex_count());
  return Simplifier(complex).reduced(is_kept, is_corner);
}

PlaneMarks interior_marks(const PlaneComplex& complex) {
  return neighbourhood_marks(complex, [](bool a, bool b) { return a && b; });
}

PlaneMarks closure_marks(const PlaneComplex& complex) {
  return neighbourhood_marks(complex, [](bool a, bool b) { return a || b; });
}

}  // namespace plumb
