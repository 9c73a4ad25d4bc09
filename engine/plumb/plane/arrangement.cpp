// Arrangements of curves, and the persistent sets that say which input curves an edge came from.
//
// An arrangement is a sweep whose rule keeps every piece (OriginsRule, plane_rules.h). The sets of
// overlapping curves are treaps that share nodes: an event that changes a bundle by one curve
// copies a path of expected O(log n) nodes. Priorities are a hash of the keys, so a set has one
// shape, whatever the order of its changes. Nodes that were made since begin_change() belong only
// to the set that is being changed. If this set drops such a node again, the node is reused. So
// several changes in one event cost only the nodes of their result.
//
// Scenes of doubles are renumbered in the order of the sweep first, because then the data that one
// event touches are side by side in memory.
//
// Tested by tests/plane/arrangement_test.cpp.

#include "plumb/plane/arrangement.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "plumb/plane/complex/plane_builder.h"
#include "plumb/plane/complex/plane_rules.h"
#include "plumb/plane/sweep/sweep_curves.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

// Returns the priority of a curve by the last step of MurmurHash3 (A. Appleby). It is one to one,
// so no two priorities are equal.
std::uint32_t priority(SegmentId s) {
  std::uint32_t h = s.value();
  h = (h ^ (h >> 16U)) * 0x85EBCA6BU;
  h = (h ^ (h >> 13U)) * 0xC2B2AE35U;
  return h ^ (h >> 16U);
}

}  // namespace

void SegmentSets::begin_change() {
  own_from_ = nodes_.size();
  free_ = Set();
}

/// A set of one curve is the curve itself and needs no node.
SegmentSets::Set SegmentSets::make(SegmentId key, Set left, Set right) {
  if (!left.is_valid() && !right.is_valid()) return Set(key.value());
  if (free_.is_valid()) {
    const Set reused = free_;
    free_ = node(reused).left;
    node(reused) = {key, left, right};
    return reused;
  }
  if (curves_ + nodes_.size() >= Set::kInvalid) {
    throw Error(ErrorCode::ResourceLimit, "too many overlaps for ids of 32 bits");
  }
  nodes_.push_back({key, left, right});
  return Set(curves_ + nodes_.size() - 1);
}

/// Returns the node with other halves. The same memory is used if the node is not shared; otherwise
/// the node is copied.
SegmentSets::Set SegmentSets::with_halves(Set set, Set left, Set right) {
  const SegmentId s = key(set);
  release(set);
  return make(s, left, right);
}

/// Adds a node that is not shared to the list of free nodes, which are linked by their left halves.
void SegmentSets::release(Set set) {
  if (!is_own(set)) return;
  node(set).left = free_;
  free_ = set;
}

/// Splits a set into the curves less than `at` and the other curves. Requires that the set does not
/// contain `at`.
SegmentSets::Halves SegmentSets::split(Set set, SegmentId at) {
  if (!set.is_valid()) return {};
  if (key(set) < at) {
    const Halves h = split(right(set), at);
    return {with_halves(set, left(set), h.less), h.greater};
  }
  const Halves h = split(left(set), at);
  return {h.less, with_halves(set, h.greater, right(set))};
}

/// Joins two sets. Requires that all curves of the first set are less than those of the second set.
SegmentSets::Set SegmentSets::join(Set less, Set greater) {
  if (!less.is_valid()) return greater;
  if (!greater.is_valid()) return less;
  if (priority(key(less)) > priority(key(greater))) {
    return with_halves(less, left(less), join(right(less), greater));
  }
  return with_halves(greater, join(less, left(greater)), right(greater));
}

SegmentSets::Set SegmentSets::with(Set set, SegmentId s) {
  if (!set.is_valid()) return Set(s.value());
  if (priority(key(set)) < priority(s)) {
    const Halves h = split(set, s);
    return make(s, h.less, h.greater);
  }
  if (s < key(set)) return with_halves(set, with(left(set), s), right(set));
  return with_halves(set, left(set), with(right(set), s));
}

