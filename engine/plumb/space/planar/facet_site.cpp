// Corners and cycles of facets, and the nesting of cycles by one sweep.
//
// Directions in the plane n of a facet are sign (n x m) for another plane m of the line, so the
// turn from one to another is the sign of a det3. A cycle runs counter-clockwise around the area of
// all that it surrounds if it is outer, and clockwise around the area of its holes, or around none,
// if it is not. So the sign of the area that it winds around decides, if the boxes of the vertices
// determine this sign. Otherwise, it is decided at the lexicographically least vertex: all edges
// leave it within half a turn, so its corner on the inside is less than half a turn if and only if
// the cycle is outer. If the cycle passes that vertex several times, all corners there have to be
// such.
//
// Nesting: the region of all facets of a plane lies to the left of their edges. Below the least
// point of a hole is an edge of the outer cycle of its facet, or of another hole of the same facet,
// whose least point comes before. So holes are resolved in the order of the sweep. The sweep asks
// for sides of planes through edges instead of turns of points: points of the frame have no
// coordinates.
//
// Tested by tests/space/facet_site_test.cpp.

#include "plumb/space/planar/facet_site.h"

#include <algorithm>
#include <cmath>

#include "plumb/predicates/error.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/planar/triangulate.h"

namespace plumb {

OtherPlane other_plane(const SpaceComplex& complex, EdgeId e, PlaneId plane) {
  const auto [p, q] = complex.edge_planes[e];
  if (p == plane) return {q, Sign::Positive};
  if (q == plane) return {p, Sign::Negative};
  return {p, turn_about_line(complex.planes(), p, q, plane, p)};
}

Sign side_in_plane(const SpaceComplex& complex, PlaneId n, HalfedgeId h, const Point3Table& points,
                   SpacePoint x) {
  const OtherPlane m = other_plane(complex, SpaceComplex::edge_of(h), n);
  const Sign s = SpaceComplex::is_reverse(h) ? -m.turn : m.turn;
  return -(s * side(points, x, m.plane));
}

namespace {

/// The direction of a half-edge in plane n, as sign (n x m).
struct DirectionInPlane {
  PlaneId m;
  Sign sign;
};

DirectionInPlane direction_in_plane(const SpaceComplex& complex, PlaneId n, HalfedgeId h) {
  const auto& [p, q] = complex.edge_planes[h.value() >> 1U];
  const Sign along = SpaceComplex::is_reverse(h) ? Sign::Negative : Sign::Positive;
  if (p == n) return {q, along};
  if (q == n) return {p, -along};
  return {p, along * same_direction(complex.planes(), p, q, n, p)};
}

}  // namespace

Sign same_direction(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s) {
  if (p == r && q == s) return Sign::Positive;
  if (p == s && q == r) return Sign::Negative;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Sign first = minor_sign(planes, p, q, axis);
    if (first != Sign::Zero) return first * minor_sign(planes, r, s, axis);
  }
  PLUMB_CHECK(false);
  return Sign::Zero;
}

Sign corner_sign(const SpaceComplex& complex, UseId u) {
  const PlaneId plane = complex.facet_plane[complex.use_facet[u]];
  const UseId before = complex.use_prev[u];
  const HalfedgeId back = SpaceComplex::twin(complex.use_halfedge[before]);
  // For directions s (n x m) and t (n x k) the sine of the turn has the sign of s t det3(n, m, k).
  const DirectionInPlane d1 = direction_in_plane(complex, plane, complex.use_halfedge[u]);
  const DirectionInPlane d2 = direction_in_plane(complex, plane, back);
  return d1.sign * d2.sign * det3_sign(complex.planes(), plane, d1.m, d2.m);
}

