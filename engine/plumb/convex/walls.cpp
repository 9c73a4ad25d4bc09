// Decomposition by vertical walls, and the choice of the direction that is vertical.
//
// A subdivision takes rounds of two steps, each an overlay of the set with walls: sight walls rise
// and fall from every reflex edge that is not vertical (wall/wall_sight.h), after which only
// vertical edges are reflex; spread walls resolve those (wall/wall_spread.h). One round is enough
// unless a cell lies above itself. Every wall contains the vertical direction, so each new plane
// belongs to a pencil of two old planes. So numbers grow with the number of rounds, but not with
// the number of walls. There are O(r^2) cells for r reflex edges, which is optimal in the worst
// case: B. Chazelle, Convex partitions of polyhedra, SIAM Journal on Computing 13 (1984).
//
// DirectionChoice estimates for each candidate direction how many pieces its walls would make, from
// shadows of reflex edges along that direction. It works in doubles: only the number of pieces
// depends on it, never their correctness. Proofs: docs/design/walls.md, section Vertical walls.
// Tested by tests/convex/walls_test.cpp and tests/convex/decompose_property_test.cpp.

#include "plumb/convex/walls.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <utility>
#include <vector>

#include "plumb/convex/convexity.h"
#include "plumb/convex/part/cut_set.h"
#include "plumb/convex/part/merge_parts.h"
#include "plumb/convex/wall/set_parts.h"
#include "plumb/convex/wall/wall_complex.h"
#include "plumb/convex/wall/wall_section.h"
#include "plumb/convex/wall/wall_spread.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/complex/space_tables.h"
#include "plumb/space/complex/tidy_tables.h"

namespace plumb {

/// The direction expected to give the fewest pieces. Candidates are the axes, and directions that
/// several reflex edges or normals of facets share. Each is judged by what it would cut: an edge
/// that is not vertical makes a wall, and one more piece for each other such edge whose shadow its
/// own crosses; a vertical edge makes one piece more. Cost: O(r^2) for r reflex edges; of more than
/// kMaxEdges a sample is taken.
struct VerticalChoice {
  VerticalDirection up;
  double pieces = 0;  ///< Expected number of pieces.
};
VerticalChoice choose_vertical(const SpaceComplex& complex, Context& context);

namespace {

// The greatest number of edges that are compared with each other.
constexpr std::size_t kMaxEdges = 1500;
// The greatest number of candidates besides the axes.
constexpr std::size_t kMaxCandidates = 12;
// The greatest number of bits of a direction's coordinates. More bits would lengthen the numbers of
// every wall.
constexpr unsigned kMaxBits = 64;

using Vector2 = std::array<double, 2>;

/// Divides the coordinates by their gcd and makes the first nonzero coordinate positive. Returns
/// false if all are zero, or if one has too many bits.
bool normalise(VerticalDirection& v) {
  Integer common = gcd(gcd(v[0], v[1]), v[2]);
  if (common == 0) return false;
  const auto leading = std::find_if(v.begin(), v.end(), [](const Integer& x) { return x != 0; });
  if (*leading < 0) common = -common;
  for (Integer& x : v) {
    x /= common;
    if (x != 0 && msb(abs(x)) >= kMaxBits) return false;
  }
  return true;
}

class DirectionChoice {
 public:
  DirectionChoice(const SpaceComplex& complex, Context& context) : c_(complex), context_(context) {
    find_reflex_edges();
  }

  VerticalChoice run() {
    std::vector<VerticalDirection> candidates{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    add_shared(edge_directions(), candidates);
    add_shared(normals(), candidates);
    std::size_t best = 0;
    double least = -1;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double pieces = expected_pieces(candidates[i]);
      if (least >= 0 && pieces >= least) continue;
      least = pieces;
      best = i;
    }
    return {candidates[best], least};
  }

 private:
  using Counts = std::map<VerticalDirection, std::size_t>;

  void find_reflex_edges() {
    edges_ = reflex_edges(c_);
    if (edges_.size() <= kMaxEdges) return;
    std::vector<EdgeId> sample;
    for (std::size_t i = 0; i < kMaxEdges; ++i) {
      sample.push_back(edges_[i * edges_.size() / kMaxEdges]);
    }
    edges_ = std::move(sample);
  }

  Counts edge_directions() const {
    Counts counts;
    for (const EdgeId e : edges_) {
      const auto& [p, q] = c_.edge_planes[e];
      const IntegerRow m = c_.planes().coefficients(p), n = c_.planes().coefficients(q);
      VerticalDirection d{m[1] * n[2] - m[2] * n[1], m[2] * n[0] - m[0] * n[2],
                          m[0] * n[1] - m[1] * n[0]};
      if (normalise(d)) ++counts[d];
    }
    return counts;
  }

  Counts normals() const {
    Counts counts;
    for (const EdgeId e : edges_) {
      for (const PlaneId p : c_.edge_planes[e]) {
        const IntegerRow n = c_.planes().coefficients(p);
        VerticalDirection d{n[0], n[1], n[2]};
        if (normalise(d)) ++counts[d];
      }
    }
    return counts;
  }

  /// Adds the directions that occur more than once, in the order of their frequency.
  static void add_shared(const Counts& counts, std::vector<VerticalDirection>& candidates) {
    std::vector<std::pair<std::size_t, const VerticalDirection*>> order;
    for (const auto& [direction, count] : counts) {
      if (count > 1) order.emplace_back(count, &direction);
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& x, const auto& y) { return x.first > y.first; });
    for (std::size_t i = 0; i < order.size() && i < kMaxCandidates / 2; ++i) {
      if (std::find(candidates.begin(), candidates.end(), *order[i].second) == candidates.end()) {
        candidates.push_back(*order[i].second);
      }
    }
  }

