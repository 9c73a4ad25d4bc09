// Packs boxes into 12 bytes each and sorts them along a Morton curve.
//
// Coordinates become cells of one grid by monotone arithmetic, so that boxes that meet still meet.
// The tree is not built if it would be of little use. This is so if many boxes lie within one cell,
// where all of them meet, or if more than 256 consecutive boxes have the same code, because their
// order is then arbitrary. Unused slots of the last group contain a box beyond all cells, which
// meets no box, not even itself.
//
// Tested by tests/space/mesh_crossings_test.cpp.

#include "plumb/space/bounds/packed_boxes.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace plumb {
namespace {

// The last cell. On both sides, there is one more place, which is empty.
constexpr int kLast = 0xfffd;
// This is subtracted from cells, so that places are signed.
constexpr int kMiddle = 0x7fff;
constexpr std::size_t kMostPoints = 64;  // In any case, so many boxes may lie within one cell.
// In addition, one box in so many may lie within one cell.
constexpr std::size_t kPointShare = 8;
constexpr std::size_t kLongestRun = 256;  // So many boxes with the same code may be consecutive.

/// Returns the box around all boxes.
Box3 box_around(std::span<const Box3> boxes) {
  Box3 all;
  for (const Box3& box : boxes) all.add(box);
  return all;
}

/// Returns the box around all points.
Box3 box_around(std::span<const Point3> points) {
  Box3 all;
  for (const Point3& p : points) {
    const std::array<double, 3> at{p.x, p.y, p.z};
    for (std::size_t i = 0; i < 3; ++i) {
      all.low[i] = std::min(all.low[i], at[i]);
      all.high[i] = std::max(all.high[i], at[i]);
    }
  }
  return all;
}

/// Returns the places of a point.
std::array<std::int16_t, 3> places(const CellGrid& grid, const std::array<double, 3>& at) {
  std::array<std::int16_t, 3> places;
  const std::array<std::uint32_t, 3> cell = grid.cell(at);
  for (std::size_t i = 0; i < 3; ++i) {
    places[i] = static_cast<std::int16_t>(static_cast<int>(cell[i]) - kMiddle);
  }
  return places;
}

}  // namespace

void PackedBoxTree::Box::add(const Box& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], b.low[i]);
    high[i] = std::max(high[i], b.high[i]);
  }
}

void PackedBoxTree::Group::set(std::uint32_t i, const Box& b) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis][i] = b.low[axis];
    high[axis][i] = b.high[axis];
  }
}

/// Returns a box beyond all cells on both sides. It meets no box, not even itself.
constexpr PackedBoxTree::Box PackedBoxTree::nowhere() {
  constexpr Place least = std::numeric_limits<Place>::min(),
                  most = std::numeric_limits<Place>::max();
  return {{most, most, most}, {least, least, least}};
}

PackedBoxTree::PackedBoxTree(std::span<const Box3> boxes)
    : bounds_(box_around(boxes)), grid_(bounds_, kLast) {
  const std::vector<Box> packed = pack(boxes);
  fits_ = fits_ && sort(packed);
  if (fits_ && !boxes.empty()) build(in_order(packed));
}

PackedBoxTree::PackedBoxTree(std::span<const Point3> points,
                             std::span<const std::array<std::uint32_t, 3>> corners, BoxOrder order)
    : bounds_(box_around(points)), grid_(bounds_, kLast) {
  const std::vector<Box> packed = pack(points, corners);
  if (!fits_ || corners.empty()) return;
  if (order == BoxOrder::Kept) {
    order_.resize(corners.size());
    std::iota(order_.begin(), order_.end(), 0U);
    build(packed);
    return;
  }
  fits_ = sort(packed);
  if (fits_) build(in_order(packed));
}

/// Returns the boxes in the order of the tree.
std::vector<PackedBoxTree::Box> PackedBoxTree::in_order(std::span<const Box> boxes) const {
  std::vector<Box> row;
  row.reserve(boxes.size());
  for (const std::uint32_t i : order_) row.push_back(boxes[i]);
  return row;
}

/// Builds the levels over boxes in the order of the tree.
void PackedBoxTree::build(std::span<const Box> boxes) {
  levels_.push_back(groups_of(boxes));
  while (levels_.back().size() > 1) levels_.push_back(groups_of(around(levels_.back())));
}

