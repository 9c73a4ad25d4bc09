// Convexity of a set of the plane, decided on its minimal complex in O(n). With one marked face f
// the set is convex if and only if f has one loop without reflex corners, every other marked cell
// is on the boundary of f, and the marked cells of each side of f are consecutive. Without a marked
// face a convex set is one edge with any of its ends, one point, or empty. The local condition
// suffices by the theorem of Tietze (1928): a closed connected set that is locally convex is
// convex.
//
// PartCount counts connected components with a union-find over all cells: an edge joins the faces
// and vertices in whose closures it takes part if both are marked. The complex is minimal, so a
// marked vertex without edges lies in no marked face. Proof: docs/design/walls.md, section
// Convexity.
// Tested by tests/convex/plane_convexity_test.cpp.
#include "plumb/convex/plane_convexity.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "plumb/base/internal/union_find.h"
#include "plumb/convex/region/plane_region.h"

namespace plumb {
namespace {

constexpr const char* kConvexityPhase = "convexity";

// ---------------------------------------------------------------- parts

/// Counts the connected components of a set. Marked cells are joined where one is in the closure of
/// the other. Classes are numbered by faces, then edges, then vertices. (A marked vertex without
/// edges is in no marked face, because the complex is minimal.)
class PartCount {
 public:
  explicit PartCount(const PlaneComplex& complex)
      : c_(complex),
        classes_(complex.face_count() + complex.edge_count() + complex.vertex_count()) {}

  std::uint64_t run() {
    for (std::size_t i = 0; i < c_.edge_count(); ++i) {
      const EdgeId e(i);
      const HalfedgeId h = first_half(e);
      for (const HalfedgeId half : {h, twin(h)}) {
        const FaceId f = c_.dcel.face(half);
        const VertexId v = c_.dcel.origin(half);
        const bool has_vertex = !c_.is_at_infinity(v) && c_.mark(v);
        if (c_.mark(e) && c_.mark(f)) classes_.unite(at(e), at(f));
        if (c_.mark(e) && has_vertex) classes_.unite(at(e), at(v));
        if (c_.mark(f) && has_vertex) classes_.unite(at(f), at(v));
      }
    }
    return count();
  }

 private:
  std::uint32_t at(FaceId f) const { return f.value(); }
  std::uint32_t at(EdgeId e) const { return after(c_.face_count()) + e.value(); }
  std::uint32_t at(VertexId v) const {
    return after(c_.face_count() + c_.edge_count()) + v.value();
  }
  static std::uint32_t after(std::size_t count) { return static_cast<std::uint32_t>(count); }

  std::uint64_t count() {
    std::uint64_t roots = 0;
    const auto add = [&](std::uint32_t i, bool mark) {
      roots += mark && classes_.root(i) == i ? 1 : 0;
    };
    for (std::size_t i = 0; i < c_.face_count(); ++i) add(at(FaceId(i)), c_.mark(FaceId(i)));
    for (std::size_t i = 0; i < c_.edge_count(); ++i) add(at(EdgeId(i)), c_.mark(EdgeId(i)));
    for (std::size_t i = 0; i < c_.vertex_count(); ++i) add(at(VertexId(i)), c_.mark(VertexId(i)));
    return roots;
  }