  // ---- what a direction costs

  struct Shadow {
    Vector2 from, to;
  };

  double expected_pieces(const VerticalDirection& up) const {
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (abs(up[i]) > abs(up[axis])) axis = i;
      // The shadow is the projection along `up` to the coordinate plane across its largest
      // coordinate.
    }
    const auto slope = [&](std::size_t i) {
      return nearest_double(Rational(up[(axis + 1 + i) % 3], up[axis]));
    };
    const Vector2 slopes{slope(0), slope(1)};
    const auto shadow = [&](VertexId v) {
      const auto at = c_.points().box(c_.vertex_point[v]).mid;
      return Vector2{at[(axis + 1) % 3] - slopes[0] * at[axis],
                     at[(axis + 2) % 3] - slopes[1] * at[axis]};
    };
    std::vector<Shadow> shadows;
    double pieces = 1;
    for (const EdgeId e : edges_) {
      const std::uint32_t h = 2 * e.value();
      pieces += 1;
      if (is_along(e, up)) continue;
      pieces += 0.5;  // An edge may be cut into two walls, and its ends make vertical edges.
      shadows.push_back({shadow(c_.origin[h]), shadow(c_.origin[h + 1])});
    }
    for (std::size_t i = 0; i < shadows.size(); ++i) {
      if (i % 64 == 0) context_.checkpoint("choosing a vertical", i, shadows.size());
      for (std::size_t j = 0; j < i; ++j) pieces += cross(shadows[i], shadows[j]) ? 1 : 0;
    }
    return pieces;
  }

  /// Whether the edge is parallel to `up`, that is, whether both its planes contain that direction.
  bool is_along(EdgeId e, const VerticalDirection& up) const {
    const auto holds = [&](PlaneId p) {
      const IntegerRow n = c_.planes().coefficients(p);
      return n[0] * up[0] + n[1] * up[1] + n[2] * up[2] == 0;
    };
    return holds(c_.edge_planes[e][0]) && holds(c_.edge_planes[e][1]);
  }

  static double turn(const Vector2& a, const Vector2& b, const Vector2& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }
  static bool cross(const Shadow& s, const Shadow& t) {
    return turn(s.from, s.to, t.from) * turn(s.from, s.to, t.to) < 0 &&
           turn(t.from, t.to, s.from) * turn(t.from, t.to, s.to) < 0;
  }

  const SpaceComplex& c_;
  Context& context_;
  std::vector<EdgeId> edges_;
};

}  // namespace

VerticalChoice choose_vertical(const SpaceComplex& complex, Context& context) {
  return DirectionChoice(complex, context).run();
}

namespace {

constexpr int kMaxWallRounds = 64;

/// Whether a marked volume has an angle of more than a half turn around some edge, or lacks a
/// single point. The complex need not be minimal.
bool has_reflex_items(const SpaceComplex& complex) {
  for (const VolumeId around : complex.vertex_volume) {
    if (around.is_valid() && complex.volume_mark[around] == 1) return true;
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

// Returns the overlay of the complex with the walls of one step. Walls make new planes and points,
// so the overlay gets new tables.
SpaceComplex after(Step step, SpaceComplex complex, const VerticalDirection& up, Context& context) {
  MemoryCharge memory(context);
  memory.add(memory_bytes(complex), "a set with its walls");
  const std::shared_ptr<SpaceTables> tables = copy(*complex.tables);
  complex.tables = tables;
  Vertical vertical(up, *tables);
  const std::vector<WallPolygon> walls = step(complex, *tables, vertical, context);
  return with_walls(std::move(complex), tables, walls, context);
}

/// Sets the marks of walls to 1. Until now, they had the mark kBeyond, which distinguishes them
/// from other facets.
void mark_walls(SpaceComplex& complex) {
  for (std::vector<Mark>* marks : std::initializer_list<std::vector<Mark>*>{
           &complex.vertex_mark, &complex.edge_mark, &complex.facet_mark}) {
    std::replace(marks->begin(), marks->end(), kBeyond, Mark{1});
  }
}

/// Returns the subdivided complex, or no value if reflex edges remain after kMaxWallRounds rounds.
std::optional<SpaceComplex> subdivided(SpaceComplex complex, const VerticalDirection& up,
                                       Context& context) {
  // One round is enough unless a cell winds around and lies above itself. In that case, walls may
  // have ended too early.
  for (int round = 0; has_reflex_items(complex); ++round) {
    if (round == kMaxWallRounds) return std::nullopt;
    complex = after(sight_walls, std::move(complex), up, context);
    complex = after(spread_walls, std::move(complex), up, context);
  }
  mark_walls(complex);
  return complex;
}

}  // namespace

SpaceComplex wall_subdivision(const Nef3& set, const std::optional<VerticalDirection>& up,
                              Context& context) {
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
}

std::vector<Nef3> fewer_pieces_by_walls(const Nef3& volume, std::size_t most, Context& context) {
  // If there are at most so many reflex edges, walls take little time and are always tried.
  constexpr std::size_t kFew = 32;
  // The expected number, and the number before merging, may be too large by this factor.
  constexpr double kOverrated = 1.25;
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

/// Decomposes a set whose facets all have ids.
ConvexPieces parts_by_walls(const Nef3& set, const DecomposeOptions& options, Context& context) {
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
                                Context& context) {
  const bool is_unnamed = has_unnamed(set);
  ConvexPieces result = parts_by_walls(is_unnamed ? with_names(set) : set, options, context);
  if (is_unnamed) remove_names(result.pieces);
  put_sources(set, result.pieces);
  return result;
}

}  // namespace plumb
