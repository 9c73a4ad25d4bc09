// The building of a tree over boxes, and the test of a ray and a box.
//
// Boxes are sorted along a space-filling curve, which interleaves the bits of the axes (G. M.
// Morton, 1966). So consecutive boxes are near each other. They are grouped in this order. No other
// choice is made, so building takes linear time. Boxes that fall into one cell of the grid are
// sorted on a grid of their own.
//
// The test of a ray errs to the safe side: every bound is loosened by more than all roundings.
//
// Tested by tests/base/box_tree_test.cpp.

#include "plumb/base/internal/box_tree.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "plumb/base/internal/insertion_sort.h"

namespace plumb {

/// Nodes level by level, the leaves first. Each level except the top one is filled up to an even
/// number.
template <class Box>
struct BoxLevels {
  std::vector<Box> nodes;          ///< The boxes of all nodes.
  std::vector<std::size_t> begin;  ///< Where each level begins in `nodes`.
};

/// Returns the nodes over boxes. `leaf` consecutive boxes make a leaf, and two consecutive nodes
/// make the node above them. The box of a leaf is `empty`, extended by the boxes of the leaf. Each
/// level is filled up with `nowhere`. Requires that the boxes fill all leaves. O(n).
template <class Box>
BoxLevels<Box> levels_over(const std::vector<Box>& boxes, std::size_t leaf, const Box& empty,
                           const Box& nowhere) {
  constexpr std::size_t kMostLevels = 64;
  BoxLevels<Box> levels;
  std::size_t count = boxes.size() / leaf;
  levels.nodes.reserve(2 * count + kMostLevels);
  levels.begin = {0};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (i % leaf == 0) levels.nodes.push_back(empty);
    levels.nodes.back().add(boxes[i]);
  }
  while (count > 1) {
    if (count % 2 == 1) levels.nodes.push_back(nowhere);
    const std::size_t begin = levels.begin.back(), end = levels.nodes.size();
    levels.begin.push_back(end);
    for (std::size_t i = begin; i < end; i += 2) {
      Box both = levels.nodes[i];
      both.add(levels.nodes[i + 1]);
      levels.nodes.push_back(both);
    }
    count = (end - begin) / 2;
  }
  return levels;
}

namespace {

constexpr std::uint32_t kGridBits = 21;
constexpr std::uint32_t kDigitBits = 9;  // Seven digits make a code.
constexpr std::size_t kLongestRun = 8;   // Longer runs of one code are sorted again.
constexpr double kSlack = 0x1p-48;       // Exceeds the roundings of a difference and a quotient.
constexpr double kTiny = 0x1p-1000;      // Exceeds the loss if subnormal numbers are flushed.

/// Returns a box that meets no box, not even an unbounded one: no comparison with a NaN is true.
Box3 nowhere() {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  return {{kNaN, kNaN, kNaN}, {kNaN, kNaN, kNaN}};
}

struct CodedBox {
  std::uint64_t code;
  std::uint32_t box;
};

/// Moves bit i of the argument to bit 3i.
std::uint64_t spread_bits(std::uint64_t x) {
  x = (x | x << 32) & 0x1f00000000ffffULL;
  x = (x | x << 16) & 0x1f0000ff0000ffULL;
  x = (x | x << 8) & 0x100f00f00f00f00fULL;
  x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
  return (x | x << 2) & 0x1249249249249249ULL;
}

/// The grid around the middles of some boxes. Infinite bounds count as the largest finite number.
class Grid {
 public:
  void add(const Box3& box) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double m = middle(box, i);
      low_[i] = std::min(low_[i], m);
      high_[i] = std::max(high_[i], m);
    }
  }
  /// Whether at least two of the middles differ.
  bool has_extent() const { return low_[0] < high_[0] || low_[1] < high_[1] || low_[2] < high_[2]; }
  std::uint64_t code(const Box3& box) const {
    return cell(box, 0) << 2 | cell(box, 1) << 1 | cell(box, 2);
  }

 private:
  static double middle(const Box3& box, std::size_t i) {
    constexpr double kMost = std::numeric_limits<double>::max();
    return std::max(box.low[i], -kMost) / 2 + std::min(box.high[i], kMost) / 2;
  }
  std::uint64_t cell(const Box3& box, std::size_t i) const {
    const double place = (middle(box, i) / 2 - low_[i] / 2) / (high_[i] / 2 - low_[i] / 2);
    if (!(place > 0)) return 0;  // If the middles agree on this axis, the place is 0 / 0.
    constexpr double kCells = std::uint64_t{1} << kGridBits;
    return spread_bits(static_cast<std::uint64_t>(std::min(place * kCells, kCells - 1)));
  }

  std::array<double, 3> low_ = {Box3::kInfinity, Box3::kInfinity, Box3::kInfinity};
  std::array<double, 3> high_ = {-Box3::kInfinity, -Box3::kInfinity, -Box3::kInfinity};
};

/// Sorts boxes by place.
class PlaceSort {
 public:
  explicit PlaceSort(std::span<const Box3> boxes) : boxes_(boxes), spare_(boxes.size()) {
    items_.reserve(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      items_.push_back({0, static_cast<std::uint32_t>(i)});
    }
    sort(items_);
  }
  const std::vector<CodedBox>& items() const { return items_; }

 private:
  void sort(std::span<CodedBox> items) {
    Grid grid;
    for (const CodedBox& c : items) grid.add(boxes_[c.box]);
    if (!grid.has_extent()) return;
    for (CodedBox& c : items) c.code = grid.code(boxes_[c.box]);
    sort_by_code(items);
    sort_runs(items);
  }

