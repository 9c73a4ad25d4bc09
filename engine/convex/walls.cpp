#include "plumb/convex/walls.h"

#include <algorithm>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/base/refused_memory.h"
#include "plumb/convex/convexity.h"
#include "plumb/convex/cuts.h"
#include "plumb/convex/facet_names.h"
#include "plumb/convex/merge_sets.h"
#include "plumb/convex/set_parts.h"
#include "plumb/convex/vertical.h"
#include "plumb/convex/wall_complex.h"
#include "plumb/convex/wall_direction.h"
#include "plumb/convex/wall_sector.h"
#include "plumb/convex/wall_spread.h"
#include "plumb/space/space_memory.h"
#include "plumb/space/space_tables.h"

namespace plumb {
namespace {

constexpr int kMaxRounds = 64;

/// Does a marked volume span more than half a turn around some edge, or a point taken out of it? Of a complex that need
/// not be minimal.
bool has_reflex_items(const SpaceComplex& complex) {
  for (const VolumeId around : complex.vertex_volume) {
    if (around.is_valid() && complex.volume_mark[around.value()] == 1) return true;
  }
  const SectorTest test(complex);
  std::vector<Sector> sectors;
  for (std::uint32_t e = 0; e < complex.edge_count(); ++e) {
    sectors_of(complex, EdgeId(e), sectors);
    const auto is_reflex = [&](const Sector& s) { return test.is_reflex(s); };
    if (std::any_of(sectors.begin(), sectors.end(), is_reflex)) return true;
  }
  return false;
}

using Step = std::vector<WallPolygon> (*)(const SpaceComplex&, SpaceTables&, Vertical&, Context&);

SpaceComplex after(Step step, SpaceComplex complex, const VerticalDirection& up, Context& context) {
  MemoryCharge memory(context);
  memory.add(memory_bytes(complex), "a set with its walls");
  const std::shared_ptr<SpaceTables> tables = copy(*complex.tables);
  complex.tables = tables;
  Vertical vertical(up, *tables);
  const std::vector<WallPolygon> walls = step(complex, *tables, vertical, context);
  return with_walls(std::move(complex), tables, walls, context);
}

/// Walls got a mark of their own.
void mark_walls(SpaceComplex& complex) {
  for (auto* marks : {&complex.vertex_mark, &complex.edge_mark, &complex.facet_mark}) {
    std::replace(marks->begin(), marks->end(), kBeyond, Mark{1});
  }
}

/// None: reflex edges are left after many rounds.
std::optional<SpaceComplex> subdivided(SpaceComplex complex, const VerticalDirection& up,
                                       Context& context) {
  // Once, but where a cell winds around and lies above itself: then walls may have ended too early.
  for (int round = 0; has_reflex_items(complex); ++round) {
    if (round == kMaxRounds) return std::nullopt;
    complex = after(sight_walls, std::move(complex), up, context);
    complex = after(spread_walls, std::move(complex), up, context);
  }
  mark_walls(complex);
  return complex;
}

}  // namespace

SpaceComplex wall_subdivision(const Nef3& set, const std::optional<VerticalDirection>& up,
                              Context& context) try {
  if (!set.is_bounded()) throw Error(ErrorCode::BadArgument, "vertical walls need a bounded set");
  const VerticalDirection chosen = up ? *up : choose_vertical(set.complex(), context).up;
  const bool is_named = !has_unnamed(set);
  std::optional<SpaceComplex> complex =
      subdivided(is_named ? set.complex() : with_names(set).complex(), chosen, context);
  if (!complex) {
    throw Error(ErrorCode::ResourceLimit, "vertical walls leave reflex edges after 64 rounds");
  }
  if (!is_named) remove_names(complex->facet_origin);
  return *std::move(complex);
} catch (...) {
  rethrow_refused_memory();
}

std::vector<Nef3> fewer_pieces_by_walls(const Nef3& volume, std::size_t most,
                                        Context& context) try {
  constexpr std::size_t kFew = 32;  // reflex edges: walls cost little
  constexpr double kOverrated =
      1.25;  // neither the number expected nor that before merging is the last word
  const SpaceComplex& c = volume.complex();
  if (most < 3 || !volume.is_bounded()) return {};
  const VerticalChoice choice = choose_vertical(c, context);
  if (reflex_edges(c).size() > kFew && choice.pieces * kOverrated > static_cast<double>(most)) {
    return {};
  }
  const std::optional<SpaceComplex> cut = subdivided(c, choice.up, context);
  if (!cut) return {};
  const auto count = static_cast<double>(std::ranges::count(cut->volume_mark, Mark{1}));
  if (count > kOverrated * static_cast<double>(most)) return {};
  std::vector<Nef3> pieces = volumes_as_sets(*cut, context);
  merge_sets(pieces, context);
  if (pieces.size() >= most) pieces.clear();
  return pieces;
} catch (...) {
  rethrow_refused_memory();
}

namespace {

std::vector<Nef3> pieces_by_walls(const Nef3& volumes, const DecomposeOptions& options,
                                  Context& context) {
  std::vector<Nef3> pieces = volumes_as_sets(wall_subdivision(volumes, {}, context), context);
  if (options.closed) {
    for (Nef3& piece : pieces) piece = piece.closure();
  }
  return pieces;
}

/// Of a set whose facets have ids.
ConvexPieces decompose_named(const Nef3& set, const DecomposeOptions& options, Context& context) {
  DecomposeOptions cuts = options;
  cuts.method = DecomposeMethod::Cuts;
  ConvexPieces result;
  result.reflex_edges = reflex_edges(set.complex()).size();
  MemoryCharge memory(context);
  const auto add = [&](std::vector<Nef3> pieces) {
    for (const Nef3& piece : pieces) memory.add(bytes_beside_tables(piece), "convex pieces");
    std::move(pieces.begin(), pieces.end(), std::back_inserter(result.pieces));
  };
  if (set.is_bounded()) {
    result.method = DecomposeMethod::Walls;
    add(pieces_by_walls(set, options, context));
    const Nef3 rest = without_volumes(set, context);
    if (!rest.is_empty()) add(decompose(rest, cuts, context).pieces);
    return result;
  }
  for (const SetPart& part : parts_of(set, context)) {
    const bool has_walls = part.dimension == 3 && part.set.is_bounded();
    if (has_walls) result.method = DecomposeMethod::Walls;
    add(has_walls ? pieces_by_walls(part.set, options, context) : cut_set(part, cuts, context));
  }
  return result;
}

}  // namespace

ConvexPieces decompose_by_walls(const Nef3& set, const DecomposeOptions& options,
                                Context& context) try {
  if (!has_unnamed(set)) return decompose_named(set, options, context);
  ConvexPieces result = decompose_named(with_names(set), options, context);
  remove_names(result.pieces);
  return result;
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
