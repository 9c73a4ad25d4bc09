// A grid of cells with known volumes.
//
// Invariant: if the place of two points is the same unmarked cell, or neighbouring unmarked cells,
// the segment between them meets no item. For a point of it would have one of the two cells as its
// place, since places are monotone in each coordinate, and the box of the item that holds the point
// marks that cell. Boxes are marked with a margin of 2^-48, so that this is true in every rounding
// mode. Therefore one exact query decides a whole connected part of unmarked cells.
//
// The sizes are bounded: about four cells for each item, 64 marked cells for each item on average,
// and one query for 16 items. If a bound is exceeded, the grid knows fewer volumes, but no wrong
// volumes.
//
// Tested by tests/space/space_locator_test.cpp.

#include "plumb/space/query/volume_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb {
namespace {

constexpr std::uint32_t kUnseen = ~std::uint32_t{0};
constexpr std::uint32_t kMarked = kUnseen - 1;

}  // namespace

VolumeGrid::VolumeGrid(std::span<const Box3> boxes,
                       const std::function<VolumeId(const Point3&)>& volume_of) {
  constexpr std::size_t kItemsPerQuestion = 16, kFreeQuestions = 64;
  if (!lay_out(boxes)) return;
  if (!mark(boxes)) {
    part_.clear();
    return;
  }
  const std::uint32_t parts = flood_cells();
  ask(parts, kFreeQuestions + boxes.size() / kItemsPerQuestion, volume_of);
}

// ---------------------------------------------------------------- cells

/// Lays out cells of one size along the axes that are longer than a cell, and one cell along the
/// other axes. Returns false if no grid should be made.
bool VolumeGrid::lay_out(std::span<const Box3> boxes) {
  constexpr double kLeastPart = 0x1p-40;
  // The factor by which the number of cells may exceed the wanted number. There are three cells
  // along a short axis.
  constexpr std::size_t kMostForOne = 32;
  for (const Box3& box : boxes) all_.add(box);
  std::array<double, 3> extent{};
  for (std::size_t i = 0; i < 3; ++i) extent[i] = all_.high[i] - all_.low[i];
  const double longest = std::max({extent[0], extent[1], extent[2]});
  if (boxes.empty() || !std::isfinite(longest) || !(longest > 0x1p-900)) return false;
  std::array<double, 3> part{};  // The extents, relative to the longest one.
  for (std::size_t i = 0; i < 3; ++i) part[i] = std::max(extent[i] / longest, kLeastPart);
  const std::size_t wanted = std::max(kLeastCells, kCellsPerItem * boxes.size());
  double side = 0;
  std::array<bool, 3> is_long{true, true, true};
  for (int round = 0; round < 3; ++round) {
    double product = 1, axes = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_long[i]) product *= part[i];
      if (is_long[i]) ++axes;
    }
    side = std::pow(product / static_cast<double>(wanted), 1 / axes);
    for (std::size_t i = 0; i < 3; ++i) is_long[i] = is_long[i] && part[i] > side;
  }
  std::size_t cells = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double along = is_long[i] ? std::min(part[i] / side, 1.0 * kMostCellsAlong) : 1;
    count_[i] = std::max(1U, static_cast<std::uint32_t>(along)) + 2;
    scale_[i] = extent[i] > 0x1p-900 ? (count_[i] - 2) / extent[i] : 0;
    cells *= count_[i];
  }
  if (cells > kMostForOne * wanted) return false;
  part_.assign(cells, kUnseen);
  return true;
}

/// Returns the cell of a coordinate: 0 before all boxes, and the last one after them. It is
/// monotone, because each step of the arithmetic is.
std::uint32_t VolumeGrid::place(double x, std::size_t axis, double stretch) const {
  if (x < all_.low[axis]) return 0;
  const std::uint32_t last = count_[axis] - 1;
  if (x > all_.high[axis]) return last;
  const double at = (x - all_.low[axis]) * scale_[axis] * stretch;
  return std::min(static_cast<std::uint32_t>(at) + 1, last - 1);
}

VolumeGrid::Cell VolumeGrid::cell_of(const std::array<double, 3>& p) const {
  return {place(p[0], 0), place(p[1], 1), place(p[2], 2)};
}

/// Returns the index of a cell. Neighbours along x are neighbours in memory.
std::size_t VolumeGrid::index(const Cell& cell) const {
  return (std::size_t{cell[2]} * count_[1] + cell[1]) * count_[0] + cell[0];
}

