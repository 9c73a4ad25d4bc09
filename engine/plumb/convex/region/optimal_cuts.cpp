// Cuts of plane regions by diagonals: from a triangulation, and optimal ones by a dynamic program.
//
// CornerSight finds for each corner the corners that it sees. The walk goes through the triangles
// of a triangulation, keeping a window, the wedge between the rays to two vertices, and narrows it
// at each apex; the cost is the number of triangles seen.
//
// Dissection computes for corners i < j the cheapest convex chains from i to j, where a diagonal
// costs one more than the best chain behind it. Among chains of least cost, it keeps the chains
// that no other chain beats at both ends. They are sorted by their last corner, which is the same
// order as by their first corner. So a chain that may be extended to k is found by binary search:
// its last link turns left towards k for a prefix of the list, and the last chain of that prefix is
// the best at its first end. Sources: S. Hertel and K. Mehlhorn, FCT 1983; J. M. Keil, SIAM Journal
// on Computing 14 (1985); M. Keil and J. Snoeyink, International Journal of Computational Geometry
// and Applications 12 (2002).
// Tested by tests/convex/plane_partition_test.cpp.
#include "plumb/convex/region/optimal_cuts.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "plumb/convex/region/region_cuts.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/space/planar/triangulate.h"

namespace plumb {
namespace {

constexpr std::uint32_t kStride = 4096;  // This is the number of steps between checkpoints.

/// The vertices of a region without cuts, all of them input points. Every kStride signs the context
/// is asked whether to stop.
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): final
class RegionPoints final : public PlanarPoints {
 public:
  RegionPoints(const PlaneRegion& region, Context& context) : r_(region), context_(context) {}
  std::uint32_t size() const override { return static_cast<std::uint32_t>(r_.vertex_count()); }
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const override {
    if (++asked_ % kStride == 0) context_.checkpoint(kPartitionPhase, 0, size());
    return orient2d(r_.points.inputs, at(i), at(j), at(k));
  }
  Sign compare(std::uint32_t i, std::uint32_t j) const override {
    return compare_xy(r_.points.inputs, at(i), at(j));
  }
  Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const override {
    const auto exact = [this](std::uint32_t v) { return r_.points.inputs.exact(at(v)); };
    return plumb::incircle(exact(i), exact(j), exact(k), exact(l));
  }

 private:
  std::uint32_t at(std::uint32_t v) const { return r_.vertex_point[v]; }
  const PlaneRegion& r_;
  Context& context_;
  mutable std::uint32_t asked_ = 0;
};

/// A side of a triangle, or a half-edge of the boundary.
struct TriangleSide {
  std::uint32_t from, to;
  HalfedgeId half;  ///< Half-edge of the boundary; not valid for a side of a triangle.
  std::size_t triangle_side = 0;
};

/// Returns the half-edge of each side of all triangles. Sides that are not on the boundary become
/// new edges.
std::vector<HalfedgeId> halves_of_sides(PlaneRegion& region, std::vector<TriangleSide> sides,
                                        std::size_t count, Context& context) {
  // The two half-edges of an edge become neighbours, and so do a side of a triangle and the
  // boundary there.
  std::ranges::sort(sides, {}, [](const TriangleSide& s) {
    const auto [low, high] = std::minmax(s.from, s.to);
    return std::tuple(low, high, s.from, !s.half.is_valid());
  });
  std::vector<HalfedgeId> half(count);
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    if (i % kStride == 0) context.checkpoint(kPartitionPhase, i, sides.size());
    const TriangleSide &s = sides[i], &t = sides[i + 1];
    PLUMB_CHECK(!t.half.is_valid());
    if (s.half.is_valid()) {
      half[t.triangle_side] = s.half;
      continue;
    }
    const VertexId from(s.from), to(s.to);
    half[s.triangle_side] = region.new_edge(from, to, region.from_to(from, to));
    half[t.triangle_side] = twin(half[s.triangle_side]);
  }
  return half;
}

}  // namespace

