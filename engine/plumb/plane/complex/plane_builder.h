// Builds the complex of a sweep: the visitor that carries labels upward and keeps the cells of the
// minimal form. docs/design/sweep.md proves that labels are known (Lemma 2) and that the kept cells
// are the minimal complex (Lemma 3).
//
// Notation: a label describes a face of the arrangement. For a Boolean, it names the faces of both
// operands that contain the face. For polygons, it is a winding number. The value of a bundle
// describes all its curves together. An event reports the curves that join and leave, so its cost
// depends only on the changes. The rule (concept PlaneRule) defines what both mean.
//
// Main flow of on_event():
//  1. face_below        reads the label and support of the face just below (right of) the event
//                       from the bundle there; the support is a kept half-edge with that face to
//                       its left
//  2. label_outgoing    labels the outgoing bundles upward; a piece is kept if its mark differs
//                       from the mark of a face beside it
//  3. place_vertex      decides on a vertex: if nothing is kept here, an isolated one if its mark
//                       differs from that of its face; if one kept piece ends and one starts, on
//                       one line and with equal marks, none, and the edge passes; else a vertex
//  4. start_edges       starts edges for the kept outgoing pieces, and sets the states of all
// Main flow of build():
//  5. close_frame, trace_loops (plane_draft.h)
//  6. class_loops       finds the face of each loop: a loop is the outside of its component if its
//                       first vertex opens there to the left, and lies in the face of that vertex's
//                       support
//  7. finish
//
// One pass gives the minimal form, for three reasons. Whether a piece is kept does not depend on
// other pieces. Faces are the connected parts that the kept pieces leave. A vertex is superfluous
// only if it lies inside one straight edge or one face, and has the same mark.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/complex/plane_draft.h"
#include "plumb/plane/sweep/sweep.h"
#include "plumb/plane/sweep/sweep_curves.h"

namespace plumb {

/// The curves and points from which a complex is built.
struct SweepInput {
  PlanePoints points;                ///< All points to which curves and stops refer.
  std::vector<SweepCurve> curves;    ///< The curves.
  std::vector<std::uint32_t> stops;  ///< Points that are events whether curves end there or not.
};

template <class Rule>
struct PlaneSurroundings;

/// A rule: the meaning of labels and values. A default-constructed Value is the value of no curve.
template <class Rule>
concept PlaneRule = std::semiregular<typename Rule::Label> &&
    std::semiregular<typename Rule::Value> &&
    requires(Rule rule, typename Rule::Label label, typename Rule::Value value, SegmentId curve,
             const SweepCurves& curves, const PlaneSurroundings<Rule>& place) {
  // Whether every piece and point is kept, and whether build() returns the labels of faces.
  requires std::same_as<decltype(Rule::kKeepsAll), const bool>;
  requires std::same_as<decltype(Rule::kKeepsLabels), const bool>;
  // Called before the first event.
  rule.start(curves);
  // The label of face 0.
  { rule.bottom() } -> std::convertible_to<typename Rule::Label>;
  // The calls of join() and leave() up to the next call of begin_change() change one value: a
  // curve starts in a bundle, or ends in it.
  rule.begin_change();
  rule.join(value, curve);
  rule.leave(value, curve);
  // The label across a bundle, upward (leftward if the bundle is vertical), and back.
  { rule.above(label, value) } -> std::convertible_to<typename Rule::Label>;
  { rule.below(label, value) } -> std::convertible_to<typename Rule::Label>;
  // The marks. An edge has a label below it and one above it.
  { rule.face_mark(label) } -> std::convertible_to<bool>;
  { rule.edge_mark(label, label, value) } -> std::convertible_to<bool>;
  { rule.vertex_mark(place) } -> std::convertible_to<bool>;
  // The next edge begins with a piece of this value.
  rule.keep_edge(value);
};

/// The queries of a rule about the place of a vertex.
template <class Rule>
struct PlaneSurroundings {
  typename Rule::Label below;  ///< The label of the face just below (right of) the place.
  const SweepEvent& event;     ///< The event.
  std::span<const typename Rule::Value> incoming;  ///< Values of bundles; none at plain events.
  bool any_marked;                                 ///< Whether any piece or face there is marked.
  bool all_marked;                                 ///< Whether all of them are.
};

/// The visitor of a sweep that builds the complex. See the head of this file.
template <PlaneRule Rule>
class PlaneBuilder final : public SweepVisitor {
 public:
  using Label = typename Rule::Label;
  using Value = typename Rule::Value;

