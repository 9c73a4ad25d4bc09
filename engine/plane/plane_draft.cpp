#include "plumb/plane/plane_draft.h"

#include <algorithm>
#include <utility>

#include "plumb/base/error.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNoFace = FaceId::kInvalid;

// ---------------------------------------------------------------- faces

// Face 0 first, then by least half-edge, then faces without any (there is at most one: the whole
// plane, which is face 0); the face beyond the frame has the greatest half-edges and comes last.
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
  std::vector<HalfedgeId> first_;  // per face
};

// ---------------------------------------------------------------- points

// Keeps the points that vertices, lines and kept crossings name, in their order.
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
    marks.face.push_back(h.is_valid() ? draft.left_mark[h.value()] : draft.bottom_mark);
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

// Between two neighbours, counter-clockwise, lies a corner of the face left of the first: who
// arrives along the second goes on along the first.
void PlaneDraft::link_ring(std::span<const HalfedgeId> leaving) {
  for (std::size_t i = 0; i < leaving.size(); ++i) {
    const HalfedgeId after = leaving[i + 1 < leaving.size() ? i + 1 : 0];
    next[twin(after).value()] = leaving[i];
  }
}

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
    draft.origin[twin(end).value()] = VertexId(vertices + i);
    draft.origin[along.value()] = VertexId(vertices + i);
    draft.origin[twin(along).value()] = VertexId(vertices + after);
    draft.next[end.value()] = along;
    draft.next[along.value()] = twin(draft.ends[after]);
    draft.next[twin(frame_edge(after)).value()] = twin(along);
    draft.left_mark[along.value()] = draft.left_mark[end.value()];
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
      loops.loop_of[h.value()] = static_cast<std::uint32_t>(loops.first.size());
      h = draft.next[h.value()];
    } while (h.value() != start);
    loops.first.emplace_back(start);
  }
  return loops;
}

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

}  // namespace plumb
