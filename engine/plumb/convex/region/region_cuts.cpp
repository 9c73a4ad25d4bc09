// Cuts that prolong sides, and the making of convex parts.
//
// SideCutter shoots a ray from a corner along one of its sides and takes the first thing it meets
// in its own loop, by exact comparisons of crossings; ends at infinity are placed in the circular
// order of the frame by signs of cross products alone. If the ray of one of the two sides at a
// reflex corner ends at another reflex corner, this side is prolonged, because such a cut resolves
// two corners.
//
// PieceMaker builds a set from sides and marks by the sweep that all operations use, with a rule
// (PieceRule) that reads marks instead of combining operands. A cut belongs to the loop along its
// line, so it goes to one of the two parts beside it; a vertex goes to the first loop that reaches
// it. Bounds: docs/convex.md and plane_partition.h.
// Tested by tests/convex/plane_partition_test.cpp.
#include "plumb/convex/region/region_cuts.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/plane/complex/plane_rules.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

/// The rule of a sweep over curves and points that have their own marks. The label is 1 inside.
class PieceRule {
 public:
  using Label = std::int8_t;
  using Value = BundlePair;  // An edge has two sides.
  static constexpr bool kKeepsAll = false;
  static constexpr bool kKeepsLabels = false;

  PieceRule(std::span<const std::int8_t> jumps, std::span<const std::uint8_t> marks,
            std::vector<std::uint8_t> point_marks, bool is_bottom_inside)
      : jumps_(jumps),
        marks_(marks),
        point_marks_(std::move(point_marks)),
        bottom_(is_bottom_inside ? 1 : 0) {}

  Label bottom() const { return bottom_; }
  // Sides have the direction of their lines, and lines point upwards.
  void start(const SweepCurves&) {}
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

/// Numbers a point. Input points get their numbers immediately. Crossings are only listed at first,
/// and are numbered after all input points.
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

/// Copies the points of the sides to a new table, input points before crossings, and sweeps.
/// Therefore the time for a part depends on the size of the part, not on the size of the whole
/// region.
Nef2 PieceMaker::build(Context& context) {
  if (sides_.empty()) return Nef2::whole();
  std::vector<std::uint32_t> crossings;
  // A convex part contains the lower end of the plane if its interior is on that side of all its
  // sides.
  bool is_bottom_inside = true;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const SweepCurve& s = sides_[i];
    for (const std::uint32_t p : {s.from, s.to, s.a, s.b}) dense(p, crossings);
    const bool is_upright = compare_x(points_, s.a, s.b) == Sign::Zero;
    is_bottom_inside &= jumps_[i] == (is_upright ? 1 : -1);
  }
  SweepInput scene;
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
  Nef2 piece = Nef2::from_minimal_unchecked(build_complex(scene, rule, context));
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
  IdVector<HalfedgeId, std::uint8_t> is_done(region.halfedge_count(), 0);
  IdVector<VertexId, std::uint8_t> is_free = region.vertex_mark;
  const auto end = [&region](VertexId v) {
    return region.is_at_infinity(v) ? SweepCurve::kUnbounded : region.point(v);
  };
  const auto add = [&](HalfedgeId h) {
    if (region.is_on_frame(h)) return;
    const EdgeId e = edge_of(h);
    const HalfedgeId along = first_half(e);
    const PlaneLine& line = region.line[e];
    const bool is_mine = region.is_cut[e] == 0 || h == along;
    maker.add_side({end(region.start(along)), end(region.target(along)), line.a, line.b},
                   h == along ? Sign::Positive : Sign::Negative,
                   is_mine && region.edge_mark[e] != 0);
    const VertexId v = region.start(h);
    if (std::exchange(is_free[v], 0) != 0) maker.add_point(region.point(v));
  };
  for (std::uint32_t i = 0; i < region.halfedge_count(); ++i) {
    if (is_done[i] != 0 || !region.is_inside(HalfedgeId(i))) continue;
    context.checkpoint("convex pieces", i, region.halfedge_count());
    for (HalfedgeId h(i); is_done[h] == 0; h = region.after(h)) {
      is_done[h] = 1;
      add(h);
    }
    pieces.push_back(maker.build(context));
  }
}

namespace {

/// Cuts one region.
class SideCutter {
 public:
  SideCutter(PlaneRegion& region, Context& context) : r_(region), context_(context) {}

  void run() {
    join_loops();
    // New edges are appended. A corner that is not reflex never becomes reflex.
    for (std::uint32_t i = 0; i < r_.halfedge_count(); ++i) {
      const HalfedgeId h(i);
      if (!r_.is_inside(h) || !r_.is_reflex(h)) continue;
      context_.checkpoint(kPartitionPhase, i, r_.halfedge_count());
      resolve(h);
    }
  }

 private:
  /// The point where a ray ends: a corner, or a crossing with an edge.
  struct Hit {
    Corner at;
    std::uint32_t vertex_point = kCrossing;  ///< Point of a corner.
    Crossing2 crossing{};                    ///< Crossing with an edge.
    bool is_corner() const { return vertex_point != kCrossing; }
  };
  static constexpr std::uint32_t kCrossing = ~std::uint32_t{0};