SegmentSets::Set SegmentSets::without(Set set, SegmentId s) {
  if (key(set) == s) {
    const Halves h{left(set), right(set)};
    release(set);
    return join(h.less, h.greater);
  }
  if (s < key(set)) return with_halves(set, without(left(set), s), right(set));
  return with_halves(set, left(set), without(right(set), s));
}

void SegmentSets::append(Set set, std::vector<SegmentId>& curves) const {
  std::vector<Set> path;
  while (set.is_valid() || !path.empty()) {
    for (; set.is_valid(); set = left(set)) path.push_back(set);
    curves.push_back(key(path.back()));
    set = right(path.back());
    path.pop_back();
  }
}

// Renumbering of scenes in the order of the sweep. For 10^5 segments in random order, this reduces
// the time of an arrangement by a sixth to a third.

/// A scene in the order of its sweep.
struct OrderedInput {
  SweepInput scene;                  ///< The renumbered scene.
  std::vector<std::uint32_t> point;  ///< The former number of each point of `scene`.
  std::vector<SegmentId> curve;      ///< The former number of each curve of `scene`.
};

/// Returns a scene with its points in lexicographic order, where equal points are sorted by number,
/// and its curves sorted by their left ends and then by number. A sweep of either scene meets the
/// same curves in the same order everywhere. Requires input points only, all of them doubles. O(n
/// log n). Throws the errors of the Context.
OrderedInput in_sweep_order(const SweepInput& scene, const Context& context);

namespace {

/// Returns the rank of the left end of each curve plus 1, and 0 for a curve from infinity.
std::vector<std::uint32_t> left_ranks(const SweepInput& scene, const PointRanks& ranks) {
  std::vector<std::uint32_t> left;
  left.reserve(scene.curves.size());
  for (const SweepCurve& c : scene.curves) {
    const bool is_bounded = c.from != SweepCurve::kUnbounded && c.to != SweepCurve::kUnbounded;
    const bool forward =
        is_bounded ? ranks.rank[c.from] <= ranks.rank[c.to] : ranks.rank[c.a] < ranks.rank[c.b];
    const std::uint32_t end = forward ? c.from : c.to;
    left.push_back(end == SweepCurve::kUnbounded ? 0 : ranks.rank[end] + 1);
  }
  return left;
}

/// Returns the curves sorted by the ranks of their left ends, and then by number.
std::vector<SegmentId> curves_by(const std::vector<std::uint32_t>& left, const Context& context) {
  constexpr std::uint64_t kStepsPerCheck = std::uint64_t{1} << 16;
  std::uint64_t steps = 0;
  std::vector<SegmentId> order;
  order.reserve(left.size());
  for (std::size_t i = 0; i < left.size(); ++i) order.emplace_back(i);
  std::sort(order.begin(), order.end(), [&](SegmentId s, SegmentId t) {
    if (++steps % kStepsPerCheck == 0) context.check_limits("sweep");
    const std::uint32_t l = left[s.value()];
    const std::uint32_t m = left[t.value()];
    return l != m ? l < m : s < t;
  });
  return order;
}

}  // namespace

OrderedInput in_sweep_order(const SweepInput& scene, const Context& context) {
  const PointTable2& points = scene.points.inputs;
  PointRanks ranks = rank_points(points, std::vector<char>(points.size(), 1), &context);
  context.check_limits("sweep");
  OrderedInput ordered;
  ordered.curve = curves_by(left_ranks(scene, ranks), context);
  context.check_limits("sweep");
  ordered.point = std::move(ranks.order);

  // From here on, the array has the new number of each point.
  std::vector<std::uint32_t>& place = ranks.rank;
  ordered.scene.points.inputs.reserve(points.size());
  for (std::uint32_t i = 0; i < ordered.point.size(); ++i) {
    ordered.scene.points.inputs.push_back(points.approx(ordered.point[i]));
    place[ordered.point[i]] = i;
  }
  const auto end = [&place](std::uint32_t p) { return p == SweepCurve::kUnbounded ? p : place[p]; };
  ordered.scene.curves.reserve(scene.curves.size());
  for (const SegmentId s : ordered.curve) {
    const SweepCurve& c = scene.curves[s.value()];
    ordered.scene.curves.push_back({end(c.from), end(c.to), place[c.a], place[c.b]});
  }
  for (const std::uint32_t p : scene.stops) ordered.scene.stops.push_back(place[p]);
  return ordered;
}