void triangulate(PlaneRegion& region, Context& context) {
  // A region with n corners has at most n triangles, if the corners of holes count twice. The sides
  // of the triangles and the half-edges of the diagonals are charged.
  constexpr std::uint64_t kHalfBytes =
      2 * sizeof(TriangleSide) * 3 + sizeof(IndexEdge) + 2 * sizeof(IndexTriangle) + 64;
  MemoryCharge memory(context);
  memory.add(kHalfBytes * (region.halfedge_count() + region.vertex_count()), kPartitionPhase);
  std::vector<IndexEdge> edges;
  std::vector<TriangleSide> sides;
  for (std::uint32_t i = 0; i < region.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (!region.is_inside(h)) continue;
    const std::uint32_t from = region.start(h).value(), to = region.target(h).value();
    edges.push_back({from, to});
    sides.push_back({from, to, h});
  }
  std::vector<IndexTriangle> triangles;
  const bool is_region = triangulate(RegionPoints(region, context), edges, triangles);
  PLUMB_CHECK(is_region);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      sides.push_back({triangles[t][k], triangles[t][(k + 1) % 3], {}, 3 * t + k});
    }
  }
  const std::vector<HalfedgeId> half =
      halves_of_sides(region, std::move(sides), 3 * triangles.size(), context);
  for (std::size_t s = 0; s < half.size(); ++s) {
    const HalfedgeId following = half[s % 3 == 2 ? s - 2 : s + 1];
    region.next[half[s]] = following;
    region.prev[following] = half[s];
  }
}

void cut_by_diagonals(PlaneRegion& region, Context& context) {
  triangulate(region, context);
  drop_superfluous(region);
}

namespace {

/// Finds the lesser corners that each corner sees, in a triangulated copy of the region.
class CornerSight {
 public:
  CornerSight(const PlaneRegion& region, Context& context)
      : r_(region), context_(context), corners_(corners_of(region)) {
    triangulate(r_, context);
    number_corners();
  }

  std::vector<std::vector<std::uint32_t>> look() {
    seen_.resize(corners_.size());
    for (from_ = 0; from_ < corners_.size(); ++from_) {
      context_.checkpoint("convex partition", from_, corners_.size());
      look_around();
    }
    for (std::vector<std::uint32_t>& list : seen_) {
      std::ranges::sort(list);
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
    return std::move(seen_);
  }

 private:
  /// A window: the region that is visible through a side of a triangle, between the rays to two
  /// vertices.
  struct Window {
    HalfedgeId side;  ///< Side of the triangle on the viewer's side, from right to left.
    VertexId right, left;
  };

  bool is_boundary(HalfedgeId h) const { return r_.is_cut[edge_of(h)] == 0; }

  /// Gives each half-edge the number of the corner that it leaves.
  void number_corners() {
    corner_.assign(r_.halfedge_count(), 0);
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
      HalfedgeId h = corners_[i];
      corner_[h] = i;
      while (!is_boundary(r_.before(h))) {
        h = twin(r_.before(h));
        corner_[h] = i;
      }
    }
  }

  void look_around() {
    HalfedgeId h = corners_[from_];
    eye_ = r_.point(r_.start(h));
    while (true) {
      const HalfedgeId opposite = r_.after(h);
      see(opposite);
      see(r_.after(opposite));
      look_through({opposite, r_.start(opposite), r_.target(opposite)});
      if (is_boundary(r_.before(h))) return;
      h = twin(r_.before(h));
    }
  }

  // Walks depth first through triangles. If the apex of the next triangle lies between the two
  // rays, it is visible and divides the window. If it lies beyond one of the rays, the window
  // continues only through one side of the triangle.
  void look_through(const Window& first) {
    windows_.push_back(first);
    while (!windows_.empty()) {
      const auto [side, right, left] = windows_.back();
      windows_.pop_back();
      if (is_boundary(side)) continue;
      const HalfedgeId to_top = r_.after(twin(side)), from_top = r_.after(to_top);
      const VertexId top = r_.start(from_top);
      const Sign from_right = turn(right, top), to_left = turn(top, left);
      const bool is_seen = from_right == Sign::Positive && to_left == Sign::Positive;
      if (is_seen) see(from_top);
      // The half-edge twin(side) leads from left to right. Therefore to_top starts at its right
      // end, and from_top ends at its left end.
      if (from_right == Sign::Positive) windows_.push_back({to_top, right, is_seen ? top : left});
      if (to_left == Sign::Positive) windows_.push_back({from_top, is_seen ? top : right, left});
    }
  }

  Sign turn(VertexId a, VertexId b) const {
    return orient2d(r_.points.inputs, eye_, r_.point(a), r_.point(b));
  }
  void see(HalfedgeId leaving) {
    const std::uint32_t to = corner_[leaving];
    seen_[std::max(from_, to)].push_back(std::min(from_, to));
  }

