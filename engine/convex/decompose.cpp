#include "plumb/convex/decompose.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "plumb/convex/convexity.h"
#include "plumb/convex/cuts.h"
#include "plumb/convex/set_parts.h"
#include "plumb/convex/walls.h"

namespace plumb {
namespace {

constexpr std::uint32_t kUnnamed = kWallOrigin - 1;  // of the set's facets without an id, meanwhile

bool has_unnamed(const Nef3& set) {
  return std::ranges::any_of(set.complex().facet_origin,
                             [](std::uint32_t origin) { return origin >= kWallOrigin; });
}

/// Ids that no wall has, less than those of walls: where both are one facet, it counts as the set's.
Nef3 with_names(const Nef3& set) {
  std::vector<std::uint32_t> origins = set.complex().facet_origin;
  for (std::uint32_t& origin : origins) origin = std::min(origin, kUnnamed);
  return set.with_origins(origins);
}

Nef3 without_names(const Nef3& set) {
  std::vector<std::uint32_t> origins = set.complex().facet_origin;
  std::ranges::replace(origins, kUnnamed, kNoOrigin);
  return set.with_origins(origins);
}

void close(std::vector<Nef3>& pieces) {
  for (Nef3& piece : pieces) piece = piece.closure();
}

ConvexPieces decompose_named(const Nef3& whole, const DecomposeOptions& options, Context& context) {
  if (options.method == DecomposeMethod::Walls) return decompose_by_walls(whole, options, context);
  ConvexPieces result;
  result.reflex_edges = reflex_edges(whole.complex()).size();
  for (const SetPart& part : parts_of(whole, context)) {
    std::vector<Nef3> pieces = cut_set(part, options, context);
    if (options.method == DecomposeMethod::Best && part.dimension == 3) {
      std::vector<Nef3> fewer = fewer_pieces_by_walls(part.set, pieces.size(), context);
      if (!fewer.empty()) {
        pieces = std::move(fewer);
        result.method = DecomposeMethod::Walls;
        if (options.closed) close(pieces);
      }
    }
    std::move(pieces.begin(), pieces.end(), std::back_inserter(result.pieces));
  }
  return result;
}

}  // namespace

ConvexPieces decompose(const Nef3& set, const DecomposeOptions& options, Context& context) {
  if (!has_unnamed(set)) return decompose_named(set, options, context);
  ConvexPieces result = decompose_named(with_names(set), options, context);
  for (Nef3& piece : result.pieces) piece = without_names(piece);
  return result;
}

}  // namespace plumb