namespace {

/// Returns the sign of the area that a cycle winds around counter-clockwise. Returns Unsure if the
/// boxes of its vertices do not determine it. The area is the sum of triangles from the first
/// vertex. Their errors are those of turn_of_nearby(), and the error of a sum of n terms is n
/// roundings of all products.
FilteredSign area_sign(const SpaceComplex& complex, UseId cycle) {
  const Point3Table& points = complex.points();
  const FlatView view =
      FlatView::of_plane(complex.planes(), complex.facet_plane[complex.use_facet[cycle]]);
  const std::size_t x = view.coordinate(0), y = view.coordinate(1);
  const auto box = [&](UseId u) { return points.box(complex.vertex_point[complex.use_origin(u)]); };
  const PointBox first = box(cycle);
  double area = 0, products = 0, reach = 0, radius = first.radius, terms = 0;
  double ax = 0, ay = 0;  // From the first vertex to the one before.
  for (UseId u = complex.use_next[cycle]; u != cycle; u = complex.use_next[u]) {
    const PointBox b = box(u);
    const double bx = b.mid[x] - first.mid[x], by = b.mid[y] - first.mid[y];
    area += ax * by - ay * bx;
    products += std::fabs(ax * by) + std::fabs(ay * bx);
    reach += std::fabs(bx) + std::fabs(by);
    radius = std::max(radius, b.radius);
    terms += 1;
    ax = bx;
    ay = by;
  }
  const double off = 2 * radius + 0x1p-1000;  // The bound applies to a difference.
  const double error = 2 * (2 * off * reach + terms * (2 * off * off + 0x1p-50 * products));
  if (area > error) return FilteredSign::Positive;
  return area < -error ? FilteredSign::Negative : FilteredSign::Unsure;
}

/// Returns the result of is_outer(). Calls count_step() at each corner if the area does not decide.
template <class CountStep>
bool is_outer_counted(const SpaceComplex& complex, UseId cycle, const CountStep& count_step) {
  const FilteredSign area = area_sign(complex, cycle);
  if (is_decided(area)) return area == FilteredSign::Positive;
  const Point3Table& points = complex.points();
  VertexId least = complex.use_origin(cycle);
  for (UseId u = complex.use_next[cycle]; u != cycle; u = complex.use_next[u]) {
    count_step();
    const VertexId v = complex.use_origin(u);
    if (v != least && compare_xyz(points, complex.vertex_point[v], complex.vertex_point[least]) ==
                          Sign::Negative) {
      least = v;
    }
  }
  UseId u = cycle;
  do {
    count_step();
    if (complex.use_origin(u) == least && corner_sign(complex, u) != Sign::Positive) return false;
    u = complex.use_next[u];
  } while (u != cycle);
  return true;
}

}  // namespace

bool is_outer(const SpaceComplex& complex, UseId cycle) {
  return is_outer_counted(complex, cycle, [] {});
}

namespace {

/// A point at which no edge ends, and the edge directly below it.
struct PointAbove {
  std::uint32_t point;
  std::uint32_t edge;
};

/// A plane through an edge, and its side on which points are to the left of the edge's use.
struct LeftSide {
  PlaneId plane;
  Sign side;
};

/// The sweep. It uses planes through edges, because points may be on the frame, where they have no
/// coordinates.
class BelowSweep final : RegionSweep {
 public:
  BelowSweep(const FlatPoints& points, std::span<const IndexEdge> edges,
             std::span<const LeftSide> left_side, Context& context)
      : RegionSweep(points, edges, &context), flat_(points), left_side_(left_side) {}

  /// Returns the points inside the region at which no edge ends, in the order of the sweep.
  std::vector<PointAbove> run() {
    std::vector<PointAbove> found;
    start();
    for (std::uint32_t v = 0; v < order_.size(); ++v) {
      count_step();
      const auto [begin, end] = edges_ending(v);
      const std::uint32_t below = edge_below(begin);
      // The point is in the region if the region is above the edge directly below the point.
      if (begin == end && below != kNone && edges_[below].is_lower) {
        found.push_back({order_[v], below});
      }
      status_.erase(begin, end);
      insert_leaving(v, [](std::uint32_t) { return true; });
    }
    return found;
  }

 private:
  Sign turn(std::uint32_t edge, std::uint32_t rank) const override {
    // The left side of the use is the left side of the edge if the edge leads from its lesser end
    // to its greater end.
    const auto& [plane, positive] = left_side_[edge];
    const Sign left = positive * flat_.side(order_[rank], plane);
    return edges_[edge].is_lower ? left : -left;
  }

  const FlatPoints& flat_;
  std::span<const LeftSide> left_side_;
};

/// The nesting of the cycles and points of one plane.
class Nesting {
 public:
  Nesting(const SpaceComplex& complex, PlaneId plane, std::span<const UseId> cycles,
          std::span<const VertexId> points, Context& context)
      : complex_(complex),
        plane_(plane),
        cycles_(cycles),
        points_(points),
        context_(context),
        memory_(context),
        flat_(complex.points()) {}

  CycleNesting run() {
    CycleNesting found{std::vector<std::uint32_t>(cycles_.size(), kNone),
                       std::vector<std::uint32_t>(points_.size(), kNone)};
    std::vector<std::uint32_t> holes;
    for (std::uint32_t c = 0; c < cycles_.size(); ++c) {
      if (is_outer_counted(complex_, cycles_[c], [&] { count_step(); })) {
        found.of_cycle[c] = c;
      } else {
        holes.push_back(c);
      }
    }
    if (holes.empty() && points_.empty()) return found;
    charge();
    show();
    find_least_points(holes);
    find_facets(found);
    return found;
  }

