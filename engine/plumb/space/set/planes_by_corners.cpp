#include "plumb/space/set/planes_by_corners.h"

#include <algorithm>
#include <bit>
#include <vector>

namespace plumb {

std::uint32_t PlanesByCorners::hash_of(const Point3& p) {
  // Both zeros have the same hash.
  const std::array<std::uint64_t, 3> bits{std::bit_cast<std::uint64_t>(p.x + 0.0),
                                          std::bit_cast<std::uint64_t>(p.y + 0.0),
                                          std::bit_cast<std::uint64_t>(p.z + 0.0)};
  return static_cast<std::uint32_t>(SeededHash{}(bits));
}

std::uint32_t PlanesByCorners::hash_of_all(const std::array<std::uint32_t, 3>& corners) {
  const std::uint64_t sum = std::uint64_t{corners[0]} + corners[1] + corners[2];
  return static_cast<std::uint32_t>(SeededHash{}(sum));
}

PlanesByCorners::PlanesByCorners(const PlaneTable& planes,
                                 std::span<const std::uint8_t> is_left_out)
    : planes_(planes) {
  std::vector<std::uint32_t> hash(planes.points().size(), 0);  // The value is 0 until it is needed.
  const auto hash_at = [&](std::uint32_t point) {
    if (hash[point] == 0) hash[point] = hash_of(planes.points()[point]);
    return hash[point];
  };
  index_.reserve(static_cast<std::size_t>(std::ranges::count(is_left_out, 0)));
  for (std::uint32_t id = 0; id < is_left_out.size(); ++id) {
    const PlaneSource& source = planes.source(PlaneId(id));
    if (is_left_out[id] != 0 || source.is_explicit()) continue;
    const auto& code = source.code;
    const std::array corners{hash_at(code[0]), hash_at(code[1]), hash_at(code[2])};
    // Each plane is in the table only once, so all entries differ.
    index_.find_or_add(hash_of_all(corners), id, [](std::uint32_t) { return false; });
  }
}

PlaneId PlanesByCorners::candidate(std::uint32_t hash) const {
  constexpr std::uint32_t kAbsent = ~std::uint32_t{0};
  const std::uint32_t id = index_.find(hash, [](std::uint32_t) { return true; });
  if (id == kAbsent) return {};
  __builtin_prefetch(&planes_.source(PlaneId(id)));
  return PlaneId(id);
}

void PlanesByCorners::prefetch_points(PlaneId plane) const {
  for (const std::uint32_t p : planes_.source(plane).code) {
    __builtin_prefetch(&planes_.point(InputPointId(p)));
  }
}

bool PlanesByCorners::is_defined_by(const PlaneTable& planes, PlaneId plane,
                                    const std::array<const Point3*, 3>& corners, Found& found) {
  const PlaneSource& source = planes.source(plane);
  if (source.is_explicit()) return false;
  const std::array<std::uint32_t, 3>& code = source.code;
  const auto has = [&](std::size_t i, std::size_t corner) {
    return planes.points()[code[i]] == *corners[corner];
  };
  for (std::size_t first = 0; first < 3; ++first) {
    if (!has(0, first)) continue;
    const std::size_t next = (first + 1) % 3, last = (first + 2) % 3;
    const bool is_turned = has(1, last) && has(2, next);
    if (!is_turned && !(has(1, next) && has(2, last))) continue;
    found.plane = OrientedPlane(plane, is_turned);
    found.points[first] = InputPointId(code[0]);
    found.points[is_turned ? last : next] = InputPointId(code[1]);
    found.points[is_turned ? next : last] = InputPointId(code[2]);
    return true;
  }
  return false;
}

PlanesByCorners::Found PlanesByCorners::find(const std::array<Corner, 3>& corners,
                                             PlaneId first) const {
  Found found;
  if (!first.is_valid()) return found;
  const std::array<const Point3*, 3> at{corners[0].at, corners[1].at, corners[2].at};
  if (is_defined_by(planes_, first, at, found)) return found;
  index_.find(hash_of_all(corners),
              [&](std::uint32_t id) { return is_defined_by(planes_, PlaneId(id), at, found); });
  return found;
}

}  // namespace plumb
