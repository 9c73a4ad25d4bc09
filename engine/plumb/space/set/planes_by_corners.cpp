#include "plumb/space/set/planes_by_corners.h"

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

PlanesByCorners::PlanesByCorners(const PlaneTable& planes) : planes_(planes) {
  std::vector<std::uint32_t> hash;
  hash.reserve(planes.points().size());
  for (const Point3& p : planes.points()) hash.push_back(hash_of(p));
  index_.reserve(planes.size());
  for (std::uint32_t id = 0; id < planes.size(); ++id) {
    const PlaneSource& source = planes.source(PlaneId(id));
    if (source.is_explicit()) continue;
    const std::array corners{hash[source.code[0]], hash[source.code[1]], hash[source.code[2]]};
    // Each plane is in the table once, so no two entries are the same.
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

bool PlanesByCorners::is_defined_by(PlaneId plane, const std::array<Corner, 3>& corners,
                                    Found& found) const {
  const std::array<std::uint32_t, 3>& code = planes_.source(plane).code;
  const auto has = [&](std::size_t i, std::size_t corner) {
    return planes_.points()[code[i]] == *corners[corner].at;
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
  if (!first.is_valid() || is_defined_by(first, corners, found)) return found;
  index_.find(hash_of_all(corners),
              [&](std::uint32_t id) { return is_defined_by(PlaneId(id), corners, found); });
  return found;
}

}  // namespace plumb
