#include "plumb/convex/plane_diagonals.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

#include "plumb/base/error.h"
#include "plumb/convex/plane_cuts.h"
#include "plumb/predicates/rational_predicates.h"
#include "plumb/space/planar_points.h"
#include "plumb/space/triangulate.h"

namespace plumb {
namespace {

constexpr const char* kPhase = "convex partition";
constexpr std::uint32_t kStride = 4096;  // steps between checkpoints

/// The vertices of a region that has no cuts yet: input points. Who asks for signs looks at the context.
// NOLINTNEXTLINE(cppcoreguidelines-virtual-class-destructor): final
class RegionPoints final : public PlanarPoints {
 public:
  RegionPoints(const PlaneRegion& region, Context& context) : r_(region), context_(context) {}
  std::uint32_t size() const override { return static_cast<std::uint32_t>(r_.vertex_count()); }
  Sign orient(std::uint32_t i, std::uint32_t j, std::uint32_t k) const override {
    if (++asked_ % kStride == 0) context_.checkpoint(kPhase, 0, size());
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
  HalfedgeId half;  ///< of the boundary
  std::size_t triangle_side = 0;
};

/// Edges of all triangles: which half-edge each side is.
std::vector<HalfedgeId> halves_of_sides(PlaneRegion& region, std::vector<TriangleSide> sides,
                                        std::size_t count, Context& context) {
  // The two halves of an edge are neighbours, and so are a side of a triangle and the boundary there.
  std::ranges::sort(sides, {}, [](const TriangleSide& s) {
    const auto [low, high] = std::minmax(s.from, s.to);
    return std::tuple(low, high, s.from, !s.half.is_valid());
  });
  std::vector<HalfedgeId> half(count);
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    if (i % kStride == 0) context.checkpoint(kPhase, i, sides.size());
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
  // Of n corners there are n triangles at most but for holes, whose corners count twice; their sides, and the half-edges
  // of diagonals.
  constexpr std::uint64_t kHalfBytes =
      2 * sizeof(TriangleSide) * 3 + sizeof(IndexEdge) + 2 * sizeof(IndexTriangle) + 64;
  MemoryCharge memory(context);
  memory.add(kHalfBytes * (region.halfedge_count() + region.vertex_count()), kPhase);
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
    region.next[half[s].value()] = following;
    region.prev[following.value()] = half[s];
  }
}

void cut_by_diagonals(PlaneRegion& region, Context& context) {
  triangulate(region, context);
  drop_superfluous(region);
}

}  // namespace plumb