/// Returns the boxes in groups of eight, the last one filled up.
PackedBoxTree::Level PackedBoxTree::groups_of(std::span<const Box> boxes) {
  Level level((boxes.size() + kWidth - 1) / kWidth);
  for (std::uint32_t i = 0; i < kWidth * level.size(); ++i) {
    level[i / kWidth].set(i % kWidth, i < boxes.size() ? boxes[i] : nowhere());
  }
  return level;
}

/// Returns the box around each group.
std::vector<PackedBoxTree::Box> PackedBoxTree::around(const Level& level) {
  std::vector<Box> boxes;
  boxes.reserve(level.size());
  for (const Group& group : level) {
    boxes.push_back(nowhere());
    for (std::uint32_t i = 0; i < kWidth; ++i) boxes.back().add(group.box(i));
  }
  return boxes;
}

/// Returns the places of the part of a box that is in the bounds. A box of the tree meets the box
/// if and only if it meets this part.
PackedBoxTree::Box PackedBoxTree::place(const Box3& box) const {
  Box3 part;
  for (std::size_t i = 0; i < 3; ++i) {
    part.low[i] = std::max(box.low[i], bounds_.low[i]);
    part.high[i] = std::min(box.high[i], bounds_.high[i]);
  }
  return {places(grid_, part.low), places(grid_, part.high)};
}

/// Returns the boxes by their places, and sets fits_; returns nothing if the grid is not finite.
std::vector<PackedBoxTree::Box> PackedBoxTree::pack(std::span<const Box3> boxes) {
  std::vector<Box> packed;
  if (!grid_.is_finite() && !boxes.empty()) return packed;
  packed.reserve(boxes.size());
  std::size_t points = 0;
  for (const Box3& box : boxes) {
    packed.push_back({places(grid_, box.low), places(grid_, box.high)});
    points += packed.back().low == packed.back().high ? 1 : 0;
  }
  fits_ = points <= std::max(kMostPoints, boxes.size() / kPointShare);
  return packed;
}

/// Returns the boxes of triangles by the places of their corners, and sets fits_ and
/// expected_pairs_; returns nothing if the grid is not finite.
std::vector<PackedBoxTree::Box> PackedBoxTree::pack(
    std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> corners) {
  std::vector<Box> packed;
  if (!grid_.is_finite() && !corners.empty()) return packed;
  std::vector<std::array<Place, 3>> place;
  place.reserve(points.size());
  for (const Point3& p : points) place.push_back(places(grid_, {p.x, p.y, p.z}));
  packed.reserve(corners.size());
  std::size_t flat = 0;  // The boxes within one cell.
  std::array<std::int64_t, 3> sides{};
  for (const auto& [a, b, c] : corners) {
    Box box;
    for (std::size_t i = 0; i < 3; ++i) {
      box.low[i] = std::min({place[a][i], place[b][i], place[c][i]});
      box.high[i] = std::max({place[a][i], place[b][i], place[c][i]});
      sides[i] += box.high[i] - box.low[i];
    }
    packed.push_back(box);
    flat += box.low == box.high ? 1 : 0;
  }
  fits_ = flat <= std::max(kMostPoints, corners.size() / kPointShare);
  const auto count = static_cast<double>(corners.size());
  expected_pairs_ = count * count;
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = 2 * static_cast<double>(sides[i]) / count / kLast;
    if (share < 1 && bounds_.low[i] < bounds_.high[i]) expected_pairs_ *= share;
  }
  return packed;
}

/// Sorts the boxes in Morton order of their middles. Returns false if too many are at one place.
bool PackedBoxTree::sort(std::span<const Box> boxes) {
  std::vector<MortonCoded> sorted;
  sorted.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    std::array<std::uint32_t, 3> cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int twice_the_middle = boxes[i].low[axis] + boxes[i].high[axis] + 2 * kMiddle;
      cell[axis] = static_cast<std::uint32_t>(twice_the_middle) >> 7;
    }
    sorted.push_back({morton_code(cell), i});
  }
  sort_by_code(sorted);
  for (std::size_t i = kLongestRun; i < sorted.size(); ++i) {
    if (sorted[i].code == sorted[i - kLongestRun].code) return false;
  }
  order_.reserve(boxes.size());
  for (const MortonCoded& c : sorted) order_.push_back(c.item);
  return true;
}

}  // namespace plumb