/// Returns a coordinate whose place is the given one, or NaN if none was found.
double VolumeGrid::middle(std::uint32_t at, std::size_t axis) const {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const double low = all_.low[axis], high = all_.high[axis];
  double x = low + (at - 0.5) / scale_[axis];
  if (scale_[axis] == 0) x = low;
  if (at == 0) x = std::nextafter(low, -Box3::kInfinity);
  if (at == count_[axis] - 1) x = std::nextafter(high, Box3::kInfinity);
  return std::isfinite(x) && place(x, axis) == at ? x : kNaN;
}

// ---------------------------------------------------------------- what is known of them

/// Marks the cells that boxes reach, with a small margin on all sides, so that a point of an item
/// is in a marked cell in every rounding mode of the query. Returns false if the boxes are so large
/// relative to the cells that marking them all would take too long.
bool VolumeGrid::mark(std::span<const Box3> boxes) {
  constexpr std::size_t kMostCellsPerItem = 64;
  std::size_t left = kMostCellsPerItem * (boxes.size() + kLeastCells);
  for (const Box3& box : boxes) {
    Cell first{}, last{};
    for (std::size_t i = 0; i < 3; ++i) {
      first[i] = place(box.low[i], i, 1 - 0x1p-48);
      last[i] = place(box.high[i], i, 1 + 0x1p-48);
    }
    const std::size_t reached =
        std::size_t{last[0] - first[0] + 1} * (last[1] - first[1] + 1) * (last[2] - first[2] + 1);
    if (reached > left) return false;
    left -= reached;
    for (std::uint32_t z = first[2]; z <= last[2]; ++z) {
      for (std::uint32_t y = first[1]; y <= last[1]; ++y) {
        const auto row = part_.begin() + static_cast<std::ptrdiff_t>(index({first[0], y, z}));
        std::fill_n(row, last[0] - first[0] + 1, kMarked);
      }
    }
  }
  return true;
}

/// Numbers the connected parts of unmarked cells by their first cells, and returns the number of
/// parts.
std::uint32_t VolumeGrid::flood_cells() {
  std::uint32_t parts = 0;
  std::vector<std::uint32_t> open;
  const std::size_t row = count_[0], layer = row * count_[1];
  const auto reach = [&](std::size_t i) {
    if (part_[i] != kUnseen) return;
    part_[i] = parts;
    open.push_back(static_cast<std::uint32_t>(i));
  };
  for (std::size_t first = 0; first < part_.size(); ++first) {
    if (part_[first] != kUnseen) continue;
    reach(first);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      const std::size_t x = i % row, y = i / row % count_[1], z = i / layer;
      if (x > 0) reach(i - 1);
      if (x + 1 < count_[0]) reach(i + 1);
      if (y > 0) reach(i - row);
      if (y + 1 < count_[1]) reach(i + row);
      if (z > 0) reach(i - layer);
      if (z + 1 < count_[2]) reach(i + layer);
    }
    ++parts;
  }
  return parts;
}

/// Locates the volume of each part. When the limit of queries is reached, the remaining parts are
/// unknown.
void VolumeGrid::ask(std::uint32_t parts, std::size_t questions,
                     const std::function<VolumeId(const Point3&)>& volume_of) {
  std::vector<VolumeId> volume(parts);
  volume_.resize(part_.size());
  std::size_t i = 0;
  for (std::uint32_t z = 0; z < count_[2]; ++z) {
    for (std::uint32_t y = 0; y < count_[1]; ++y) {
      for (std::uint32_t x = 0; x < count_[0]; ++x, ++i) {
        if (part_[i] == kMarked) continue;
        VolumeId& known = volume[part_[i]];
        if (!known.is_valid() && questions > 0) {
          const Point3 p{middle(x, 0), middle(y, 1), middle(z, 2)};
          if (!std::isnan(p.x) && !std::isnan(p.y) && !std::isnan(p.z)) {
            known = volume_of(p);
            --questions;
          }
        }
        volume_[i] = known;
      }
    }
  }
  // This releases the memory, which an assignment of {} would not.
  part_ = std::vector<std::uint32_t>();
}

// ---------------------------------------------------------------- questions

VolumeId VolumeGrid::volume_at(const Point3& p) const {
  return volume_.empty() ? VolumeId() : volume_[index(cell_of({p.x, p.y, p.z}))];
}

VolumeGrid::Left VolumeGrid::left_of(const Point3& p) const {
  if (volume_.empty()) return {};
  Cell cell = cell_of({p.x, p.y, p.z});
  const std::uint32_t here = cell[0];
  while (cell[0] > 0 && here - cell[0] < kMostSteps) {
    --cell[0];
    const VolumeId volume = volume_[index(cell)];
    if (!volume.is_valid()) continue;
    const double x = middle(cell[0], 0);
    if (!std::isnan(x)) return {x, volume};
  }
  return {};
}

}  // namespace plumb
