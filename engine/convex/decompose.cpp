#include "plumb/convex/decompose.h"

#include <algorithm>
#include <utility>

#include "plumb/convex/convexity.h"
#include "plumb/convex/cuts.h"
#include "plumb/convex/merge_pieces.h"
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

void add_pieces(const SetPart& part, const DecomposeOptions& options, Context& context,
                std::vector<Nef3>& pieces) {
  if (part.dimension == 3) {
    if (std::optional<CutSurface> surface = cut_surface_of(part.set.complex())) {
      std::vector<std::vector<FaceId>> cut = cut_solid(*surface, context);
      if (options.method == DecomposeMethod::Best) merge_pieces(*surface, cut, context);
      for (const auto& faces : cut) {
        pieces.push_back(set_of_piece(*surface, faces, options.closed, context));
      }
      if (!cut.empty()) return;
    }
  }
  for (const Nef3& piece : cut_set(part, context)) {
    pieces.push_back(options.closed ? piece.closure() : piece);
  }
}

}  // namespace

ConvexPieces decompose(const Nef3& set, const DecomposeOptions& options, Context& context) {
  const Nef3 whole = without_wall_origins(set);
  if (options.method == DecomposeMethod::Walls) return decompose_by_walls(whole, options, context);
  ConvexPieces result;
  result.reflex_edges = reflex_edges(whole.complex()).size();
  for (const SetPart& part : parts_of(whole, context)) {
    add_pieces(part, options, context, result.pieces);
  }
  return result;
}

}  // namespace plumb
