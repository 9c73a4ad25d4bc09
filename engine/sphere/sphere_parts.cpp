#include "plumb/sphere/sphere_parts.h"

#include <algorithm>
#include <numeric>

namespace plumb {

namespace {
constexpr std::uint32_t kNone = SphereMap::kNone;
}  // namespace

void unite(std::vector<std::uint32_t>& parent, std::uint32_t i, std::uint32_t j) {
  i = find_root(parent, i);
  j = find_root(parent, j);
  parent[std::max(i, j)] = std::min(i, j);
}

void make_singles(std::vector<std::uint32_t>& parent, std::size_t count) {
  parent.resize(count);
  std::iota(parent.begin(), parent.end(), std::uint32_t{0});
}

std::size_t SphereParts::count() const {
  std::size_t roots = 0;
  for (std::uint32_t i = 0; i < parent_.size(); ++i) {
    if (parent_[i] == i) ++roots;
  }
  return roots;
}

void SphereParts::walk_from(const PlaneTable& planes, const SphereMap& map, std::uint32_t point,
                            std::uint32_t root_arc) {
  hits_.clear();
  walk_to_arc(planes, map, map.direction[point], root_arc, hits_);
  for (std::size_t i = 0; i + 1 < hits_.size(); ++i) {
    if (hits_[i].exit.is_valid() && hits_[i + 1].entry.is_valid()) {
      links_.push_back({hits_[i].exit, hits_[i + 1].entry});
    }
  }
}

/// Loops are never walked from: two of them would cross, so the only one is the goal.
void SphereParts::find(const PlaneTable& planes, const SphereMap& map) {
  point_count_ = static_cast<std::uint32_t>(map.point_count());
  make_singles(parent_, map.point_count() + map.arc_count());
  for (std::uint32_t h = 0; h < map.origin.size(); ++h) {
    if (map.origin[h] != kNone) unite(parent_, map.origin[h], point_count_ + h / 2);
  }
  links_.clear();
  if (map.arc_count() == 0) return;
  std::uint32_t root = 0;
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
    if (map.is_loop(a)) root = a;
  }
  const std::uint32_t root_part = of_arc(root);
  for (std::uint32_t v = 0; v < map.point_count(); ++v) {
    if (of_point(v) == v && v != root_part) walk_from(planes, map, v, root);
  }
}

}  // namespace plumb