  PlaneRegion r_;
  Context& context_;
  std::vector<HalfedgeId> corners_;
  IdVector<HalfedgeId, std::uint32_t> corner_;  // Number of the corner that each half-edge leaves.
  std::vector<std::vector<std::uint32_t>> seen_;
  std::vector<Window> windows_;
  std::uint32_t from_ = 0;
  std::uint32_t eye_ = 0;
};

}  // namespace

std::vector<HalfedgeId> corners_of(const PlaneRegion& region) {
  const HalfedgeId first = region.loops.front().halfedge();
  std::vector<HalfedgeId> corners{first};
  for (HalfedgeId h = region.after(first); h != first; h = region.after(h)) corners.push_back(h);
  return corners;
}

std::vector<std::vector<std::uint32_t>> lesser_corners_seen(const PlaneRegion& region,
                                                            Context& context) {
  return CornerSight(region, context).look();
}

namespace {

// This cost is larger than any real cost. The sum of two of them does not overflow.
constexpr std::uint32_t kNever = 1U << 30U;

/// A convex chain from i to j.
struct Chain {
  std::uint32_t first;  ///< Its first corner after i.
  std::uint32_t last;   ///< Its last corner before j.
  /// The chain from i to `last`. It is kNone if that chain is a single link, or a sequence of
  /// collinear links.
  std::uint32_t before;
};

/// The dynamic program over pairs of corners.
class Dissection {
 public:
  Dissection(PlaneRegion& region, Context& context)
      : r_(region),
        context_(context),
        memory_(context),
        corners_(corners_of(region)),
        n_(static_cast<std::uint32_t>(corners_.size())),
        seen_(lesser_corners_seen(region, context)) {
    memory_.add(std::uint64_t{n_} * n_ * sizeof(Cell), "optimal convex partition");
    cells_.resize(std::size_t{n_} * n_);
  }

  void run() {
    for (std::uint32_t k = 1; k < n_; ++k) {
      for (const std::uint32_t j : seen_[k]) {
        if (j + 1 == k) cell(j, k).link = cell(j, k).row = 0;
      }
    }
    for (std::uint32_t length = 2; length < n_; ++length) {
      for (std::uint32_t i = 0; i + length < n_; ++i) chains_between(i, i + length);
      context_.checkpoint("convex partition", length, n_);
    }
    cut();
  }

 private:
  /// The data about two corners i < j.
  struct Cell {
    std::uint32_t cost = kNever;  ///< Cost of the best chains.
    /// The best chains that are stored, as a range of chains_.
    std::uint32_t begin = 0, end = 0;
    std::uint32_t link = kNever;     ///< Cost of the link.
    std::uint32_t row = kNever;      ///< Cost of the link, or of links in a row.
    std::uint32_t row_last = kNone;  ///< Last corner before j, for links in a row.
  };

  Cell& cell(std::uint32_t i, std::uint32_t j) { return cells_[std::size_t{i} * n_ + j]; }
  std::uint32_t point(std::uint32_t corner) const { return r_.point(r_.start(corners_[corner])); }
  Sign turn(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    return orient2d(r_.points.inputs, point(i), point(j), point(k));
  }
  /// Whether corner j lies between i and k. Requires that the three corners are collinear.
  bool is_between(std::uint32_t j, std::uint32_t i, std::uint32_t k) const {
    const PointTable2& p = r_.points.inputs;
    return compare_xy(p, point(i), point(j)) == compare_xy(p, point(j), point(k));
  }

  // Finds the best chains from i to k: over every j between that k sees, a chain from i to j and
  // the link (j, k). Corners j come in ascending order, so the chains come sorted by their last
  // corner.
  void chains_between(std::uint32_t i, std::uint32_t k) {
    Cell& at = cell(i, k);
    found_.clear();
    const std::vector<std::uint32_t>& lesser = seen_[k];
    const auto first = std::ranges::upper_bound(lesser, i);
    for (auto j = first; j != lesser.end(); ++j) extend(i, *j, k, at);
    at.begin = static_cast<std::uint32_t>(chains_.size());
    chains_.insert(chains_.end(), found_.begin(), found_.end());
    at.end = static_cast<std::uint32_t>(chains_.size());
    const bool is_link = first != lesser.begin() && *(first - 1) == i;
    if (!is_link || (i == 0 && k + 1 == n_)) return;
    PLUMB_CHECK(at.cost < kNever);
    at.link = at.row = at.cost + 1;
    at.row_last = kNone;
  }