namespace {

PlaneComplex arranged_in_order(SweepInput& scene, OrderedInput ordered, OriginsRule& rule,
                               Context& context) {
  PlaneBuilder<OriginsRule> builder(ordered.scene, rule, context);
  sweep(ordered.scene.points, ordered.scene.curves, ordered.scene.stops, builder, context);
  builder.rename_points(ordered.point);
  ordered = {};
  return builder.build(std::move(scene.points));
}

/// Whether the points of a scene of bounded curves ascend, and its curves ascend by their left
/// ends, as those of a complex do. Requires only input points, all of them doubles.
bool is_in_sweep_order(const SweepInput& scene) {
  const PointTable2& points = scene.points.inputs;
  for (std::uint32_t i = 1; i < points.size(); ++i) {
    if (compare_xy(points, i - 1, i) != Sign::Negative) return false;
  }
  std::uint32_t last = 0;
  for (const SweepCurve& c : scene.curves) {
    const std::uint32_t left = std::min(c.from, c.to);
    if (left < last || std::max(c.from, c.to) == SweepCurve::kUnbounded) return false;
    last = left;
  }
  return true;
}

// Whether a scene should be renumbered. If some points are not doubles, exact arithmetic dominates
// the time, and the layout of memory does not matter.
bool is_worth_ordering(const SweepInput& scene) {
  return scene.points.crossings.empty() && scene.points.inputs.all_double() &&
         !is_in_sweep_order(scene);
}

/// Throws Error{BadIndex} if an index of a scene refers to no point.
void require_points(const SweepInput& scene) {
  const auto require = [](std::uint32_t i, std::size_t count) {
    if (i < count) return;
    throw Error(ErrorCode::BadIndex, "no point " + std::to_string(i) + ": there are " +
                                         std::to_string(count) + " points, from 0");
  };
  const std::size_t count = scene.points.size();
  for (const SweepCurve& curve : scene.curves) {
    for (const std::uint32_t end : {curve.from, curve.to}) {
      if (end != SweepCurve::kUnbounded) require(end, count);
    }
    for (const std::uint32_t i : {curve.a, curve.b}) require(i, scene.points.inputs.size());
  }
  for (const std::uint32_t i : scene.stops) require(i, count);
}

Arrangement arrange(SweepInput scene, Context& context) {
  require_points(scene);
  const bool is_ordered = is_worth_ordering(scene);
  OrderedInput ordered = is_ordered ? in_sweep_order(scene, context) : OrderedInput();
  OriginsRule rule(scene.curves.size(), std::move(ordered.curve), context);
  Arrangement result;
  result.complex = is_ordered ? arranged_in_order(scene, std::move(ordered), rule, context)
                              : build_complex(scene, rule, context);
  result.origin_sets = std::move(rule.sets);
  result.origins = std::move(rule.origins);
  return result;
}

}  // namespace

Arrangement arrange(const PlanePoints& points, std::span<const SweepCurve> curves,
                    std::span<const std::uint32_t> isolated, Context& context) {
  return arrange(
      SweepInput{points, {curves.begin(), curves.end()}, {isolated.begin(), isolated.end()}},
      context);
}

Arrangement arrange(PointTable2 points, std::span<const SweepSegment> segments, Context& context) {
  SweepInput scene;
  scene.points.inputs = std::move(points);
  scene.curves.reserve(segments.size());
  for (const SweepSegment& s : segments) scene.curves.push_back({s.from, s.to, s.from, s.to});
  return arrange(std::move(scene), context);
}

}  // namespace plumb
