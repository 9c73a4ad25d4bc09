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

/// The same set, with origins that no wall has.
Nef3 without_wall_origins(const Nef3& set) {
  std::vector<std::uint32_t> origins = set.complex().facet_origin;
  if (std::find(origins.begin(), origins.end(), kWallOrigin) == origins.end()) return set;
  std::replace(origins.begin(), origins.end(), kWallOrigin, kWallOrigin - 1);
  return set.with_origins(origins);
}

void close(std::vector<Nef3>& pieces) {
  for (Nef3& piece : pieces) piece = piece.closure();
}

}  // namespace

ConvexPieces decompose(const Nef3& set, const DecomposeOptions& options, Context& context) {
  const Nef3 whole = without_wall_origins(set);
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

}  // namespace plumb
