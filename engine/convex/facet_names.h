// Ids, meanwhile, of facets that have none: so that walls are told from them (decompose.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plumb/convex/decompose.h"
#include "plumb/space/nef3.h"

namespace plumb {

/// Less than the ids of walls: where a facet and a wall are one, it counts as the set's.
inline constexpr std::uint32_t kUnnamed = kWallOrigin - 1;

inline bool has_unnamed(const Nef3& set) {
  return std::ranges::any_of(set.complex().facet_origin,
                             [](std::uint32_t origin) { return origin >= kWallOrigin; });
}

inline Nef3 with_names(const Nef3& set) {
  std::vector<std::uint32_t> origins = set.complex().facet_origin;
  for (std::uint32_t& origin : origins) origin = std::min(origin, kUnnamed);
  return set.with_origins(origins);
}

inline void remove_names(std::vector<std::uint32_t>& origins) {
  std::ranges::replace(origins, kUnnamed, kNoOrigin);
}

inline void remove_names(std::vector<Nef3>& pieces) {
  for (Nef3& piece : pieces) {
    std::vector<std::uint32_t> origins = piece.complex().facet_origin;
    remove_names(origins);
    piece = piece.with_origins(origins);
  }
}

}  // namespace plumb
