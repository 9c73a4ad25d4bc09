// Decomposition of a set of the plane into convex parts, face by face. A marked face becomes a
// PlaneRegion, a copy of its boundary in half-edges of its own; one of the methods inserts edges
// until no corner is reflex, and each loop that remains becomes a set that owns part of its
// boundary (PieceMaker). Ownership is what keeps the parts disjoint: a cell of the boundary goes to
// one region, and a cut to one of its two sides.
//
// The method Best takes the result with the fewest parts among the methods that are not too
// expensive. An optimal partition by diagonals is not always the best, because a cut that prolongs
// a side may end inside an edge and resolve two reflex corners at once; so cuts are tried as well,
// unless there are two parts already or r n is too large. Bounds and proofs: docs/convex.md and
// plane_partition.h; S. Hertel and K. Mehlhorn, Fast triangulation of simple polygons, FCT 1983; M.
// Keil and J. Snoeyink, International Journal of Computational Geometry and Applications 12 (2002).
// Tested by tests/convex/plane_partition_test.cpp.
#include "plumb/convex/plane_partition.h"

#include <algorithm>
#include <string>
#include <utility>

#include "plumb/convex/region/optimal_cuts.h"
#include "plumb/convex/region/plane_region.h"
#include "plumb/convex/region/region_cuts.h"
#include "plumb/plane/plane_measure.h"
#include "plumb/predicates/arithmetic/rational_sum.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::uint64_t kHalfBytes = 64;  // The memory of a region in bytes, for each half-edge.
// The memory of a piece and of each of its sides, in bytes.
constexpr std::uint64_t kPieceBytes = 700;
constexpr std::uint64_t kSideBytes = 150;
// Largest product of reflex corners and half-edges.
constexpr std::uint64_t kAffordableCuts = 100'000'000;

class PlanePartition {
 public:
  PlanePartition(const Nef2& set, const PartitionOptions& options, Context& context)
      : c_(set.complex()),
        options_(options),
        context_(context),
        memory_(context),
        regions_(charged(c_, memory_)) {}

  PlanePieces run() {
    for (std::uint32_t f = 0; f < c_.face_count(); ++f) {
      context_.checkpoint(kPartitionPhase, f, c_.face_count());
      if (c_.mark(FaceId(f))) add_face(FaceId(f));
    }
    add_edges();
    add_points();
    if (options_.closed) {
      for (Nef2& piece : result_.pieces) piece = piece.closure();
    }
    return std::move(result_);
  }

 private:
  /// Charges the memory that the regions of the whole set need. Memory for the pieces is charged
  /// when they are made.
  static const PlaneComplex& charged(const PlaneComplex& c, MemoryCharge& memory) {
    memory.add(8 * c.dcel.vertex_count() + 4 * c.dcel.edge_count() + 4 * c.points.size(),
               kPartitionPhase);
    return c;
  }

  void add_face(FaceId f) {
    PlaneRegion region = regions_.region(f);
    MemoryCharge memory(context_);
    memory.add(2 * kHalfBytes * region.halfedge_count(),
               kPartitionPhase);  // The method Best stores two regions.
    const std::uint64_t reflex = region.count_reflex_corners();
    result_.reflex_corners += reflex;
    if (reflex > 0) cut(region, reflex);
    const std::size_t before = result_.pieces.size();
    add_pieces(region, result_.pieces, context_);
    memory_.add(
        kPieceBytes * (result_.pieces.size() - before) + kSideBytes * region.halfedge_count(),
        kPartitionPhase);
  }

  static bool is_simple(const PlaneRegion& region) {
    return region.is_bounded() && region.loops.size() == 1 &&
           corners_of(region).size() <= kMostCornersForOptimal;
  }

