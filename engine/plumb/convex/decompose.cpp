#include "plumb/convex/decompose.h"

#include <iterator>
#include <utility>

#include "plumb/convex/convexity.h"
#include "plumb/convex/part/cut_set.h"
#include "plumb/convex/wall/set_parts.h"
#include "plumb/convex/walls.h"

namespace plumb {
namespace {

void close(std::vector<Nef3>& pieces) {
  for (Nef3& piece : pieces) piece = piece.closure();
}

// Decomposes a set whose facets all have ids. Each part of the set is cut by planes; with the
// method Best, vertical walls are tried on solid parts as well, and the fewer pieces are kept.
ConvexPieces decompose_named(const Nef3& whole, const DecomposeOptions& options, Context& context) {
  if (options.method == DecomposeMethod::Walls) return decompose_by_walls(whole, options, context);
  ConvexPieces result;
  result.reflex_edges = reflex_edges(whole.complex()).size();
  MemoryCharge memory(context);
  const std::vector<SetPart> parts = parts_of(whole, context);
  for (const SetPart& part : parts) memory.add(bytes_beside_tables(part.set), "parts of a set");
  for (const SetPart& part : parts) {
    std::vector<Nef3> pieces = cut_set(part, options, context);
    if (options.method == DecomposeMethod::Best && part.dimension == 3) {
      std::vector<Nef3> fewer = fewer_pieces_by_walls(part.set, pieces.size(), context);
      if (!fewer.empty()) {
        pieces = std::move(fewer);
        result.method = DecomposeMethod::Walls;
        if (options.closed) close(pieces);
      }
    }
    // A part that is convex is its own piece and shares its memory.
    for (const Nef3& piece : pieces) {
      if (pieces.size() > 1) memory.add(bytes_beside_tables(piece), "convex pieces");
    }
    std::move(pieces.begin(), pieces.end(), std::back_inserter(result.pieces));
  }
  return result;
}

}  // namespace

ConvexPieces decompose(const Nef3& set, const DecomposeOptions& options, Context& context) {
  if (!has_unnamed(set)) return decompose_named(set, options, context);
  ConvexPieces result = decompose_named(with_names(set), options, context);
  remove_names(result.pieces);
  return result;
}

}  // namespace plumb
