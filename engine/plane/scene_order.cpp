#include "plumb/plane/scene_order.h"

#include <algorithm>
#include <utility>

#include "plumb/plane/point_ranks.h"

namespace plumb {
namespace {

/// Rank of the left end, those from infinity first.
std::vector<std::uint32_t> left_ranks(const PlaneScene& scene, const PointRanks& ranks) {
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

std::vector<SegmentId> curves_by(const std::vector<std::uint32_t>& left) {
  std::vector<SegmentId> order;
  order.reserve(left.size());
  for (std::size_t i = 0; i < left.size(); ++i) order.emplace_back(i);
  std::sort(order.begin(), order.end(), [&left](SegmentId s, SegmentId t) {
    const std::uint32_t l = left[s.value()];
    const std::uint32_t m = left[t.value()];
    return l != m ? l < m : s < t;
  });
  return order;
}

}  // namespace

OrderedScene in_sweep_order(const PlaneScene& scene) {
  const PointTable2& points = scene.points.inputs;
  PointRanks ranks = rank_points(points, std::vector<char>(points.size(), 1));
  OrderedScene ordered;
  ordered.curve = curves_by(left_ranks(scene, ranks));
  ordered.point = std::move(ranks.order);

  std::vector<std::uint32_t>& place = ranks.rank;  // from here on: per point its new number
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

}  // namespace plumb