  PlaneBuilder(const SweepInput& scene, Rule& rule, Context& context)
      : scene_(scene), rule_(rule), memory_(context), first_bottom_(rule.bottom()) {
    bottom_.above = first_bottom_;
    bottom_.mark_above = rule_.face_mark(first_bottom_);
    draft_.bottom_mark = bottom_.mark_above ? 1 : 0;
  }

  void on_start(const SweepCurves& curves) override {
    curves_ = &curves;
    memory_.add(kBytesPerCurve * curves.size(), kMemoryName);
    states_.resize(curves.size());
    rule_.start(curves);
  }
  bool on_event(const SweepEvent& event) override;

  /// Gives each input point i the number to[i], which it has in the `points` of build(). For scenes
  /// that were renumbered. To be called after the sweep.
  void rename_points(std::span<const std::uint32_t> to);
  /// Returns the complex after the sweep. Sets `labels` to the label of each ordinary face, if the
  /// rule keeps them.
  PlaneComplex build(PlanePoints points, std::vector<Label>* labels = nullptr);

 private:
  /// A bundle and the face above it, kept under the curve that names it.
  struct State {
    Value value{};            ///< What the curves of the bundle are.
    Label above{};            ///< The label of the face above.
    HalfedgeId support;       ///< Has the face above to its left; not valid if that is face 0.
    EdgeId edge;              ///< The kept edge; not valid if the piece is not kept.
    bool mark = false;        ///< The mark of the piece.
    bool mark_above = false;  ///< The mark of the face above.
  };
  /// A vertex with nothing kept to its left.
  struct Opening {
    VertexId vertex;
    HalfedgeId corner;   ///< Leaves the vertex at its left corner; not valid if it is isolated.
    HalfedgeId support;  ///< The support of the face below the vertex.
  };
  /// An outgoing bundle of the event at hand.
  struct Piece {
    SegmentId curve;  // Names the bundle.
    State state;
    Label below;
    bool mark_below;
    bool is_kept;
  };

  void point_event(const SweepEvent& event);
  const State& face_below(const SweepEvent& event) const {
    return event.below.is_valid() ? states_[event.below] : bottom_;
  }
  void collect_incoming(const SweepEvent& event);
  void label_outgoing(const SweepEvent& event, const State& below);
  Value value_of(const SweepEvent& event, std::size_t out);
  Piece piece_above(const Label& below, bool mark_below, SegmentId curve, const Value& value) const;
  bool vertex_mark(const SweepEvent& event, const State& below) const;
  bool passes(bool mark) const;
  void place_vertex(const SweepEvent& event, const State& below);
  std::uint32_t point_of(const SweepEvent& event);
  void place_isolated(const SweepEvent& event, bool mark, const State& below);
  void start_edges(VertexId left, HalfedgeId support);
  void link_vertex(VertexId v, HalfedgeId support);
  VertexId new_vertex(const SweepEvent& event, bool mark);
  EdgeId new_edge(VertexId left, const Piece& piece);

  void start_vertical(const SweepEvent& event);
  void end_at_infinity(std::span<const SegmentId> incoming, std::vector<HalfedgeId>& ends);

  PlaneFaceClasses class_loops(const PlaneLoops& loops, HalfedgeId bottom_frame) const;

  /// Measured: with two edges for each vertex the whole work peaks at 320 bytes a vertex.
  static constexpr std::uint64_t kBytesPerVertex = 320;
  static constexpr std::size_t kVerticesPerCharge = 4096;
  static constexpr std::uint64_t kBytesPerCurve = 200;
  static constexpr const char* kMemoryName = "the subdivision of the plane";

  const SweepInput& scene_;
  Rule& rule_;
  MemoryCharge memory_;
  const SweepCurves* curves_ = nullptr;
  PlaneDraft draft_;
  IdVector<HalfedgeId, Label> labels_;  // The label of the face to the left of each half-edge.
  std::vector<Crossing2> new_crossings_;
  IdVector<SegmentId, State> states_;  // The state of the bundle that each curve names.
  State bottom_;                       // The face below everything.
  Label first_bottom_;                 // The label of face 0.
  std::vector<Opening> openings_;
  std::vector<HalfedgeId> left_ends_, right_ends_, up_ends_, down_ends_;  // In sweep order.

