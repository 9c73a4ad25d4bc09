#include "plumb/space/packed_boxes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace plumb {
namespace {

constexpr int kLast = 0xfffd;             // cell; 2 places more, where nothing is
constexpr int kMiddle = 0x7fff;           // subtracted from cells, for places to be signed
constexpr std::size_t kMostPoints = 64;   // boxes within a cell: as many may all meet
constexpr std::size_t kPointShare = 8;    // of all boxes, one in so many may be one as well
constexpr std::size_t kLongestRun = 256;  // of one code: the order says nothing of those

/// The grid around all boxes.
class Grid {
 public:
  explicit Grid(std::span<const Box3> boxes) {
    for (const Box3& box : boxes) all_.add(box);
    for (std::size_t i = 0; i < 3; ++i) {
      const double extent = all_.high[i] - all_.low[i];
      is_finite_ = is_finite_ && std::isfinite(extent);
      scale_[i] = extent > 0x1p-900 ? kLast / extent : 0;
    }
  }
  bool is_finite() const { return is_finite_; }

  /// Monotone in every coordinate: each step of the arithmetic is.
  std::array<std::int16_t, 3> places(const std::array<double, 3>& at) const {
    std::array<std::int16_t, 3> places;
    for (std::size_t i = 0; i < 3; ++i) {
      const int cell = static_cast<int>((at[i] - all_.low[i]) * scale_[i]);
      places[i] = static_cast<std::int16_t>(std::min(cell, kLast) - kMiddle);
    }
    return places;
  }

 private:
  Box3 all_;
  std::array<double, 3> scale_;
  bool is_finite_ = true;
};

/// Bit i of the argument, of 10 bits, becomes bit 3i.
std::uint32_t spread_bits(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ffU;
  x = (x | x << 8) & 0x0300f00fU;
  x = (x | x << 4) & 0x030c30c3U;
  return (x | x << 2) & 0x09249249U;
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

/// Beyond all cells on both sides: it meets nothing, itself neither.
constexpr PackedBoxTree::Box PackedBoxTree::nowhere() {
  constexpr Place least = std::numeric_limits<Place>::min(),
                  most = std::numeric_limits<Place>::max();
  return {{most, most, most}, {least, least, least}};
}

PackedBoxTree::PackedBoxTree(std::span<const Box3> boxes) {
  std::vector<Box> packed = pack(boxes);
  fits_ = fits_ && sort(packed);
  if (!fits_ || boxes.empty()) return;
  std::vector<Box> row;
  row.reserve(boxes.size());
  for (const std::uint32_t i : order_) row.push_back(packed[i]);
  for (; levels_.empty() || row.size() > 1; row = around(levels_.back())) {
    levels_.push_back(groups_of(row));
  }
}

PackedBoxTree::Level PackedBoxTree::groups_of(std::span<const Box> boxes) {
  Level level((boxes.size() + kWidth - 1) / kWidth);
  for (std::uint32_t i = 0; i < kWidth * level.size(); ++i) {
    level[i / kWidth].set(i % kWidth, i < boxes.size() ? boxes[i] : nowhere());
  }
  return level;
}

/// The box around each group.
std::vector<PackedBoxTree::Box> PackedBoxTree::around(const Level& level) {
  std::vector<Box> boxes;
  boxes.reserve(level.size());
  for (const Group& group : level) {
    boxes.push_back(nowhere());
    for (std::uint32_t i = 0; i < kWidth; ++i) boxes.back().add(group.box(i));
  }
  return boxes;
}

std::vector<PackedBoxTree::Box> PackedBoxTree::pack(std::span<const Box3> boxes) {
  std::vector<Box> packed;
  const Grid grid(boxes);
  if (!grid.is_finite() && !boxes.empty()) return packed;
  packed.reserve(boxes.size());
  std::size_t points = 0;
  for (const Box3& box : boxes) {
    packed.push_back({grid.places(box.low), grid.places(box.high)});
    points += packed.back().low == packed.back().high ? 1 : 0;
  }
  fits_ = points <= std::max(kMostPoints, boxes.size() / kPointShare);
  return packed;
}

/// By the place of the middle on a grid of 2^10 cells an axis, bits of the axes interleaved: three passes by a digit.
/// False: too many are in one place.
bool PackedBoxTree::sort(std::span<const Box> boxes) {
  struct Coded {
    std::uint32_t code;
    std::uint32_t box;
  };
  std::vector<Coded> from, to(boxes.size());
  from.reserve(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    std::uint32_t code = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const int twice_the_middle = boxes[i].low[axis] + boxes[i].high[axis] + 2 * kMiddle;
      code |= spread_bits(static_cast<std::uint32_t>(twice_the_middle) >> 7) << (2 - axis);
    }
    from.push_back({code, i});
  }
  constexpr std::uint32_t kDigitBits = 10;
  for (std::uint32_t shift = 0; shift < 30; shift += kDigitBits) {
    std::array<std::uint32_t, std::size_t{1} << kDigitBits> place{};
    const auto digit = [shift](const Coded& c) {
      return c.code >> shift & ((1U << kDigitBits) - 1);
    };
    for (const Coded& c : from) ++place[digit(c)];
    std::uint32_t sum = 0;
    for (std::uint32_t& p : place) sum += std::exchange(p, sum);
    for (const Coded& c : from) to[place[digit(c)]++] = c;
    from.swap(to);
  }
  for (std::size_t i = kLongestRun; i < from.size(); ++i) {
    if (from[i].code == from[i - kLongestRun].code) return false;
  }
  order_.reserve(boxes.size());
  for (const Coded& c : from) order_.push_back(c.box);
  return true;
}

}  // namespace plumb
