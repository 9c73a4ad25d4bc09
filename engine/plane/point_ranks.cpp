#include "plumb/plane/point_ranks.h"

#include <algorithm>

#include "plumb/predicates/decompose.h"

namespace plumb {
namespace {

// The keys of the approximations decide almost always; equal keys mean equal points only when both
// points are doubles. Rounding is monotone, so different keys order exact points rightly.
struct KeyedPoint {
  std::uint64_t x;
  std::uint64_t y;
  std::uint32_t point;
};

class KeyOrder {
 public:
  explicit KeyOrder(const PointTable2& points)
      : points_(points), exact_keys_(points.all_double()) {}

  Sign compare(const KeyedPoint& p, const KeyedPoint& q) const {
    if (p.x != q.x) return p.x < q.x ? Sign::Negative : Sign::Positive;
    if (!exact_keys_) return compare_xy(points_, p.point, q.point);
    if (p.y != q.y) return p.y < q.y ? Sign::Negative : Sign::Positive;
    return Sign::Zero;
  }

  bool operator()(const KeyedPoint& p, const KeyedPoint& q) const {
    const Sign s = compare(p, q);
    return s == Sign::Negative || (s == Sign::Zero && p.point < q.point);
  }

 private:
  const PointTable2& points_;
  bool exact_keys_;
};

std::vector<KeyedPoint> keyed_points(const PointTable2& points, const std::vector<char>& used) {
  std::vector<KeyedPoint> keyed;
  keyed.reserve(static_cast<std::size_t>(std::count(used.begin(), used.end(), char{1})));
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (used[i] == 0) continue;
    const Point2 p = points.approx(i);
    keyed.push_back({ordered_key(p.x), ordered_key(p.y), i});
  }
  return keyed;
}

}  // namespace

PointRanks rank_points(const PointTable2& points, const std::vector<char>& used) {
  const KeyOrder order(points);
  std::vector<KeyedPoint> keyed = keyed_points(points, used);
  std::sort(keyed.begin(), keyed.end(), order);
  PointRanks ranks;
  ranks.order.resize(keyed.size());
  ranks.rank.assign(points.size(), PointRanks::kUnused);
  for (std::size_t i = 0; i < keyed.size(); ++i) {
    ranks.order[i] = keyed[i].point;
    const bool equals_previous = i > 0 && order.compare(keyed[i - 1], keyed[i]) == Sign::Zero;
    ranks.rank[keyed[i].point] =
        equals_previous ? ranks.rank[keyed[i - 1].point] : static_cast<std::uint32_t>(i);
  }
  return ranks;
}

}  // namespace plumb
