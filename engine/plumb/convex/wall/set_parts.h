// A set divided by dimension into the parts that are cut into convex pieces one by one, and the ids
// that its facets have meanwhile.
//
// A facet without an id gets the id kUnnamed while a set is decomposed, so that walls can be
// distinguished from facets of the set (decompose.h).
//
// Main flow of parts_of():
//  1. own     gives each marked facet, edge and vertex beside marked volumes to one of them; a
//             remaining marked edge or vertex to a marked facet beside it; a remaining vertex to an
//             edge
//  2. split   makes the volumes of a bounded set in one pass (wall_complex.h)
//  3. copy    copies the rest of a bounded set cell by cell; for an unbounded set copies the
//             complex with the marks of one owner
//
// The parts are disjoint and their union is the set. All are in minimal form. Cost: O(n log n); for
// an unbounded set O(n) per part.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/convex/decompose.h"
#include "plumb/space/complex/tidy_tables.h"
#include "plumb/space/nef3.h"
#include "plumb/space/set/source_carrier.h"

namespace plumb {

/// Less than the ids of walls: if a facet and a wall coincide, the result counts as the set's
/// facet.
inline constexpr std::uint32_t kUnnamed = kWallOrigin - 1;

/// Whether a facet of the set has no id.
inline bool has_unnamed(const Nef3& set) {
  return std::ranges::any_of(set.complex().facet_origin,
                             [](std::uint32_t origin) { return origin >= kWallOrigin; });
}

/// Returns the set with the id kUnnamed for facets without one.
inline Nef3 with_names(const Nef3& set) {
  std::vector<std::uint32_t> origins = set.complex().facet_origin;
  for (std::uint32_t& origin : origins) origin = std::min(origin, kUnnamed);
  return set.with_origins(origins);
}

/// Gives facets with the id kUnnamed no id again.
inline void remove_names(std::vector<std::uint32_t>& origins) {
  std::ranges::replace(origins, kUnnamed, kNoOrigin);
}

/// Does the same for the facets of all pieces.
inline void remove_names(std::vector<Nef3>& pieces) {
  for (Nef3& piece : pieces) {
    std::vector<std::uint32_t> origins = piece.complex().facet_origin;
    remove_names(origins);
    piece = piece.with_origins(origins);
  }
}

/// Gives pieces the sources of the set. O(1) for each piece.
inline void put_sources(const Nef3& set, std::vector<Nef3>& pieces) {
  const SourceLists::List& sources = SourceCarrier::of(set);
  if (sources == nullptr) return;
  for (Nef3& piece : pieces) piece = SourceCarrier::put(sources, std::move(piece));
}

/// A part of a set that has one dimension.
struct SetPart {
  Nef3 set;
  int dimension = 3;  ///< 3 for one marked volume, 2 for a facet, 1 for an edge, 0 for a point.
};

/// Returns the parts by descending dimension; none for the empty set. Origins of facets are kept.
/// Throws the errors of the Context.
std::vector<SetPart> parts_of(const Nef3& set, Context& context);

/// Returns the bytes of a set that shares its tables with others, as the parts and pieces of one
/// set do. Cost: O(1).
inline std::size_t bytes_beside_tables(const Nef3& set) {
  return array_bytes(set.complex()) + kBytesPerSet;
}

}  // namespace plumb
