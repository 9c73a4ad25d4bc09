#include "plumb/convex/plane_pieces.h"

#include <algorithm>
#include <utility>

#include "plumb/plane/plane_rules.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};

/// Curves and points with marks of their own. The label is 1 inside.
class PieceRule {
 public:
  using Label = std::int8_t;
  using Value = BundlePair;  // an edge has two sides
  static constexpr bool kKeepsAll = false;
  static constexpr bool kKeepsLabels = false;

  PieceRule(std::span<const std::int8_t> jumps, std::span<const std::uint8_t> marks,
            std::vector<std::uint8_t> point_marks, bool is_bottom_inside)
      : jumps_(jumps),
        marks_(marks),
        point_marks_(std::move(point_marks)),
        bottom_(is_bottom_inside ? 1 : 0) {}

  Label bottom() const { return bottom_; }
  void start(const SweepCurves&) {}  // sides run along their lines, and lines upwards
  void begin_change() const {}
  void join(Value& value, SegmentId s) const { value.join(s); }
  void leave(Value& value, SegmentId s) const { value.leave(s); }
  Label above(Label below, Value value) const { return moved(below, jump(value)); }
  Label below(Label above, Value value) const { return moved(above, -jump(value)); }
  bool face_mark(Label l) const { return l > 0; }
  bool edge_mark(Label, Label, Value value) const { return marks_[value.first.value()] != 0; }
  bool vertex_mark(const PlaneSurroundings<PieceRule>& at) const {
    return std::ranges::any_of(at.event.points,
                               [this](std::uint32_t p) { return point_marks_[p] != 0; });
  }
  void keep_edge(Value) {}

 private:
  int jump(Value value) const {
    int sum = 0;
    for (const SegmentId s : {value.first, value.second})
      sum += s.is_valid() ? jumps_[s.value()] : 0;
    return sum;
  }
  static Label moved(Label l, int by) { return static_cast<Label>(l + by); }

  std::span<const std::int8_t> jumps_;
  std::span<const std::uint8_t> marks_;
  std::vector<std::uint8_t> point_marks_;
  Label bottom_;
};

}  // namespace

PieceMaker::PieceMaker(const PlanePoints& points) : points_(points), local_(points.size(), kNone) {}

void PieceMaker::add_side(const SweepCurve& side, Sign inside, bool mark) {
  sides_.push_back(side);
  jumps_.push_back(static_cast<std::int8_t>(inside));
  marks_.push_back(mark ? 1 : 0);
}

std::uint32_t PieceMaker::input(std::uint32_t point) {
  if (local_[point] == kNone) {
    local_[point] = static_cast<std::uint32_t>(inputs_.size());
    inputs_.push_back(point);
  }
  return local_[point];
}

/// Inputs first; crossings are only listed.
std::uint32_t PieceMaker::dense(std::uint32_t point, std::vector<std::uint32_t>& crossings) {
  const PlanePointsView all(points_);
  if (point == SweepCurve::kUnbounded) return point;
  if (all.is_input(point)) return input(point);
  if (local_[point] == kNone) {
    const Crossing2& x = all.crossing(point);
    for (const std::uint32_t p : {x.a, x.b, x.c, x.d}) input(p);
    local_[point] = static_cast<std::uint32_t>(crossings.size());
    crossings.push_back(point);
  }
  return kNone;
}

Nef2 PieceMaker::build(Context& context) {
  if (sides_.empty()) return Nef2::plane();
  std::vector<std::uint32_t> crossings;
  // A convex piece holds the end of the plane if all its sides have it on that side.
  bool is_bottom_inside = true;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const SweepCurve& s = sides_[i];
    for (const std::uint32_t p : {s.from, s.to, s.a, s.b}) dense(p, crossings);
    const bool is_upright = compare_x(points_, s.a, s.b) == Sign::Zero;
    is_bottom_inside &= jumps_[i] == (is_upright ? 1 : -1);
  }
  PlaneScene scene;
  for (const std::uint32_t p : inputs_) {
    if (points_.inputs.is_double(p)) {
      scene.points.inputs.push_back(points_.inputs.approx(p));
    } else {
      const RationalPoint2 at = points_.inputs.exact(p);
      scene.points.inputs.push_back(at.x, at.y);
    }
  }
  for (const std::uint32_t p : crossings) {
    Crossing2 x = PlanePointsView(points_).crossing(p);
    for (std::uint32_t* const at : {&x.a, &x.b, &x.c, &x.d}) *at = local_[*at];
    scene.points.crossings.push_back(x);
    local_[p] += static_cast<std::uint32_t>(inputs_.size());
  }
  for (SweepCurve s : sides_) {
    for (std::uint32_t* const at : {&s.from, &s.to, &s.a, &s.b}) {
      if (*at != SweepCurve::kUnbounded) *at = local_[*at];
    }
    scene.curves.push_back(s);
  }
  std::vector<std::uint8_t> point_marks(scene.points.size(), 0);
  for (const std::uint32_t p : marked_) point_marks[local_[p]] = 1;
  PieceRule rule(jumps_, marks_, std::move(point_marks), is_bottom_inside);
  Nef2 piece = Nef2::from_minimal(build_complex(scene, rule, context));
  for (const auto* const used : {&inputs_, &crossings}) {
    for (const std::uint32_t p : *used) local_[p] = kNone;
  }
  inputs_.clear();
  sides_.clear();
  jumps_.clear();
  marks_.clear();
  marked_.clear();
  return piece;
}

void add_pieces(const PlaneRegion& region, std::vector<Nef2>& pieces, Context& context) {
  MemoryCharge memory(context);
  memory.add(region.points.size() * sizeof(std::uint32_t) + region.halfedge_count() +
                 region.vertex_count(),
             "convex pieces");
  PieceMaker maker(region.points);
  std::vector<std::uint8_t> is_done(region.halfedge_count(), 0);
  std::vector<std::uint8_t> is_free = region.vertex_mark;
  const auto end = [&region](VertexId v) {
    return region.is_at_infinity(v) ? SweepCurve::kUnbounded : region.point(v);
  };
  const auto add = [&](HalfedgeId h) {
    if (region.is_on_frame(h)) return;
    const EdgeId e = edge_of(h);
    const HalfedgeId along = first_half(e);
    const PlaneLine& line = region.line[e.value()];
    const bool is_mine = region.is_cut[e.value()] == 0 || h == along;
    maker.add_side({end(region.start(along)), end(region.target(along)), line.a, line.b},
                   h == along ? Sign::Positive : Sign::Negative,
                   is_mine && region.edge_mark[e.value()] != 0);
    const VertexId v = region.start(h);
    if (std::exchange(is_free[v.value()], 0) != 0) maker.add_point(region.point(v));
  };
  for (std::uint32_t i = 0; i < region.halfedge_count(); ++i) {
    if (is_done[i] != 0 || !region.is_inside(HalfedgeId(i))) continue;
    context.checkpoint("convex pieces", i, region.halfedge_count());
    for (HalfedgeId h(i); is_done[h.value()] == 0; h = region.after(h)) {
      is_done[h.value()] = 1;
      add(h);
    }
    pieces.push_back(maker.build(context));
  }
}

}  // namespace plumb