  // The event at hand.
  struct Incoming {
    EdgeId edge;
    SegmentId curve;
  };
  std::vector<Incoming> kept_in_;  // Kept incoming edges, bottom to top.
  std::vector<Value> values_in_;   // Values of incoming bundles, bottom to top.
  std::vector<Piece> pieces_;      // Outgoing bundles, bottom to top.
  std::size_t kept_out_ = 0;
  bool any_marked_ = false;
  bool all_marked_ = true;
  std::vector<HalfedgeId> ring_;
};

// ---------------------------------------------------------------- events

template <PlaneRule Rule>
bool PlaneBuilder<Rule>::on_event(const SweepEvent& event) {
  switch (event.place) {
    case SweepPlace::LeftInfinity: {
      label_outgoing(event, bottom_);
      start_edges(VertexId(), bottom_.support);
      break;
    }
    case SweepPlace::VerticalStart:
      start_vertical(event);
      break;
    case SweepPlace::Point:
      point_event(event);
      break;
    case SweepPlace::VerticalEnd:
      end_at_infinity(event.incoming, up_ends_);
      break;
    case SweepPlace::RightInfinity:
      end_at_infinity(event.incoming, right_ends_);
      break;
  }
  return true;
}

template <PlaneRule Rule>
void PlaneBuilder<Rule>::point_event(const SweepEvent& event) {
  const State below = face_below(event);
  any_marked_ = all_marked_ = below.mark_above;
  collect_incoming(event);
  label_outgoing(event, below);
  place_vertex(event, below);
}

template <PlaneRule Rule>
void PlaneBuilder<Rule>::collect_incoming(const SweepEvent& event) {
  kept_in_.clear();
  values_in_.clear();
  for (const SegmentId bundle : event.incoming) {
    const State& state = states_[bundle];
    if (state.edge.is_valid()) kept_in_.push_back({state.edge, bundle});
    if (!event.plain) values_in_.push_back(state.value);
    any_marked_ = any_marked_ || state.mark || state.mark_above;
    all_marked_ = all_marked_ && state.mark && state.mark_above;
  }
}

template <PlaneRule Rule>
typename PlaneBuilder<Rule>::Value PlaneBuilder<Rule>::value_of(const SweepEvent& event,
                                                                std::size_t out) {
  Value value{};
  rule_.begin_change();
  if (const std::uint32_t in = event.came_from(out); in != SweepEvent::kNew) {
    value = values_in_[in];
    for (const SegmentId s : event.ending_in(in)) rule_.leave(value, s);
  }
  for (const SegmentId s : event.starting_in(out)) rule_.join(value, s);
  return value;
}

template <PlaneRule Rule>
typename PlaneBuilder<Rule>::Piece PlaneBuilder<Rule>::piece_above(const Label& below,
                                                                   bool mark_below, SegmentId curve,
                                                                   const Value& value) const {
  Piece piece{curve, {}, below, mark_below, true};
  piece.state.value = value;
  piece.state.above = rule_.above(below, value);
  piece.state.mark = rule_.edge_mark(below, piece.state.above, value);
  piece.state.mark_above = rule_.face_mark(piece.state.above);
  piece.is_kept = Rule::kKeepsAll || piece.state.mark != mark_below ||
                  piece.state.mark != piece.state.mark_above;
  return piece;
}

template <PlaneRule Rule>
void PlaneBuilder<Rule>::label_outgoing(const SweepEvent& event, const State& below) {
  pieces_.clear();
  kept_out_ = 0;
  Label label = below.above;
  bool mark_below = below.mark_above;
  for (std::size_t i = 0; i < event.outgoing.size(); ++i) {
    pieces_.push_back(piece_above(label, mark_below, event.outgoing[i], value_of(event, i)));
    const Piece& piece = pieces_.back();
    label = piece.state.above;
    mark_below = piece.state.mark_above;
    if (piece.is_kept) ++kept_out_;
    any_marked_ = any_marked_ || piece.state.mark || piece.state.mark_above;
    all_marked_ = all_marked_ && piece.state.mark && piece.state.mark_above;
  }
}

// ---------------------------------------------------------------- vertices

template <PlaneRule Rule>
bool PlaneBuilder<Rule>::vertex_mark(const SweepEvent& event, const State& below) const {
  return rule_.vertex_mark(
      PlaneSurroundings<Rule>{below.above, event, values_in_, any_marked_, all_marked_});
}

/// Whether the only kept piece to the left continues straight in the only kept piece to the right,
/// and both pieces and the place have the same mark.
template <PlaneRule Rule>
bool PlaneBuilder<Rule>::passes(bool mark) const {
  if (Rule::kKeepsAll || kept_in_.size() != 1 || kept_out_ != 1) return false;
  const auto piece =
      std::find_if(pieces_.begin(), pieces_.end(), [](const Piece& p) { return p.is_kept; });
  const bool in_mark = draft_.edge_mark[kept_in_.front().edge] != 0;
  if (piece->state.mark != mark || in_mark != mark) return false;
  return curves_->direction_order(kept_in_.front().curve, piece->curve) == Sign::Zero;
}

template <PlaneRule Rule>
std::uint32_t PlaneBuilder<Rule>::point_of(const SweepEvent& event) {
  if (!event.points.empty()) return event.points.front();
  new_crossings_.push_back(*event.crossing);
  return static_cast<std::uint32_t>(scene_.points.size() + new_crossings_.size() - 1);
}

template <PlaneRule Rule>
VertexId PlaneBuilder<Rule>::new_vertex(const SweepEvent& event, bool mark) {
  if ((draft_.vertex_count() + 1) % kVerticesPerCharge == 0) {
    memory_.add(kVerticesPerCharge * kBytesPerVertex, kMemoryName);
  }
  return draft_.add_vertex(point_of(event), mark);
}

template <PlaneRule Rule>
void PlaneBuilder<Rule>::place_vertex(const SweepEvent& event, const State& below) {
  const bool mark = vertex_mark(event, below);
  if (kept_in_.empty() && kept_out_ == 0) {
    place_isolated(event, mark, below);
    start_edges(VertexId(), below.support);
  } else if (passes(mark)) {
    for (Piece& piece : pieces_) {
      if (piece.is_kept) piece.state.edge = kept_in_.front().edge;
    }
    start_edges(VertexId(), below.support);
  } else {
    const VertexId v = new_vertex(event, mark);
    start_edges(v, below.support);
    link_vertex(v, below.support);
  }
}

template <PlaneRule Rule>
void PlaneBuilder<Rule>::place_isolated(const SweepEvent& event, bool mark, const State& below) {
  if (!Rule::kKeepsAll && mark == below.mark_above) return;
  const VertexId v = new_vertex(event, mark);
  draft_.isolated.push_back(v);
  openings_.push_back({v, HalfedgeId(), below.support});
}

template <PlaneRule Rule>
void PlaneBuilder<Rule>::link_vertex(VertexId v, HalfedgeId support) {
  ring_.clear();
  for (const Piece& piece : pieces_) {
    if (piece.is_kept) ring_.push_back(first_half(piece.state.edge));
  }
  if (kept_in_.empty()) openings_.push_back({v, ring_.back(), support});
  for (auto in = kept_in_.rbegin(); in != kept_in_.rend(); ++in) {
    draft_.end_edge(in->edge, v);
    ring_.push_back(twin(first_half(in->edge)));
  }
  draft_.link_ring(ring_);
}

template <PlaneRule Rule>
EdgeId PlaneBuilder<Rule>::new_edge(VertexId left, const Piece& piece) {
  const auto& curve = (*curves_)[piece.curve];
  const EdgeId e = draft_.add_edge(left, {curve.a, curve.b}, piece.state.mark,
                                   piece.state.mark_above, piece.mark_below);
  if constexpr (Rule::kKeepsLabels) {
    labels_.push_back(piece.state.above);
    labels_.push_back(piece.below);
  }
  rule_.keep_edge(piece.state.value);
  return e;
}

/// Sets the states of all outgoing pieces. Starts an edge for each kept piece that does not
/// continue an edge. Without a left vertex new edges come from infinity.
template <PlaneRule Rule>
void PlaneBuilder<Rule>::start_edges(VertexId left, HalfedgeId support) {
  for (Piece& piece : pieces_) {
    if (piece.is_kept && !piece.state.edge.is_valid()) {
      piece.state.edge = new_edge(left, piece);
      if (!left.is_valid()) left_ends_.push_back(twin(first_half(piece.state.edge)));
    }
    if (piece.is_kept) support = first_half(piece.state.edge);
    piece.state.support = support;
    states_[piece.curve] = piece.state;
  }
}

// ---------------------------------------------------------------- ends at infinity

/// The face to the left of the vertical is the bottom face so far. The face to its right is the new
/// bottom face.
template <PlaneRule Rule>
void PlaneBuilder<Rule>::start_vertical(const SweepEvent& event) {
  const Value value = value_of(event, 0);
  const Label below = rule_.below(bottom_.above, value);
  const bool mark_below = rule_.face_mark(below);
  Piece piece = piece_above(below, mark_below, event.outgoing.front(), value);
  piece.state.support = bottom_.support;
  bottom_.above = below;
  bottom_.mark_above = mark_below;
  if (piece.is_kept) {
    piece.state.edge = new_edge(VertexId(), piece);
    piece.state.support = first_half(piece.state.edge);
    bottom_.support = twin(first_half(piece.state.edge));
    down_ends_.push_back(bottom_.support);
  }
  states_[piece.curve] = piece.state;
}

template <PlaneRule Rule>
void PlaneBuilder<Rule>::end_at_infinity(std::span<const SegmentId> incoming,
                                         std::vector<HalfedgeId>& ends) {
  for (const SegmentId bundle : incoming) {
    const State& state = states_[bundle];
    if (state.edge.is_valid()) ends.push_back(first_half(state.edge));
  }
}

// ---------------------------------------------------------------- after the sweep

template <PlaneRule Rule>
PlaneFaceClasses PlaneBuilder<Rule>::class_loops(const PlaneLoops& loops,
                                                 HalfedgeId bottom_frame) const {
  PlaneFaceClasses classes;
  classes.class_count = loops.count() + 1;
  classes.bottom = bottom_frame.is_valid() ? loops.loop_of[bottom_frame]
                                           : static_cast<std::uint32_t>(loops.count());
  classes.of_loop.resize(loops.count());
  for (std::size_t l = 0; l < loops.count(); ++l)
    classes.of_loop[l] = static_cast<std::uint32_t>(l);
  const std::vector<VertexId> least = least_vertices(draft_, loops);
  const auto class_of = [&](HalfedgeId support) {
    return support.is_valid() ? classes.of_loop[loops.loop_of[support]] : classes.bottom;
  };
  for (const Opening& o : openings_) {
    if (!o.corner.is_valid()) {
      classes.of_isolated.push_back(class_of(o.support));
      continue;
    }
    const std::uint32_t l = loops.loop_of[o.corner];
    if (least[l] == o.vertex) classes.of_loop[l] = class_of(o.support);
  }
  return classes;
}

template <PlaneRule Rule>
void PlaneBuilder<Rule>::rename_points(std::span<const std::uint32_t> to) {
  for (std::uint32_t& p : draft_.vertex_point) {
    if (p < to.size()) p = to[p];
  }
  for (PlaneLine& l : draft_.line) l = {to[l.a], to[l.b]};
  for (Crossing2& c : new_crossings_) {
    c.a = to[c.a];
    c.b = to[c.b];
    c.c = to[c.c];
    c.d = to[c.d];
  }
}

template <PlaneRule Rule>
PlaneComplex PlaneBuilder<Rule>::build(PlanePoints points, std::vector<Label>* labels) {
  draft_.ends = std::move(down_ends_);
  draft_.ends.insert(draft_.ends.end(), right_ends_.begin(), right_ends_.end());
  draft_.ends.insert(draft_.ends.end(), up_ends_.rbegin(), up_ends_.rend());
  draft_.ends.insert(draft_.ends.end(), left_ends_.rbegin(), left_ends_.rend());
  const HalfedgeId bottom_frame = close_frame(draft_);
  const PlaneLoops loops = trace_loops(draft_);
  const PlaneFaceClasses classes = class_loops(loops, bottom_frame);
  points.crossings.insert(points.crossings.end(), new_crossings_.begin(), new_crossings_.end());
  FinishedDraft finished = finish(draft_, loops, classes, std::move(points));
  if (labels != nullptr) {
    labels->clear();
    for (const HalfedgeId h : finished.first_of_face) {
      labels->push_back(h.is_valid() ? labels_[h] : first_bottom_);
    }
  }
  return std::move(finished.complex);
}

}  // namespace plumb