  // ---------------------------------------------------------------- rays

  /// Returns the side of the ray on which a half-edge starts (ends), even if this is at infinity.
  Sign start_side(Heading ray, HalfedgeId h) const {
    const VertexId v = r_.start(h);
    if (!r_.is_at_infinity(v)) return r_.side(ray, r_.point(v));
    const Sign s = -r_.cross(ray, r_.heading(h));
    return s != Sign::Zero || r_.is_at_infinity(r_.target(h)) ? s : end_side(ray, h);
  }
  Sign end_side(Heading ray, HalfedgeId h) const {
    const VertexId v = r_.target(h);
    if (!r_.is_at_infinity(v)) return r_.side(ray, r_.point(v));
    const Sign s = r_.cross(ray, r_.heading(h));
    return s != Sign::Zero || r_.is_at_infinity(r_.start(h)) ? s : start_side(ray, h);
  }

  Sign compare(const Hit& x, const Hit& y) const {
    const PointTable2& inputs = r_.points.inputs;
    if (x.is_corner() && y.is_corner()) {
      return compare_xy(r_.points, x.vertex_point, y.vertex_point);
    }
    if (x.is_corner()) return -compare(y, x);
    if (y.is_corner()) return compare_xy(r_.points, x.crossing, y.vertex_point);
    return compare_xy(inputs, x.crossing, y.crossing);
  }

  void offer(Heading ray, const Hit& hit) {
    if (best_) {
      const Sign order = compare(hit, *best_);
      if (order != (ray.back ? Sign::Positive : Sign::Negative)) return;
    }
    best_ = hit;
  }

  /// Tries a corner on the ray. The corner is used if it is ahead and the ray arrives within its
  /// wedge.
  void try_corner(Heading ray, std::uint32_t from, HalfedgeId h) {
    const std::uint32_t p = r_.point(r_.start(h));
    if (r_.ahead(ray, p, from) != Sign::Positive || !r_.leads_into(h, ray.reversed())) return;
    offer(ray, {h, p, {}});
  }

  /// Tries the crossing with a half-edge. Requires that the half-edge starts right of the ray and
  /// ends left of it.
  void try_edge(Heading ray, std::uint32_t from, HalfedgeId h) {
    const Heading x = r_.heading(h);
    if (r_.side(x, from) != Sign::Positive) return;
    offer(ray, {h, kCrossing,
                make_crossing(r_.points.inputs, ray.line.a, ray.line.b, x.line.a, x.line.b)});
  }

  /// Returns the first point of a loop that a ray meets, or no value if the ray reaches infinity.
  std::optional<Hit> shoot(Heading ray, std::uint32_t from, HalfedgeId loop) {
    best_.reset();
    HalfedgeId h = loop;
    do {
      if (!r_.is_on_frame(h)) {
        const Sign start = start_side(ray, h);
        if (start == Sign::Zero && !r_.is_at_infinity(r_.start(h))) try_corner(ray, from, h);
        if (start == Sign::Negative && end_side(ray, h) == Sign::Positive) try_edge(ray, from, h);
      }
      h = r_.after(h);
    } while (h != loop);
    return best_;
  }

  // ---------------------------------------------------------------- infinity

  /// Whether the ray ends on this edge of the frame. The ends of the edge are those of the sides
  /// before and after it, counter-clockwise.
  bool ends_on(Heading ray, std::uint32_t from, HalfedgeId frame) const {
    if (r_.before(frame) == frame) return true;
    const Heading first = r_.heading(r_.before(frame));
    const Heading last = r_.heading(r_.after(frame)).reversed();
    const auto is_equal = [this](Heading x, Heading y) {
      return r_.cross(x, y) == Sign::Zero && PlaneRegion::is_same_way(x, y);
    };
    const bool is_left = r_.side(first, from) == Sign::Positive;
    const bool is_right = r_.side(last, from) == Sign::Negative;
    // Two parallel ends bound either a strip, or the rest of the plane.
    const bool is_strip = r_.side(first, last.line.a) == Sign::Positive;
    if (is_equal(ray, first) && is_equal(ray, last)) {
      return is_strip ? is_left && is_right : is_left || is_right;
    }
    if (is_equal(ray, first)) return is_left;
    if (is_equal(ray, last)) return is_right;
    const Sign wedge = r_.cross(first, last);
    const bool after_first = r_.cross(first, ray) == Sign::Positive;
    const bool before_last = r_.cross(ray, last) == Sign::Positive;
    if (wedge == Sign::Positive) return after_first && before_last;
    if (wedge == Sign::Negative) return after_first || before_last;
    return PlaneRegion::is_same_way(first, last) ? !is_strip : after_first;
  }

