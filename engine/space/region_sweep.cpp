#include "plumb/space/region_sweep.h"

#include <algorithm>
#include <numeric>

namespace plumb {

RegionSweep::RegionSweep(const PlanarPoints& points, std::span<const IndexEdge> edges,
                         Context* context)
    : points_(points), status_(Below{this}), context_(context) {
  rank_points();
  edges_.reserve(edges.size());
  for (const IndexEdge& e : edges) {
    const std::uint32_t from = rank_[e[0]], to = rank_[e[1]];
    edges_.push_back({std::min(from, to), std::max(from, to), from < to});
  }
}

void RegionSweep::rank_points() {
  order_.resize(points_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::sort(order_.begin(), order_.end(), [&](std::uint32_t i, std::uint32_t j) {
    count_step();
    return points_.compare(i, j) == Sign::Negative;
  });
  rank_.resize(order_.size());
  for (std::uint32_t r = 0; r < order_.size(); ++r) rank_[order_[r]] = r;
}

void RegionSweep::start() {
  starts_.resize(edges_.size());
  std::iota(starts_.begin(), starts_.end(), 0U);
  std::sort(starts_.begin(), starts_.end(), [&](std::uint32_t a, std::uint32_t b) {
    count_step();
    if (edges_[a].left != edges_[b].left) return edges_[a].left < edges_[b].left;
    return a != b && is_below(a, b);
  });
  place_.resize(edges_.size());
  incoming_.assign(order_.size(), kNone);
}

/// The order of two edges that some vertical line meets, or that start together.
bool RegionSweep::is_below(std::uint32_t a, std::uint32_t b) const {
  const SweepEdge &p = edges_[a], &q = edges_[b];
  if (p.left == q.left) {
    const Sign side = turn(a, q.right);
    // The two halves of a slit: what is below it ends before what is above begins.
    return side == Sign::Zero ? !p.is_lower && q.is_lower : side == Sign::Positive;
  }
  if (p.left < q.left) return turn(a, q.left) == Sign::Positive;
  return turn(b, p.left) == Sign::Negative;
}

std::pair<RegionSweep::Place, RegionSweep::Place> RegionSweep::edges_ending(std::uint32_t v) {
  if (incoming_[v] == kNone) {
    const Place at = status_.lower_bound(Probe{v});
    return {at, at};
  }
  Place begin = place_[incoming_[v]], end = std::next(begin);
  while (begin != status_.begin() && edges_[*std::prev(begin)].right == v) --begin;
  while (end != status_.end() && edges_[*end].right == v) ++end;
  return {begin, end};
}

}  // namespace plumb