  /// Extends the chains from i to j by the link (j, k), if the corners at j and at i remain convex.
  void extend(std::uint32_t i, std::uint32_t j, std::uint32_t k, Cell& at) {
    const Cell &way = cell(i, j), &link = cell(j, k);
    if (link.link >= kNever) return;
    const Sign side = turn(i, j, k);
    if (side == Sign::Negative) return;
    if (side == Sign::Zero) {
      if (is_between(j, i, k)) {
        if (way.row + link.link >= at.row) return;
        at.row = way.row + link.link;
        at.row_last = j;
      } else if (is_between(k, i, j) && way.begin < way.end) {
        offer(at, way.cost + link.link, {chains_[way.end - 1].first, j, way.end - 1});
      }
      return;
    }
    const std::uint32_t before = steepest(way, j, k);
    if (before != kNone && turn(i, chains_[before].first, k) != Sign::Negative) {
      offer(at, way.cost + link.link, {chains_[before].first, j, before});
    } else if (way.row < kNever) {
      offer(at, way.row + link.link, {j, j, kNone});
    }
  }
  /// Returns the last chain to j that can be extended to k, or kNone. The turns of the chains
  /// decrease along the list, so binary search finds the chain.
  std::uint32_t steepest(const Cell& way, std::uint32_t j, std::uint32_t k) const {
    const auto begin = chains_.begin() + way.begin, end = chains_.begin() + way.end;
    const auto stop = std::partition_point(
        begin, end, [&](const Chain& c) { return turn(c.last, j, k) != Sign::Negative; });
    return stop == begin ? kNone : static_cast<std::uint32_t>(stop - chains_.begin() - 1);
  }

  // Stores the chain if it costs less than the chains so far, or if it costs the same and has a
  // greater first corner. Chains arrive with increasing last corners, so every other chain is worse
  // at both ends.
  void offer(Cell& at, std::uint32_t cost, const Chain& chain) {
    if (cost > at.cost) return;
    if (cost < at.cost) found_.clear();
    at.cost = cost;
    if (found_.empty() || chain.first > found_.back().first) found_.push_back(chain);
  }

  // ---------------------------------------------------------------- back

  // Follows the choices back from the chain 0 .. n-1 and inserts the diagonals.
  void cut() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pieces{{0, n_ - 1}};
    PLUMB_CHECK(cell(0, n_ - 1).cost < kNever);
    while (!pieces.empty()) {
      const auto [i, end] = pieces.back();
      pieces.pop_back();
      std::uint32_t k = end;
      const auto go_back_to = [&](std::uint32_t j) {
        if (k - j > 1) {
          add_diagonal(j, k);
          pieces.emplace_back(j, k);
        }
        k = j;
      };
      for (std::uint32_t c = cell(i, k).begin; c != kNone; c = chains_[c].before) {
        go_back_to(chains_[c].last);
      }
      while (cell(i, k).row_last != kNone) go_back_to(cell(i, k).row_last);
      go_back_to(i);
    }
  }

  void add_diagonal(std::uint32_t i, std::uint32_t k) {
    const Heading along = r_.from_to(r_.start(corners_[i]), r_.start(corners_[k]));
    const HalfedgeId from = corner_towards(i, along), to = corner_towards(k, along.reversed());
    r_.add_edge(from, to, along);
  }
  /// Returns the half-edge of a corner whose wedge contains a heading. Diagonals may have divided
  /// the corner.
  HalfedgeId corner_towards(std::uint32_t corner, Heading x) const {
    HalfedgeId h = corners_[corner];
    while (!r_.leads_into(h, x)) h = twin(r_.before(h));
    return h;
  }

  PlaneRegion& r_;
  Context& context_;
  MemoryCharge memory_;
  std::vector<HalfedgeId> corners_;
  std::uint32_t n_;
  std::vector<std::vector<std::uint32_t>> seen_;
  std::vector<Cell> cells_;
  std::vector<Chain> chains_;
  std::vector<Chain> found_;
};

}  // namespace

void cut_optimally(PlaneRegion& region, Context& context) { Dissection(region, context).run(); }

}  // namespace plumb