  // Sorts long runs of one code again. A run spans at most 2^-21 of the grid. The exception is a
  // run of all items, whose places differ only by roundings. Such a run is left as it is.
  void sort_runs(std::span<CodedBox> items) {
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= items.size(); ++i) {
      if (i < items.size() && items[i].code == items[begin].code) continue;
      const std::size_t length = i - begin;
      if (length > kLongestRun && length < items.size()) sort(items.subspan(begin, length));
      begin = i;
    }
  }

  // Sorts by a stable radix sort from the lowest digit up. Digits that are the same in all codes
  // are skipped. If there are few items, they are inserted one by one, which is faster than
  // clearing the tables of digits.
  void sort_by_code(std::span<CodedBox> items) {
    constexpr std::size_t kFew = 64;
    if (items.size() <= kFew) {
      const auto is_before = [](const CodedBox& a, const CodedBox& b) { return a.code < b.code; };
      return insertion_sort(items, is_before);
    }
    std::span<CodedBox> from = items, to = std::span(spare_).first(items.size());
    for (std::uint32_t shift = 0; shift < 3 * kGridBits; shift += kDigitBits) {
      if (sort_by_digit(from, to, shift)) std::swap(from, to);
    }
    if (from.data() != items.data()) std::copy(from.begin(), from.end(), items.begin());
  }

  static bool sort_by_digit(std::span<const CodedBox> from, std::span<CodedBox> to,
                            std::uint32_t shift) {
    constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
    const auto digit = [shift](const CodedBox& c) { return c.code >> shift & (kDigits - 1); };
    std::array<std::size_t, kDigits> place{};
    for (const CodedBox& c : from) ++place[digit(c)];
    if (place[digit(from[0])] == from.size()) return false;
    std::size_t sum = 0;
    for (std::size_t& p : place) sum += std::exchange(p, sum);
    for (const CodedBox& c : from) to[place[digit(c)]++] = c;
    return true;
  }

  std::span<const Box3> boxes_;
  std::vector<CodedBox> items_;
  std::vector<CodedBox> spare_;
};

}  // namespace

BoxTree::BoxTree(std::span<const Box3> boxes) {
  if (boxes.empty()) return;
  const PlaceSort sorted(boxes);
  order_.reserve(boxes.size());
  boxes_.reserve((boxes.size() + kLeaf - 1) / kLeaf * kLeaf);
  for (const CodedBox& c : sorted.items()) {
    order_.push_back(c.box);
    boxes_.push_back(boxes[c.box]);
  }
  boxes_.resize((boxes.size() + kLeaf - 1) / kLeaf * kLeaf, nowhere());
  make_nodes();
}

void BoxTree::make_nodes() {
  BoxLevels<Box3> levels = levels_over(boxes_, kLeaf, Box3{}, nowhere());
  nodes_ = std::move(levels.nodes);
  level_begin_ = std::move(levels.begin);
}

// Opens nodes level by level until there are as many parts as requested.
std::vector<BoxTree::Part> BoxTree::parts(const BoxTree& a, const BoxTree& b, std::size_t about) {
  std::vector<Part> parts, next;
  const auto add = [&](Node m, Node n) {
    if (a.node(m).meets(b.node(n))) next.push_back(Part(m, n));
  };
  if (!a.is_empty() && !b.is_empty()) add({a.top(), 0}, {b.top(), 0});
  bool is_open = true;
  while (is_open && !next.empty() && next.size() < about) {
    is_open = false;
    parts.swap(next);
    next.clear();
    for (const Part& part : parts) {
      const Node m = part.m_, n = part.n_;
      if (m.level == 0 && n.level == 0) {
        next.push_back(part);
        continue;
      }
      is_open = true;
      const bool opens_m = opens_first(a, m, b, n);
      for (std::uint32_t i = 0; i < 2; ++i) {
        opens_m ? add(m.child(i), n) : add(m, n.child(i));
      }
    }
  }
  return next;
}

namespace {

/// The interval of the times t that satisfy all inequalities so far.
struct Span {
  double first;
  double last;
};

/// Returns the bound minus the greatest amount that roundings may have added.
double loosened(double bound) { return bound - (std::fabs(bound) * kSlack + kTiny); }

/// Keeps the times with t * factor >= bound.
void keep_at_least(Span& t, double factor, double bound) {
  const double loose = loosened(bound);
  if (factor > 0) {
    if (loose > 0) t.first = std::max(t.first, loose / factor * (1 - kSlack) - kTiny);
  } else if (loose > 0) {
    t.last = -1;
  } else if (factor < 0) {
    t.last = std::min(t.last, loose / factor * (1 + kSlack) + kTiny);
  }
}

}  // namespace

// Axes along which the rays do not run are tested first, as they need no division and exclude most
// boxes.
bool can_enter(const BoxRay& ray, const Box3& box, double limit, double& entry) {
  Span t{0, limit};
  const auto is_still = [&](std::size_t i) {
    return ray.direction.low[i] == 0 && ray.direction.high[i] == 0;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_still(i) && (loosened(box.low[i] - ray.origin.high[i]) > 0 ||
                        loosened(ray.origin.low[i] - box.high[i]) > 0)) {
      return false;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_still(i)) continue;
    keep_at_least(t, ray.direction.high[i], box.low[i] - ray.origin.high[i]);
    keep_at_least(t, -ray.direction.low[i], ray.origin.low[i] - box.high[i]);
  }
  entry = t.first;
  return t.first <= t.last && box.low[0] <= box.high[0];
}

}  // namespace plumb
