// Ids, meanwhile, of facets that have none: so that walls are told from them (decompose.h).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/decompose.h"
#include "plumb/space/complex/tidy_tables.h"
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

// A set taken apart by dimension: what is cut into convex pieces one by one.
//
// Main flow of parts_of():
//  1. own     each marked facet, edge and vertex beside marked volumes is given to one of them;
//             else a marked edge and vertex to a marked facet beside it; else a vertex to an edge
//  2. split   the volumes of a bounded set in one pass (wall_complex.h)
//  3. copy    the rest of a bounded set item by item; of an unbounded one the complex with the
//             marks of one owner
//
// The parts are disjoint and their union is the set. All are in minimal form. Cost: O(n log n); of
// an unbounded set O(n) a part.

/// One part of one dimension.
struct SetPart {
  Nef3 set;
  int dimension = 3;  ///< 3: one marked volume, 2: one facet, 1: one edge, 0: a point
};

/// By dimension, downwards; empty for the empty set. Origins of facets are kept.
std::vector<SetPart> parts_of(const Nef3& set, Context& context);

/// Bytes of a set that shares its tables with others, as the parts and pieces of one set do. O(1).
inline std::size_t bytes_beside_tables(const Nef3& set) {
  return array_bytes(set.complex()) + kBytesPerSet;
}

}  // namespace plumb
