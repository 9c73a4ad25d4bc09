#include "plumb/plane/point_ranks.h"

#include <algorithm>
#include <utility>

#include "plumb/predicates/decompose.h"

namespace plumb {
namespace {

// Keys of input points decide almost always. Rounding is monotone, so different keys order exact
// points rightly; equal keys mean equal points only when both points are doubles.
struct KeyedPoint {
  std::uint64_t x;
  std::uint64_t y;
  std::uint32_t point;
};

class KeyOrder {
 public:
  explicit KeyOrder(const PlanePointsView& points)
      : points_(points), exact_keys_(points.inputs().all_double()) {}

  Sign compare(const KeyedPoint& p, const KeyedPoint& q) const {
    if (p.x != q.x) return p.x < q.x ? Sign::Negative : Sign::Positive;
    if (!exact_keys_) return compare_xy(points_, p.point, q.point);
    if (p.y != q.y) return p.y < q.y ? Sign::Negative : Sign::Positive;
    return Sign::Zero;
  }

 private:
  const PlanePointsView& points_;
  bool exact_keys_;
};

// Crossings have no keys: their approximations are not monotone.
class PredicateOrder {
 public:
  explicit PredicateOrder(const PlanePointsView& points) : points_(points) {}

  Sign compare(const KeyedPoint& p, const KeyedPoint& q) const {
    return compare_xy(points_, p.point, q.point);
  }

 private:
  const PlanePointsView& points_;
};

std::vector<KeyedPoint> keyed_points(const PlanePointsView& points, const std::vector<char>& used) {
  std::vector<KeyedPoint> keyed;
  keyed.reserve(static_cast<std::size_t>(std::count(used.begin(), used.end(), char{1})));
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (used[i] == 0) continue;
    const Point2 p = points.is_input(i) ? points.inputs().approx(i) : Point2{};
    keyed.push_back({ordered_key(p.x), ordered_key(p.y), i});
  }
  return keyed;
}

template <class Order>
PointRanks rank_by(const Order& order, std::vector<KeyedPoint> keyed, std::size_t point_count) {
  std::sort(keyed.begin(), keyed.end(), [&order](const KeyedPoint& p, const KeyedPoint& q) {
    const Sign s = order.compare(p, q);
    return s == Sign::Negative || (s == Sign::Zero && p.point < q.point);
  });
  PointRanks ranks;
  ranks.order.resize(keyed.size());
  ranks.rank.assign(point_count, PointRanks::kUnused);
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    ranks.order[i] = keyed[i].point;
    const bool equals_previous = i > 0 && order.compare(keyed[i - 1], keyed[i]) == Sign::Zero;
    ranks.rank[keyed[i].point] =
        equals_previous ? ranks.rank[keyed[i - 1].point] : static_cast<std::uint32_t>(i);
  }
  return ranks;
}

}  // namespace

PointRanks rank_points(const PlanePointsView& points, const std::vector<char>& used) {
  std::vector<KeyedPoint> keyed = keyed_points(points, used);
  const bool only_inputs = keyed.empty() || points.is_input(keyed.back().point);
  return only_inputs ? rank_by(KeyOrder(points), std::move(keyed), points.size())
                     : rank_by(PredicateOrder(points), std::move(keyed), points.size());
}

}  // namespace plumb