  void cut(PlaneRegion& region, std::uint64_t reflex) {
    switch (options_.method) {
      case PartitionMethod::Cuts:
        return cut_by_sides(region, context_);
      case PartitionMethod::Diagonals:
        require(region.is_bounded(), "diagonals cannot cut an unbounded face; cuts can");
        return cut_by_diagonals(region, context_);
      case PartitionMethod::Optimal:
        require(is_simple(region), "an optimal partition needs bounded faces without holes, of " +
                                       std::to_string(kMostCornersForOptimal) + " corners at most");
        return cut_optimally(region, context_);
      case PartitionMethod::Best:
        return cut_best(region, reflex);
    }
  }

  void cut_best(PlaneRegion& region, std::uint64_t reflex) {
    if (!region.is_bounded()) return cut_by_sides(region, context_);
    PlaneRegion other = region;
    if (is_simple(region)) {
      cut_optimally(region, context_);
    } else {
      cut_by_diagonals(region, context_);
    }
    // A region with a reflex corner is not convex, so every method makes at least two parts.
    if (region.count_loops() <= 2 || reflex * other.halfedge_count() > kAffordableCuts) return;
    cut_by_sides(other, context_);
    if (other.count_loops() < region.count_loops()) region = std::move(other);
  }

  // Throws Error{BadArgument} unless `is_met`.
  static void require(bool is_met, const std::string& what) {
    if (!is_met) throw Error(ErrorCode::BadArgument, what);
  }

  // ---------------------------------------------------------------- what has no face

  /// Whether the edge is on the border of a marked face, whose piece may own it.
  bool has_face(EdgeId e) const {
    const HalfedgeId h = first_half(e);
    return c_.mark(c_.dcel.face(h)) || c_.mark(c_.dcel.face(twin(h)));
  }

  /// Makes each marked edge that is not beside a marked face a piece. If a vertex is the end of
  /// several such edges, it goes to the first one.
  void add_edges() {
    PieceMaker maker(c_.points);
    is_taken_.assign(c_.vertex_count(), 0);
    for (std::uint32_t i = 0; i < c_.edge_count(); ++i) {
      const EdgeId e(i);
      if (!c_.mark(e) || has_face(e)) continue;
      const HalfedgeId h = first_half(e);
      SweepCurve side{SweepCurve::kUnbounded, SweepCurve::kUnbounded, c_.line[i].a, c_.line[i].b};
      const auto set_end = [&](std::uint32_t& end, VertexId v) {
        if (c_.is_at_infinity(v)) return;
        end = c_.vertex_point[v];
        const bool is_free = c_.mark(v) && !regions_.owner(v).is_valid();
        if (is_free && std::exchange(is_taken_[v], 1) == 0) maker.add_point(end);
      };
      set_end(side.from, c_.dcel.origin(h));
      set_end(side.to, c_.dcel.target(h));
      maker.add_side(side, Sign::Zero, true);
      result_.pieces.push_back(maker.build(context_));
    }
  }

  /// Makes each marked vertex a piece if no piece owns it.
  void add_points() {
    for (std::uint32_t i = 0; i < c_.vertex_count(); ++i) {
      const VertexId v(i);
      if (!c_.mark(v) || is_taken_[i] != 0 || regions_.owner(v).is_valid()) continue;
      result_.pieces.push_back(Nef2::point(exact(c_.points, c_.vertex_point[i])));
    }
  }

  const PlaneComplex& c_;
  PartitionOptions options_;
  Context& context_;
  MemoryCharge memory_;
  RegionMaker regions_;
  PlanePieces result_;
  IdVector<VertexId, std::uint8_t> is_taken_;
};

}  // namespace

PlanePieces decompose(const Nef2& set, const PartitionOptions& options, Context& context) {
  return PlanePartition(set, options, context).run();
}

std::optional<bool> do_areas_add_up(const Nef2& set, std::span<const Nef2> pieces,
                                    Context& context) {
  const std::optional<Rational> whole = marked_area(set.complex(), context);
  if (!whole) return std::nullopt;
  RationalSum sum;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    context.checkpoint("areas", i, pieces.size());
    const std::optional<Rational> area = marked_area(pieces[i].complex(), context);
    if (!area) return false;
    sum.add(*area);
  }
  return sum.total() == *whole;
}

}  // namespace plumb
