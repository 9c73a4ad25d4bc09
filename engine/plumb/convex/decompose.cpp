#include "plumb/convex/decompose.h"

#include <deque>
#include <iterator>
#include <utility>

#include "plumb/base/internal/parallel.h"
#include "plumb/base/internal/work_log.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/part/cut_set.h"
#include "plumb/convex/wall/set_parts.h"
#include "plumb/convex/walls.h"

namespace plumb {
namespace {

void close(std::vector<Nef3>& pieces) {
  for (Nef3& piece : pieces) piece = piece.closure();
}

/// The convex pieces of a part of a set.
struct PiecesOfPart {
  std::vector<Nef3> pieces;
  bool is_by_walls = false;
};

/// Cuts a part by planes. With the method Best, vertical walls are tried on a solid part as well,
/// and the fewer pieces are kept.
PiecesOfPart pieces_of(const SetPart& part, const DecomposeOptions& options, Context& context) {
  PiecesOfPart result{cut_set(part, options, context), false};
  if (options.method != DecomposeMethod::Best || part.dimension != 3) return result;
  std::vector<Nef3> fewer = fewer_pieces_by_walls(part.set, result.pieces.size(), context);
  if (fewer.empty()) return result;
  result = {std::move(fewer), true};
  if (options.closed) close(result.pieces);
  return result;
}

// Decomposes a set whose facets all have ids. The parts of the set are decomposed in parallel.
ConvexPieces decompose_named(const Nef3& whole, const DecomposeOptions& options, Context& context) {
  if (options.method == DecomposeMethod::Walls) return decompose_by_walls(whole, options, context);
  const WorkPhase phase("decomposition");
  ConvexPieces result;
  result.reflex_edges = reflex_edges(whole.complex()).size();
  MemoryCharge memory(context);
  const std::vector<SetPart> parts = parts_of(whole, context);
  for (const SetPart& part : parts) memory.add(bytes_beside_tables(part.set), "parts of a set");
  std::vector<PiecesOfPart> of_part(parts.size());
  std::deque<MemoryCharge> charges;  // One entry for each part. A deque does not move its elements.
  for (std::size_t i = 0; i < parts.size(); ++i) charges.emplace_back(context);
  run_jobs(context, parts.size(), [&](std::size_t i, Context& own) {
    of_part[i] = pieces_of(parts[i], options, own);
    // A convex part is its only piece, and shares its memory.
    if (of_part[i].pieces.size() == 1) return;
    for (const Nef3& piece : of_part[i].pieces) {
      charges[i].add(bytes_beside_tables(piece), "convex pieces");
    }
  });
  for (auto& [pieces, is_by_walls] : of_part) {
    if (is_by_walls) result.method = DecomposeMethod::Walls;
    std::move(pieces.begin(), pieces.end(), std::back_inserter(result.pieces));
  }
  return result;
}

}  // namespace

ConvexPieces decompose(const Nef3& set, const DecomposeOptions& options, Context& context) {
  const bool is_unnamed = has_unnamed(set);
  ConvexPieces result = decompose_named(is_unnamed ? with_names(set) : set, options, context);
  if (is_unnamed) remove_names(result.pieces);
  put_sources(set, result.pieces);
  return result;
}

}  // namespace plumb