  Corner corner_at_infinity(Heading ray, std::uint32_t from, HalfedgeId loop) {
    HalfedgeId h = loop;
    while (!r_.is_on_frame(h) || !ends_on(ray, from, h)) {
      h = r_.after(h);
      PLUMB_CHECK(h != loop);
    }
    if (r_.before(h) == h) return h;
    return r_.split_edge(h, r_.add_vertex(PlaneRegion::kAtInfinity, false));
  }

  Corner corner_of(const Hit& hit) {
    if (hit.is_corner()) return hit.at;
    const EdgeId e = edge_of(hit.at.halfedge());
    r_.points.crossings.push_back(hit.crossing);
    const bool mark = r_.edge_mark[e] != 0;
    const auto point = static_cast<std::uint32_t>(r_.points.size() - 1);
    return r_.split_edge(hit.at.halfedge(), r_.add_vertex(point, mark));
  }

  /// Cuts from a corner along a heading, up to the hit or to infinity.
  void cut(Corner from, Heading ray, const std::optional<Hit>& hit, HalfedgeId loop) {
    const std::uint32_t point = r_.point(r_.vertex_at(from));
    const Corner to = hit ? corner_of(*hit) : corner_at_infinity(ray, point, loop);
    r_.add_edge(from, to, ray);
  }

  // ---------------------------------------------------------------- steps

  /// Resolves a reflex corner. If the ray of one side reaches another reflex corner, this side is
  /// prolonged; otherwise, the first side.
  void resolve(HalfedgeId h) {
    const std::uint32_t from = r_.point(r_.start(h));
    const auto gets_to_corner = [this](const std::optional<Hit>& hit) {
      return hit && hit->is_corner() && r_.is_reflex(hit->at.halfedge());
    };
    const Heading first = r_.heading(r_.before(h)), second = r_.heading(h).reversed();
    const std::optional<Hit> hit = shoot(first, from, h);
    if (!gets_to_corner(hit)) {
      const std::optional<Hit> other = shoot(second, from, h);
      if (gets_to_corner(other)) return cut(h, second, other, h);
    }
    cut(h, first, hit, h);
  }

  VertexId least_vertex(Corner loop) const {
    if (loop.is_other()) return loop.other();
    VertexId least = r_.start(loop.halfedge());
    for (HalfedgeId h = r_.after(loop.halfedge()); h != loop.halfedge(); h = r_.after(h)) {
      if (is_less(r_.start(h), least)) least = r_.start(h);
    }
    return least;
  }
  bool is_less(VertexId v, VertexId w) const {
    if (r_.is_at_infinity(v) || r_.is_at_infinity(w)) return r_.is_at_infinity(v) && v != w;
    return compare_xy(r_.points, r_.point(v), r_.point(w)) == Sign::Negative;
  }

  /// Loops are joined in the order of their least vertices. The ray from such a vertex leads to
  /// lesser points. There it meets only loops that were joined before, or infinity.
  void join_loops() {
    struct Loop {
      Corner at;
      VertexId least;
      std::uint32_t level_point;
    };
    std::vector<Loop> loops;
    std::uint32_t level_point = r_.first_level_point;
    for (const Corner& c : r_.loops) {
      loops.push_back({c, least_vertex(c), level_point});
      level_point += c.is_other() ? 1 : 0;
    }
    // The outer ring comes first. In an unbounded region, it is the ring with the frame.
    std::ranges::sort(loops,
                      [this](const Loop& x, const Loop& y) { return is_less(x.least, y.least); });
    for (std::size_t i = 1; i < loops.size(); ++i) {
      context_.checkpoint(kPartitionPhase, i, loops.size());
      const auto& [at, least, level] = loops[i];
      if (at.is_other()) {
        join(at, {{r_.point(least), level}, true}, loops.front().at.halfedge());
      } else {
        const HalfedgeId h = reflex_corner_at(least, at.halfedge());
        join(h, r_.heading(h).reversed(), loops.front().at.halfedge());
      }
    }
  }
  void join(Corner from, Heading ray, HalfedgeId outer) {
    cut(from, ray, shoot(ray, r_.point(r_.vertex_at(from)), outer), outer);
  }

  HalfedgeId reflex_corner_at(VertexId v, HalfedgeId loop) const {
    HalfedgeId h = loop;
    while (r_.start(h) != v || !r_.is_reflex(h)) h = r_.after(h);
    return h;
  }

  PlaneRegion& r_;
  Context& context_;
  std::optional<Hit> best_;
};

}  // namespace

void cut_by_sides(PlaneRegion& region, Context& context) {
  SideCutter(region, context).run();
  drop_superfluous(region);
}

void drop_superfluous(PlaneRegion& region) {
  const auto is_free = [&region](HalfedgeId h) {
    if (region.is_at_infinity(region.start(h))) return true;
    return region.is_convex_turn(region.after(twin(h)), twin(region.before(h)));
  };
  for (std::uint32_t e = 0; e < region.is_cut.size(); ++e) {
    const HalfedgeId h = first_half(EdgeId(e));
    if (region.is_cut[e] == 0 || !region.is_inside(h)) continue;
    if (is_free(h) && is_free(twin(h))) region.remove_edge(h);
  }
}

}  // namespace plumb
