// Morton order, and pairs of boxes that meet.
//
// Morton order: cells of a grid, codes of 10 bits an axis, and sorting by them. BoxTree
// (box_tree.h) has an order of its own, of 21 bits an axis and finer where places are crowded,
// which takes twice as long. Source: G. Morton, A computer oriented geodetic data base and a new
// technique in file sequencing, IBM (1966).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "plumb/base/internal/box_tree.h"
#include "plumb/base/internal/insertion_sort.h"
#include "plumb/predicates/point.h"

namespace plumb {

/// A grid of cells 0 to `last` along each axis, all around a box. If the box has no extent to speak
/// of, all is in cell 0.
class CellGrid {
 public:
  /// Divides the box into last + 1 cells along each axis.
  CellGrid(const Box3& around, std::uint32_t last) : low_(around.low), last_(last) {
    for (std::size_t i = 0; i < 3; ++i) {
      const double extent = around.high[i] - around.low[i];
      is_finite_ = is_finite_ && std::isfinite(extent);
      scale_[i] = extent > 0x1p-900 ? last / extent : 0;
    }
  }
  /// Whether the extent of the box is finite along all axes.
  bool is_finite() const { return is_finite_; }

  /// Returns the cell of a point of the box. It is monotone in every coordinate, as each step of
  /// the arithmetic is. Requires is_finite().
  std::array<std::uint32_t, 3> cell(const std::array<double, 3>& at) const {
    std::array<std::uint32_t, 3> cell;
    for (std::size_t i = 0; i < 3; ++i) {
      cell[i] = std::min(static_cast<std::uint32_t>((at[i] - low_[i]) * scale_[i]), last_);
    }
    return cell;
  }

 private:
  std::array<double, 3> low_;
  std::array<double, 3> scale_;
  std::uint32_t last_;
  bool is_finite_ = true;
};

/// An item with its code.
struct MortonCoded {
  std::uint32_t code;  ///< Its Morton code, of 30 bits.
  std::uint32_t item;  ///< Its number.
};

/// Returns the bits of three numbers of 10 bits, interleaved. In each group of three bits, the bit
/// of the first number is the highest.
inline std::uint32_t morton_code(const std::array<std::uint32_t, 3>& cell) {
  const auto spread = [](std::uint32_t x) {  // Bit i becomes bit 3 i.
    x = (x | x << 16) & 0x030000ffU;
    x = (x | x << 8) & 0x0300f00fU;
    x = (x | x << 4) & 0x030c30c3U;
    return (x | x << 2) & 0x09249249U;
  };
  return spread(cell[0]) << 2 | spread(cell[1]) << 1 | spread(cell[2]);
}

/// Sorts by codes of 30 bits; items of equal codes keep their order. Three passes, by 10 bits each:
/// O(n). A few items are inserted one by one, which is faster than to clear the tables of digits.
inline void sort_by_code(std::vector<MortonCoded>& items) {
  constexpr std::size_t kFew = 64;
  if (items.size() <= kFew) {
    const auto is_before = [](const MortonCoded& a, const MortonCoded& b) {
      return a.code < b.code;
    };
    return insertion_sort(std::span(items), is_before);
  }
  std::vector<MortonCoded> to(items.size());
  constexpr std::uint32_t kDigitBits = 10;
  for (std::uint32_t shift = 0; shift < 30; shift += kDigitBits) {
    std::array<std::uint32_t, std::size_t{1} << kDigitBits> place{};
    const auto digit = [shift](const MortonCoded& c) {
      return c.code >> shift & ((1U << kDigitBits) - 1);
    };
    for (const MortonCoded& c : items) ++place[digit(c)];
    std::uint32_t sum = 0;
    for (std::uint32_t& p : place) sum += std::exchange(p, sum);
    for (const MortonCoded& c : items) to[place[digit(c)]++] = c;
    items.swap(to);
  }
}

// Finds pairs of boxes that meet, among many boxes of similar size, such as the boxes of the
// triangles of a mesh. The tree is like a BoxTree (box_tree.h), but a box takes 12 bytes instead of
// 48, and is compared with eight other boxes at a time.
//
// Notation: a place is a coordinate on a grid of 2^16 - 2 cells an axis around all boxes. Places
// follow coordinates monotonically, so boxes that meet still do; some that do not may now. A group
// is eight boxes that are neighbours in a Morton order, their places side by side. Level 0 contains
// the boxes themselves. Box i of any other level encloses group i of the level below.
//
// The tree requires boxes that the grid separates (fits()). For others, of many scales or with
// infinite bounds, use BoxTree. Even with fits(), very many boxes may share places along one axis.
// So a search asks before each step whether to continue, and a caller that counts steps can change
// to another tree when they are far more than the boxes. Cost: O(n) to build, about 30 ns a box; a
// comparison of a box with a group about 5 ns. Memory: 18 bytes a box.

/// The order of the boxes in a tree.
enum class BoxOrder : std::uint8_t {
  Any,   ///< The tree sorts the boxes.
  Kept,  ///< The boxes come with neighbours together, and keep their order.
};

/// The tree. Immutable after construction.
class PackedBoxTree {
 public:
  /// Builds the tree, unless the boxes do not fit.
  explicit PackedBoxTree(std::span<const Box3> boxes);
  /// Builds the tree over the boxes around triangles, which is faster than over boxes of doubles.
  /// `corners` has the corners of triangles as indices of `points`. Requires that each point is a
  /// corner. If `order` is Kept, the numbers of the triangles are their order in the tree.
  PackedBoxTree(std::span<const Point3> points,
                std::span<const std::array<std::uint32_t, 3>> corners, BoxOrder order);

