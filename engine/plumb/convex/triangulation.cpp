// Delaunay triangulations of points and of sets of the plane.
//
// The vertices of a set are copied to a table of exact points, crossings included, so that one
// adapter serves both. triangulate() requires that no point lies inside an edge: the hull of points
// is therefore the polygon through all points on its boundary.
// Tested by tests/convex/triangulation_test.cpp.
#include "plumb/convex/triangulation.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "plumb/base/ids.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/space/planar/triangulate.h"

namespace plumb {
namespace {

constexpr const char* kTriangulationPhase = "triangulation";
constexpr std::uint32_t kSignsPerCheckpoint = 4096;
constexpr std::uint64_t kBytesPerCorner = 300;  // The memory of the sweep and of the flips.

/// Points of a table, with exact predicates. The context is asked whether to stop.
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): final
class TablePoints final : public PlanarPoints {
 public:
  TablePoints(const PointTable2& points, Context& context) : points_(points), context_(context) {}
  std::uint32_t size() const override { return static_cast<std::uint32_t>(points_.size()); }
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const override {
    count();
    return orient2d(points_, i, j, k);
  }
  Sign compare(std::uint32_t i, std::uint32_t j) const override {
    return compare_xy(points_, i, j);
  }
  Sign incircle(std::uint32_t i, std::uint32_t j, std::uint32_t k, std::uint32_t l) const override {
    count();
    if (points_.is_double(i) && points_.is_double(j) && points_.is_double(k) &&
        points_.is_double(l)) {
      return plumb::incircle(points_.approx(i), points_.approx(j), points_.approx(k),
                             points_.approx(l));
    }
    return plumb::incircle(points_.exact(i), points_.exact(j), points_.exact(k), points_.exact(l));
  }

 private:
  void count() const {
    if (++asked_ % kSignsPerCheckpoint == 0) context_.checkpoint(kTriangulationPhase, 0, 0);
  }

  const PointTable2& points_;
  Context& context_;
  mutable std::uint32_t asked_ = 0;
};

/// Triangulates the region to the left of edges, and appends its triangles.
void add_triangles(const PlanarPoints& points, const std::vector<IndexEdge>& edges,
                   std::vector<IndexTriangle>& triangles) {
  if (edges.empty()) return;
  const bool is_region = triangulate(points, edges, triangles);
  PLUMB_CHECK(is_region);
  make_delaunay(points, edges, triangles);
}

// --- points -----------------------------------------------------------------------------------

/// Returns the points in lexicographic order, without duplicates.
std::vector<std::uint32_t> places_of(const PointTable2& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return compare_xy(points, i, j) == Sign::Negative;
  });
  const auto is_equal = [&](std::uint32_t i, std::uint32_t j) {
    return compare_xy(points, i, j) == Sign::Zero;
  };
  order.erase(std::unique(order.begin(), order.end(), is_equal), order.end());
  return order;
}

/// Appends the chain of the hull that only turns left, through all points on it.
template <class Range>
void add_chain(const PointTable2& points, const Range& order, std::vector<std::uint32_t>& hull) {
  const std::size_t fixed = hull.size();
  for (const std::uint32_t p : order) {
    while (hull.size() >= fixed + 2 &&
           orient2d(points, hull[hull.size() - 2], hull.back(), p) == Sign::Negative) {
      hull.pop_back();
    }
    hull.push_back(p);
  }
  hull.pop_back();  // The first point of the other chain.
}

/// Returns the edges of the convex hull, counter-clockwise; none if the points lie on a line.
std::vector<IndexEdge> hull_edges(const PointTable2& points,
                                  const std::vector<std::uint32_t>& order) {
  if (order.size() < 3) return {};
  const bool is_straight = std::all_of(order.begin(), order.end(), [&](std::uint32_t p) {
    return orient2d(points, order.front(), order.back(), p) == Sign::Zero;
  });
  if (is_straight) return {};
  std::vector<std::uint32_t> hull;
  add_chain(points, order, hull);
  add_chain(points, std::vector<std::uint32_t>(order.rbegin(), order.rend()), hull);
  std::vector<IndexEdge> edges;
  edges.reserve(hull.size());
  for (std::size_t i = 0; i < hull.size(); ++i) {
    edges.push_back({hull[i], hull[(i + 1) % hull.size()]});
  }
  return edges;
}

