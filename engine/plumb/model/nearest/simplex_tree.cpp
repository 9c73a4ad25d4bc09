// The nearest points of two trees of simplices (simplex_tree.h).
//
// Invariant of the search: `limit_` is at least the distance of the trees, and every pair of
// simplices that was left out is farther apart than an earlier limit, and therefore farther than
// the distance. Limits only decrease. Therefore the nearest pair is always among the candidates.
// Tested by tests/model/distance_test.cpp.
#include "plumb/model/nearest/simplex_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

/// Returns a lower bound of the distance of two boxes, up to the slack.
double gap(const Box3& a, const Box3& b) {
  double squared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double apart = std::max({0.0, a.low[i] - b.high[i], b.low[i] - a.high[i]});
    squared += apart * apart;
  }
  return std::sqrt(squared);
}

}  // namespace

/// A search for the nearest simplices of two trees.
class NearestSearch {
 public:
  NearestSearch(const SimplexTree& a, const SimplexTree& b, Context& context)
      : a_(a),
        b_(b),
        context_(context),
        memory_(context),
        magnitude_(std::max(a.magnitude_, b.magnitude_)),
        slack_(slack_of(magnitude_, std::max(a.error, b.error))),
        are_doubles_of_use_(magnitude_ >= 0x1p-400 && magnitude_ <= 0x1p500) {}

  SimplexTree::Nearest run() {
    descend(0, 0);
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& x, const Candidate& y) {
      return std::pair(x.bounds.lower, std::pair(x.a, x.b)) <
             std::pair(y.bounds.lower, std::pair(y.a, y.b));
    });
    return decide();
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  struct Candidate {
    std::uint32_t a;
    std::uint32_t b;
    DistanceBounds bounds;
  };

  double apart(std::uint32_t m, std::uint32_t n) const {
    return are_doubles_of_use_ ? gap(a_.nodes_[m].box, b_.nodes_[n].box) - slack_ : 0;
  }

  // Opens the larger node, and visits the nearer half first.
  void descend(std::uint32_t m, std::uint32_t n) {
    if (++steps_ % 1024 == 0) context_.checkpoint("distance", 0, 0);
    const SimplexTree::Node &x = a_.nodes_[m], &y = b_.nodes_[n];
    if (x.second == 0 && y.second == 0) return meet(x, y);
    const bool opens_x = y.second == 0 || (x.second != 0 && x.end - x.begin >= y.end - y.begin);
    std::array<std::array<std::uint32_t, 2>, 2> halves{
        opens_x ? std::array{m + 1, n} : std::array{m, n + 1},
        opens_x ? std::array{x.second, n} : std::array{m, y.second}};
    std::array<double, 2> at{apart(halves[0][0], halves[0][1]), apart(halves[1][0], halves[1][1])};
    if (at[1] < at[0]) {
      std::swap(at[0], at[1]);
      std::swap(halves[0], halves[1]);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      if (at[i] <= limit_) descend(halves[i][0], halves[i][1]);
    }
  }

  void meet(const SimplexTree::Node& x, const SimplexTree::Node& y) {
    if (are_doubles_of_use_ && gap_along(x, y) - slack_ > limit_) return;
    for (std::uint32_t i = x.begin; i < x.end; ++i) {
      for (std::uint32_t j = y.begin; j < y.end; ++j) take(i, j);
    }
  }
  /// Returns how far the simplices of y lie beyond those of x along direction_.
  double gap_along(const SimplexTree::Node& x, const SimplexTree::Node& y) const {
    const std::array<double, 2> of_x = span_of(a_, x), of_y = span_of(b_, y);
    return of_y[0] - of_x[1];
  }
  /// Returns the least and the greatest coordinate along direction_ of the corners of a leaf.
  std::array<double, 2> span_of(const SimplexTree& tree, const SimplexTree::Node& leaf) const {
    std::array<double, 2> span{kInfinity, -kInfinity};
    for (std::uint32_t i = leaf.begin; i < leaf.end; ++i) {
      const RoundedSimplex& s = tree.rounded_[i];
      for (std::uint32_t k = 0; k < s.size; ++k) {
        const auto& p = s.corner[k];
        const double at = direction_[0] * p[0] + direction_[1] * p[1] + direction_[2] * p[2];
        span = {std::min(span[0], at), std::max(span[1], at)};
      }
    }
    return span;
  }

  /// Tries the pair of the simplices at places i and j of the orders.
  void take(std::uint32_t i, std::uint32_t j) {
    DistanceBounds bounds{0, kInfinity};
    if (are_doubles_of_use_) bounds = distance_bounds(a_.rounded_[i], b_.rounded_[j], slack_);
    if (bounds.lower > limit_) return;
    if (bounds.upper < limit_) {
      limit_ = bounds.upper;
      for (std::size_t k = 0; k < 3; ++k) direction_[k] = bounds.toward[k] / limit_;
    }
    if (candidates_.size() >= most_candidates_) drop_candidates();
    candidates_.push_back({a_.order_[i], b_.order_[j], bounds});
  }
  /// Drops the candidates that are farther apart than the limit, and charges memory for as many new
  /// candidates as remain.
  void drop_candidates() {
    const auto is_far = [this](const Candidate& c) { return c.bounds.lower > limit_; };
    candidates_.erase(std::remove_if(candidates_.begin(), candidates_.end(), is_far),
                      candidates_.end());
    const std::size_t most = std::max(most_candidates_, 2 * candidates_.size());
    memory_.add(2 * sizeof(Candidate) * (most - most_candidates_), "candidates of a distance");
    most_candidates_ = most;
  }

  SimplexTree::Nearest decide() {
    std::optional<SimplexTree::Nearest> nearest;
    for (const Candidate& c : candidates_) {
      context_.checkpoint("distance", 0, 0);
      if (nearest && is_greater_than_root(c.bounds.lower, nearest->points.squared)) break;
      const ExactSimplex s = a_.exact(c.a), t = b_.exact(c.b);
      NearestPoints points = nearest_points(s, c.bounds.a, t, c.bounds.b);
      if (nearest && points.squared >= nearest->points.squared) continue;
      nearest = SimplexTree::Nearest{c.a, c.b, std::move(points)};
      if (nearest->points.squared.is_zero()) break;
    }
    return std::move(*nearest);
  }
  static bool is_greater_than_root(double lower, const Rational& squared) {
    if (lower == 0) return false;
    const Rational exact = exact_rational(lower);
    return exact * exact > squared;
  }

  const SimplexTree& a_;
  const SimplexTree& b_;
  Context& context_;
  MemoryCharge memory_;
  double magnitude_;
  double slack_;
  bool are_doubles_of_use_;
  double limit_ = kInfinity;
  std::array<double, 3> direction_ = {0, 0, 0};  // The vector is not longer than 1.
  std::vector<Candidate> candidates_;
  std::size_t most_candidates_ = 1024;
  std::uint64_t steps_ = 0;
};

