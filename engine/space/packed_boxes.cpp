#include "plumb/space/packed_boxes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plumb/base/box_levels.h"

namespace plumb {
namespace {

constexpr std::uint32_t kFieldBits = 21;
constexpr std::uint64_t kLast = (std::uint64_t{1} << 20) - 1;  // beyond all places
constexpr std::size_t kMostPoints = 64;   // boxes within a cell: as many all meet
constexpr std::size_t kLongestRun = 256;  // of one code: the order says nothing of those

/// The grid around all boxes. Places are 1 ... kLast - 1.
class Places {
 public:
  explicit Places(std::span<const Box3> boxes) {
    for (const Box3& box : boxes) all_.add(box);
    for (std::size_t i = 0; i < 3; ++i) {
      const double extent = all_.high[i] - all_.low[i];
      is_finite_ = is_finite_ && std::isfinite(extent);
      scale_[i] = extent > 0x1p-900 ? static_cast<double>(kLast - 2) / extent : 0;
    }
  }
  bool is_finite() const { return is_finite_; }

  /// Monotone in every coordinate: each step of the arithmetic is.
  std::uint64_t packed(const std::array<double, 3>& at) const {
    std::uint64_t fields = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double place = (at[i] - all_.low[i]) * scale_[i];
      const auto cell = std::min<std::uint64_t>(static_cast<std::uint64_t>(place), kLast - 2);
      fields |= (cell + 1) << (kFieldBits * i);
    }
    return fields;
  }

 private:
  Box3 all_;
  std::array<double, 3> scale_;
  bool is_finite_ = true;
};

/// All ones in the fields of a triple of guards that are set.
std::uint64_t fields_of(std::uint64_t guards) { return guards - (guards >> 20); }

/// Bit i of the argument, of 10 bits, becomes bit 3i.
std::uint32_t spread_bits(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ffU;
  x = (x | x << 8) & 0x0300f00fU;
  x = (x | x << 4) & 0x030c30c3U;
  return (x | x << 2) & 0x09249249U;
}

}  // namespace

void PackedBoxTree::Box::add(const Box& b) {
  const std::uint64_t is_low_least = fields_of(((b.low | kGuards) - low) & kGuards);
  const std::uint64_t is_high_most = fields_of(((high | kGuards) - b.high) & kGuards);
  low = (low & is_low_least) | (b.low & ~is_low_least);
  high = (high & is_high_most) | (b.high & ~is_high_most);
}

constexpr PackedBoxTree::Box PackedBoxTree::nowhere() {
  return {kLast | kLast << kFieldBits | kLast << (2 * kFieldBits), 0};
}

PackedBoxTree::PackedBoxTree(std::span<const Box3> boxes) {
  const std::vector<Box> packed = pack(boxes);
  fits_ = fits_ && sort(packed);
  if (!fits_) return;
  boxes_.reserve((boxes.size() + kLeaf - 1) / kLeaf * kLeaf);
  for (const std::uint32_t i : order_) boxes_.push_back(packed[i]);
  boxes_.resize((boxes.size() + kLeaf - 1) / kLeaf * kLeaf, nowhere());
  if (!boxes_.empty()) make_nodes();
}

std::vector<PackedBoxTree::Box> PackedBoxTree::pack(std::span<const Box3> boxes) {
  std::vector<Box> packed;
  const Places places(boxes);
  if (!places.is_finite() && !boxes.empty()) return packed;
  packed.reserve(boxes.size());
  std::size_t points = 0;
  for (const Box3& box : boxes) {
    packed.push_back({places.packed(box.low), places.packed(box.high)});
    points += packed.back().low == packed.back().high ? 1 : 0;
  }
  fits_ = points <= kMostPoints;
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
    const std::uint64_t sum = boxes[i].low + boxes[i].high;  // twice the middle, guards used
    std::uint32_t code = 0;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const std::uint64_t field = sum >> (kFieldBits * axis) & ((std::uint64_t{1} << 21) - 1);
      code |= spread_bits(static_cast<std::uint32_t>(field >> 11)) << (2 - axis);
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

void PackedBoxTree::make_nodes() {
  BoxLevels<Box> levels = levels_over(boxes_, kLeaf, nowhere(), nowhere());
  nodes_ = std::move(levels.nodes);
  level_begin_ = std::move(levels.begin);
}

}  // namespace plumb