  /// Whether most boxes are larger than a cell, and few are in the same place of the order. If not,
  /// nothing was built.
  bool fits() const { return fits_; }

  /// Returns about how many pairs of boxes meet, as expected_pairs() does (space_boxes.h), each
  /// pair counted twice. It is 0 if boxes of doubles were given.
  double expected_pairs() const { return expected_pairs_; }

  /// Calls visit(i, j) for every two different boxes that meet, and for some that do not; each pair
  /// once. may_go_on() is asked before every step: a group, a pair of groups, or a pair of boxes
  /// that meet. Returns false if it said no, so that pairs are missing. Requires fits().
  template <class Visit, class MayGoOn>
  bool for_each_pair_inside(Visit&& visit, MayGoOn&& may_go_on) const {
    return for_each_pair_in_order(
        [&](std::uint32_t i, std::uint32_t j) { visit(order_[i], order_[j]); }, may_go_on);
  }
  /// Does the same, but passes the indices of boxes in order(). So a caller can store data in this
  /// order, and read them faster for many pairs.
  template <class Visit, class MayGoOn>
  bool for_each_pair_in_order(Visit&& visit, MayGoOn&& may_go_on) const {
    return levels_.empty() || inside(levels_.size() - 1, 0, visit, may_go_on);
  }
  /// Calls visit(i) for every box i that meets `query`, and for some that do not. Requires fits()
  /// and that `query` is not empty.
  template <class Visit>
  void for_each_meeting(const Box3& query, Visit&& visit) const {
    if (!levels_.empty() && query.meets(bounds_)) {
      visit_below(levels_.size() - 1, 0, place(query), visit);
    }
  }
  /// Returns the least box that contains all boxes.
  const Box3& bounds() const { return bounds_; }
  /// Returns the numbers of the boxes, neighbours together.
  std::span<const std::uint32_t> order() const { return order_; }

 private:
  static constexpr std::uint32_t kWidth = 8;
  using Place = std::int16_t;
  using Places __attribute__((vector_size(kWidth * sizeof(Place)))) = Place;
  using Flags __attribute__((vector_size(kWidth))) = std::int8_t;

  /// A box by its places.
  struct Box {
    std::array<Place, 3> low;
    std::array<Place, 3> high;
    void add(const Box& b);
  };
  /// Eight boxes, side by side for one vector instruction each.
  struct Group {
    std::array<Places, 3> low;
    std::array<Places, 3> high;

    Box box(std::uint32_t i) const {
      return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
    }
    void set(std::uint32_t i, const Box& b);

    /// Returns a word whose bit 8 i is 1 if box i meets b.
    std::uint64_t meeting(const Box& b) const {
      const Places apart = (low[0] > b.high[0]) | (low[1] > b.high[1]) | (low[2] > b.high[2]) |
                           (high[0] < b.low[0]) | (high[1] < b.low[1]) | (high[2] < b.low[2]);
      const auto bytes = std::bit_cast<std::uint64_t>(__builtin_convertvector(apart, Flags));
      constexpr bool is_little = std::endian::native == std::endian::little;
      return ~(is_little ? bytes : __builtin_bswap64(bytes)) & kOnes;
    }
    static constexpr std::uint64_t kOnes = 0x0101010101010101U;
  };
  using Level = std::vector<Group>;