void SimplexTree::build(Context& context) {
  for (const auto& at : vertex) {
    for (const double x : at) magnitude_ = std::max(magnitude_, std::abs(x));
  }
  std::vector<Placed> placed;
  placed.reserve(simplex.size());
  for (std::uint32_t s = 0; s < simplex.size(); ++s) placed.push_back({vertex[simplex[s][0]], s});
  nodes_.reserve(simplex.size());
  order_.reserve(simplex.size());
  rounded_.reserve(simplex.size());
  add_node(placed, 0, static_cast<std::uint32_t>(simplex.size()), context);
}

// The simplices are halved at the middle one along the direction in which they extend most. Boxes
// grow from the leaves upward.
std::uint32_t SimplexTree::add_node(std::vector<Placed>& placed, std::uint32_t begin,
                                    std::uint32_t end, Context& context) {
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  if (at % 1024 == 1023) context.checkpoint("distance", 0, 0);
  nodes_.push_back({{}, begin, end, 0});
  if (end - begin <= kLeaf) {
    for (std::uint32_t i = begin; i < end; ++i) {
      order_.push_back(placed[i].simplex);
      rounded_.push_back(rounded(placed[i].simplex));
      for (std::uint32_t k = 0; k < rounded_.back().size; ++k) {
        nodes_[at].box.add({rounded_.back().corner[k], rounded_.back().corner[k]});
      }
    }
    return at;
  }
  Box3 corners;
  for (std::uint32_t i = begin; i < end; ++i) corners.add({placed[i].at, placed[i].at});
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (corners.high[i] - corners.low[i] > corners.high[axis] - corners.low[axis]) axis = i;
  }
  const auto first = placed.begin();
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(first + begin, first + middle, first + end,
                   [axis](const Placed& s, const Placed& t) {
                     if (s.at[axis] != t.at[axis]) return s.at[axis] < t.at[axis];
                     return s.simplex < t.simplex;
                   });
  add_node(placed, begin, middle, context);
  const std::uint32_t second = add_node(placed, middle, end, context);
  nodes_[at].second = second;
  nodes_[at].box = nodes_[at + 1].box;
  nodes_[at].box.add(nodes_[second].box);
  return at;
}

Box3 SimplexTree::widened(Box3 box) const {
  const double by = slack_of(magnitude_, error);
  if (!std::isfinite(by)) {
    constexpr double kInfinity = Box3::kInfinity;
    return {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] -= by;
    box.high[i] += by;
  }
  return box;
}

RoundedSimplex SimplexTree::rounded(std::uint32_t s) const {
  RoundedSimplex result;
  for (const std::uint32_t v : simplex[s]) {
    if (v != kNone) result.corner[result.size++] = vertex[v];
  }
  return result;
}

ExactSimplex SimplexTree::exact(std::uint32_t s) const {
  ExactSimplex result;
  for (const std::uint32_t v : simplex[s]) {
    if (v != kNone) result.corner[result.size++] = exact_vertex(v);
  }
  return result;
}

SimplexTree::Nearest SimplexTree::nearest(const SimplexTree& a, const SimplexTree& b,
                                          Context& context) {
  return NearestSearch(a, b, context).run();
}

}  // namespace plumb