  const PlaneComplex& c_;
  UnionFind classes_;
};

// ---------------------------------------------------------------- one face

/// Returns the first reflex corner of the region, or no value. A point removed from the face is
/// one.
std::optional<RationalPoint2> reflex_corner(const PlaneRegion& region) {
  for (std::size_t i = 0; i < region.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (region.is_inside(h) && region.is_reflex(h)) {
      return exact(region.points, region.point(region.start(h)));
    }
  }
  for (const Corner& c : region.loops) {
    if (c.is_other()) return exact(region.points, region.point(c.other()));
  }
  return std::nullopt;
}

/// Whether a side ends at the start of h: at infinity, or at a corner with an angle of less than a
/// half turn. Requires that the corner is not reflex.
bool is_side_end(const PlaneRegion& region, HalfedgeId h) {
  if (region.is_at_infinity(region.start(h))) return true;
  return region.cross(region.heading(region.before(h)), region.heading(h)) != Sign::Zero;
}

/// Whether the marked cells of each side are consecutive. Requires one loop without reflex corners.
/// A side is a maximal run of collinear edges; the walk counts runs of marked cells and starts anew
/// at each end of a side, whose vertex belongs to both sides.
bool are_sides_convex(const PlaneRegion& region) {
  HalfedgeId first = region.loops.front().halfedge();
  while (!is_side_end(region, first)) first = region.after(first);
  int runs = 0;
  bool was_marked = false;
  const auto pass = [&](std::uint8_t mark) {
    if (mark != 0 && !was_marked) ++runs;
    was_marked = mark != 0;
    return runs <= 1;
  };
  HalfedgeId h = first;
  do {
    const std::uint8_t at_start = region.vertex_mark[region.start(h)];
    if (!pass(at_start)) return false;
    if (is_side_end(region, h)) {
      runs = at_start != 0 ? 1 : 0;
      was_marked = at_start != 0;
    }
    const bool is_frame = region.is_on_frame(h);
    if (!is_frame && !pass(region.edge_mark[edge_of(h)])) return false;
    h = region.after(h);
  } while (h != first);
  return pass(region.vertex_mark[region.start(first)]);
}

class PlaneConvexityTest {
 public:
  PlaneConvexityTest(const PlaneComplex& complex, Context& context)
      : c_(complex), context_(context), memory_(context) {
    memory_.add(16 * (c_.dcel.vertex_count() + c_.dcel.edge_count() + c_.points.size()) +
                    sizeof(std::uint32_t) * (c_.face_count() + c_.edge_count() + c_.vertex_count()),
                kConvexityPhase);
  }

  PlaneConvexity run() {
    RegionMaker regions(c_);
    std::size_t marked = 0;
    bool is_region_convex = true;
    for (std::size_t i = 0; i < c_.face_count(); ++i) {
      context_.checkpoint(kConvexityPhase, i, c_.face_count());
      const FaceId f(i);
      if (!c_.mark(f)) continue;
      const PlaneRegion region = regions.region(f);
      result_.reflex_corners += region.count_reflex_corners();
      const std::optional<RationalPoint2> corner = reflex_corner(region);
      if (corner) result_.faces.push_back({f, *corner});
      is_region_convex = ++marked == 1 && !corner && region.loops.size() == 1 && is_all_around(f) &&
                         are_sides_convex(region);
    }
    result_.parts = PartCount(c_).run();
    result_.is_convex = marked == 0 ? is_one_edge_or_point() : is_region_convex;
    return std::move(result_);
  }

 private:
  /// Whether every marked cell other than f lies on the boundary of f.
  bool is_all_around(FaceId f) const {
    for (std::size_t i = 0; i < c_.edge_count(); ++i) {
      const HalfedgeId h = first_half(EdgeId(i));
      const bool is_side = c_.dcel.face(h) == f || c_.dcel.face(twin(h)) == f;
      if (c_.mark(EdgeId(i)) && !is_side) return false;
    }
    for (std::size_t i = 0; i < c_.vertex_count(); ++i) {
      const VertexId v(i);
      if (!c_.mark(v)) continue;
      if (c_.dcel.is_isolated(v)) return false;
      bool is_corner = false;
      for (const HalfedgeId h : c_.dcel.around(v)) is_corner |= c_.dcel.face(h) == f;
      if (!is_corner) return false;
    }
    return true;
  }

  /// Whether the marked edges and vertices are one edge with any of its ends, one point, or
  /// nothing.
  bool is_one_edge_or_point() const {
    const auto edges = std::ranges::count(c_.marks.edge, 1);
    const auto points = std::ranges::count(c_.marks.vertex, 1);
    if (edges == 0) return points <= 1;
    if (edges > 1) return false;
    const auto e = std::ranges::find(c_.marks.edge, 1) - c_.marks.edge.begin();
    const HalfedgeId h = first_half(EdgeId(static_cast<std::size_t>(e)));
    std::ptrdiff_t ends = 0;
    for (const VertexId v : {c_.dcel.origin(h), c_.dcel.target(h)}) {
      ends += !c_.is_at_infinity(v) && c_.mark(v) ? 1 : 0;
    }
    return ends == points;
  }

  const PlaneComplex& c_;
  Context& context_;
  MemoryCharge memory_;
  PlaneConvexity result_;
};

}  // namespace

PlaneConvexity convexity_of_set(const Nef2& set, Context& context) {
  return PlaneConvexityTest(set.complex(), context).run();
}

}  // namespace plumb