 private:
  /// Checks the limits after each few thousand corners, however these are distributed over cycles.
  void count_step() {
    constexpr std::size_t kStepsPerCheck = 4096;
    if (++steps_ % kStepsPerCheck == 0) context_.check_limits("cycles of a plane");
  }
  template <class Visit>
  void for_uses(UseId first, const Visit& visit) {
    UseId u = first;
    do {
      count_step();
      visit(u);
      u = complex_.use_next[u];
    } while (u != first);
  }
  /// Returns the point of flat_ that represents a vertex.
  std::uint32_t index(VertexId v) const {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(shown_, v) - shown_.begin());
  }

  /// Charges the context for the arrays of the sweep.
  void charge() {
    constexpr std::uint64_t kBytesEach = 200;
    std::uint64_t count = points_.size();
    for (const UseId cycle : cycles_) for_uses(cycle, [&](UseId) { ++count; });
    memory_.add(kBytesEach * count, "cycles of a plane");
  }

  /// Fills flat_ with all vertices, and edges_ with a directed edge for each use.
  void show() {
    shown_.assign(points_.begin(), points_.end());
    for (const UseId cycle : cycles_) {
      for_uses(cycle, [&](UseId u) { shown_.push_back(complex_.use_origin(u)); });
    }
    std::sort(shown_.begin(), shown_.end());
    shown_.erase(std::unique(shown_.begin(), shown_.end()), shown_.end());
    flat_.reset(FlatView::of_plane(complex_.planes(), plane_));
    for (const VertexId v : shown_) flat_.push_back(complex_.vertex_point[v]);
    for (std::uint32_t c = 0; c < cycles_.size(); ++c) {
      for_uses(cycles_[c], [&](UseId u) { add_edge(complex_.use_halfedge[u], c); });
    }
  }
  /// Adds a directed edge with the side of its other plane that lies to its left.
  void add_edge(HalfedgeId h, std::uint32_t cycle) {
    const OtherPlane other = other_plane(complex_, SpaceComplex::edge_of(h), plane_);
    edges_.push_back({index(complex_.origin[h]), index(complex_.target(h))});
    left_side_.push_back({other.plane, SpaceComplex::is_reverse(h) ? other.turn : -other.turn});
    cycle_of_edge_.push_back(cycle);
  }

  /// Notes the least point of each hole. A point is the least point of at most one hole, because
  /// the cells to its left belong to one facet.
  void find_least_points(std::span<const std::uint32_t> holes) {
    hole_at_.assign(shown_.size(), kNone);
    for (const std::uint32_t c : holes) {
      std::uint32_t least = index(complex_.use_origin(cycles_[c]));
      for_uses(cycles_[c], [&](UseId u) {
        const std::uint32_t i = index(complex_.use_origin(u));
        if (i != least && flat_.compare(i, least) == Sign::Negative) least = i;
      });
      hole_at_[least] = c;
    }
  }

  /// Resolves holes and points in the order of the sweep.
  void find_facets(CycleNesting& found) {
    std::vector<std::uint32_t> around(shown_.size(), kNone);  // For each point, an outer cycle.
    for (const PointAbove& p : BelowSweep(flat_, edges_, left_side_, context_).run()) {
      // The outer cycle of the cycle below is already known: the cycle is outer, or it is a hole
      // whose least point was visited before.
      around[p.point] = found.of_cycle[cycle_of_edge_[p.edge]];
      const std::uint32_t hole = hole_at_[p.point];
      if (hole != kNone) found.of_cycle[hole] = around[p.point];
    }
    for (const std::uint32_t c : found.of_cycle) PLUMB_CHECK(c != kNone);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      found.of_point[i] = around[index(points_[i])];
      PLUMB_CHECK(found.of_point[i] != kNone);
    }
  }

  const SpaceComplex& complex_;
  PlaneId plane_;
  std::span<const UseId> cycles_;
  std::span<const VertexId> points_;
  Context& context_;
  MemoryCharge memory_;
  FlatPoints flat_;
  std::vector<VertexId> shown_;  // The vertex of each point of flat_, ascending.
  std::vector<IndexEdge> edges_;
  std::vector<LeftSide> left_side_;           // One entry for each edge.
  std::vector<std::uint32_t> cycle_of_edge_;  // For each edge, an index of cycles_.
  std::size_t steps_ = 0;
  std::vector<std::uint32_t> hole_at_;  // For each point, the hole of which it is the least point.
};

}  // namespace

CycleNesting nest_cycles(const SpaceComplex& complex, PlaneId plane, std::span<const UseId> cycles,
                         std::span<const VertexId> points, Context& context) {
  return Nesting(complex, plane, cycles, points, context).run();
}

}  // namespace plumb