  /// Returns the box of a group for which the lowest bit stands.
  static std::uint32_t first_of(std::uint64_t bits) {
    return static_cast<std::uint32_t>(std::countr_zero(bits)) / kWidth;
  }

  static constexpr Box nowhere();
  Box place(const Box3& box) const;
  std::vector<Box> pack(std::span<const Box3> boxes);
  std::vector<Box> pack(std::span<const Point3> points,
                        std::span<const std::array<std::uint32_t, 3>> corners);
  bool sort(std::span<const Box> boxes);
  std::vector<Box> in_order(std::span<const Box> boxes) const;
  void build(std::span<const Box> boxes);
  static Level groups_of(std::span<const Box> boxes);
  static std::vector<Box> around(const Level& level);

  // Visits the pairs of boxes below one group. Boxes i and j are counted through their level.
  // Returns false if it was stopped.
  template <class MayGoOn, class Take>
  bool inside(std::size_t level, std::uint32_t group, Take& take, MayGoOn& may_go_on) const;
  /// Visits the pair of boxes i and j, which meet; above level 0, the pairs of one box within each.
  template <class MayGoOn, class Take>
  bool between(std::size_t level, std::uint32_t i, std::uint32_t j, Take& take,
               MayGoOn& may_go_on) const {
    if (level > 0) return between_groups(level, i, j, take, may_go_on);
    if (!may_go_on()) return false;
    take(i, j);
    return true;
  }
  template <class MayGoOn, class Take>
  bool between_groups(std::size_t level, std::uint32_t i, std::uint32_t j, Take& take,
                      MayGoOn& may_go_on) const;

  // Visits the boxes below one group that meet a box.
  template <class Visit>
  void visit_below(std::size_t level, std::uint32_t group, const Box& query, Visit& visit) const;

  bool fits_ = false;
  double expected_pairs_ = 0;
  Box3 bounds_;                       // The box around all boxes.
  CellGrid grid_;                     // Divides it.
  std::vector<std::uint32_t> order_;  // Numbers of the boxes, neighbours together.
  std::vector<Level> levels_;
};

template <class Visit>
void PackedBoxTree::visit_below(std::size_t level, std::uint32_t group, const Box& query,
                                Visit& visit) const {
  for (std::uint64_t hits = levels_[level][group].meeting(query); hits != 0; hits &= hits - 1) {
    const std::uint32_t i = kWidth * group + first_of(hits);
    if (level == 0) {
      visit(order_[i]);
    } else {
      visit_below(level - 1, i, query, visit);
    }
  }
}

// Each box of the group is compared with the later boxes of its group. `later` masks all other
// boxes.
template <class MayGoOn, class Take>
bool PackedBoxTree::inside(std::size_t level, std::uint32_t group, Take& take,
                           MayGoOn& may_go_on) const {
  if (!may_go_on()) return false;
  const Group& boxes = levels_[level][group];
  std::uint64_t later = Group::kOnes;
  for (std::uint32_t i = 0; i < kWidth; ++i) {
    const std::uint32_t first = kWidth * group + i;
    if (level > 0 && first < levels_[level - 1].size() &&
        !inside(level - 1, first, take, may_go_on)) {
      return false;
    }
    later &= later - 1;
    for (std::uint64_t hits = boxes.meeting(boxes.box(i)) & later; hits != 0; hits &= hits - 1) {
      if (!between(level, first, kWidth * group + first_of(hits), take, may_go_on)) return false;
    }
  }
  return true;
}

// Boxes of group i are compared with the box around group j first, then with its eight boxes at
// once.
template <class MayGoOn, class Take>
bool PackedBoxTree::between_groups(std::size_t level, std::uint32_t i, std::uint32_t j, Take& take,
                                   MayGoOn& may_go_on) const {
  if (!may_go_on()) return false;
  const Group &in_i = levels_[level - 1][i], &in_j = levels_[level - 1][j];
  const Box all_of_j = levels_[level][j / kWidth].box(j % kWidth);
  for (std::uint64_t near = in_i.meeting(all_of_j); near != 0; near &= near - 1) {
    const std::uint32_t k = first_of(near);
    for (std::uint64_t hits = in_j.meeting(in_i.box(k)); hits != 0; hits &= hits - 1) {
      if (!between(level - 1, kWidth * i + k, kWidth * j + first_of(hits), take, may_go_on)) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace plumb