// --- sets -------------------------------------------------------------------------------------

/// Collects the vertices and edges of the marked faces of a set.
class MarkedRegion {
 public:
  explicit MarkedRegion(const PlaneComplex& complex)
      : complex_(complex), point_(complex.vertex_count(), kNoPoint) {}

  void collect(Context& context) {
    constexpr std::size_t kEdgesPerCheckpoint = 1024;
    for (std::size_t e = 0; e < complex_.edge_count(); ++e) {
      if (e % kEdgesPerCheckpoint == 0) {
        context.checkpoint(kTriangulationPhase, e, complex_.edge_count());
      }
      const HalfedgeId h(2 * e);
      if (is_inside(h)) add_edge(h);
      if (is_inside(twin(h))) add_edge(twin(h));
    }
    for (std::size_t v = 0; v < complex_.vertex_count(); ++v) {
      const VertexId vertex(v);
      if (!complex_.dcel.is_isolated(vertex)) continue;
      if (complex_.mark(complex_.dcel.face(complex_.dcel.isolated_loop(vertex)))) point(vertex);
    }
  }

  PointTable2 points;
  std::vector<IndexEdge> edges;

 private:
  static constexpr std::uint32_t kNoPoint = ~std::uint32_t{0};

  bool is_inside(HalfedgeId h) const {
    const FaceId face = complex_.dcel.face(h);
    return !complex_.is_beyond(face) && complex_.mark(face);
  }
  void add_edge(HalfedgeId h) {
    edges.push_back({point(complex_.dcel.origin(h)), point(complex_.dcel.origin(twin(h)))});
  }
  std::uint32_t point(VertexId v) {
    if (point_[v] == kNoPoint) {
      point_[v] = static_cast<std::uint32_t>(points.size());
      const RationalPoint2 at = exact(complex_.points, complex_.vertex_point[v]);
      points.push_back(at.x, at.y);
    }
    return point_[v];
  }

  const PlaneComplex& complex_;
  IdVector<VertexId, std::uint32_t> point_;
};

void require_bounded_faces(const PlaneComplex& complex) {
  for (std::size_t f = 0; f < complex.face_count(); ++f) {
    if (complex.mark(FaceId(f)) && is_unbounded(complex, FaceId(f))) {
      throw Error(ErrorCode::BadArgument, "an unbounded face cannot be triangulated");
    }
  }
}

}  // namespace

PlaneTriangulation delaunay(const PointTable2& points, Context& context) {
  MemoryCharge memory(context);
  memory.add(kBytesPerCorner * points.size(), kTriangulationPhase);
  std::vector<std::uint8_t> is_first(points.size(), 0);
  for (const std::uint32_t p : places_of(points)) is_first[p] = 1;
  std::vector<std::uint32_t> original;
  for (std::uint32_t p = 0; p < points.size(); ++p) {
    if (is_first[p] != 0) original.push_back(p);
  }
  const PointTable2 distinct = points.subset(is_first);
  PlaneTriangulation result;
  add_triangles(TablePoints(distinct, context), hull_edges(distinct, places_of(distinct)),
                result.triangles);
  for (IndexTriangle& triangle : result.triangles) {
    for (std::uint32_t& corner : triangle) corner = original[corner];
  }
  result.points = points;
  return result;
}

PlaneTriangulation delaunay(const Nef2& set, Context& context) {
  const PlaneComplex& complex = set.complex();
  require_bounded_faces(complex);
  MemoryCharge memory(context);
  memory.add(kBytesPerCorner * complex.vertex_count(), kTriangulationPhase);
  MarkedRegion region(complex);
  region.collect(context);
  PlaneTriangulation result;
  add_triangles(TablePoints(region.points, context), region.edges, result.triangles);
  result.points = std::move(region.points);
  return result;
}

}  // namespace plumb
