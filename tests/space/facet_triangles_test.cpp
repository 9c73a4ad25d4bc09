// Shapes of polygons against all pairs of their sides in integers, edges that cancel against
// counts, and triangles of facets against areas and corners.
#include "plumb/space/planar/facet_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <vector>

#include "generate/space_scenes.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/testing/dice.h"

namespace plumb::facet_triangles_test {
namespace {

using testing::Dice;
using testing::SpaceScene;

using Corners = std::vector<std::uint32_t>;
using Place = std::array<int, 2>;

/// Points of the plane z = x + 2 y, looked at from above.
struct Laid {
  explicit Laid(const std::vector<Place>& places) : flat(tables.points) {
    flat.reset({2, false});
    for (const auto& [x, y] : places) {
      const Point3 p{1.0 * x, 1.0 * y, 1.0 * (x + 2 * y)};
      flat.push_back(SpacePoint(tables.planes.add_point(p)));
    }
  }
  SpaceTables tables;
  FlatPoints flat;
};

int turn(const Place& a, const Place& b, const Place& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
/// Is p on the closed segment?
bool is_on(const Place& p, const Place& a, const Place& b) {
  return turn(a, b, p) == 0 && std::min(a, b) <= p && p <= std::max(a, b);
}
bool have_common_inside(const Place& a, const Place& b, const Place& c, const Place& d) {
  const auto sign = [](int s) { return (s > 0) - (s < 0); };
  return sign(turn(a, b, c)) * sign(turn(a, b, d)) < 0 &&
         sign(turn(c, d, a)) * sign(turn(c, d, b)) < 0;
}

/// By all pairs of sides; those run there and back are left out first.
PolygonShape shape_by_force(const std::vector<Place>& at, const Corners& corners) {
  std::map<IndexEdge, int> runs;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t a = corners[i], b = corners[(i + 1) % corners.size()];
    runs[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
  }
  std::vector<IndexEdge> sides;
  for (const auto& [e, times] : runs) {
    if (std::abs(times) > 1) return PolygonShape::Crossing;
    if (times != 0) sides.push_back(e);
  }
  for (const IndexEdge& e : sides) {
    for (const IndexEdge& f : sides) {
      if (e == f) continue;
      if (have_common_inside(at[e[0]], at[e[1]], at[f[0]], at[f[1]])) return PolygonShape::Crossing;
      for (const std::uint32_t v : f) {
        if (v != e[0] && v != e[1] && is_on(at[v], at[e[0]], at[e[1]])) {
          return PolygonShape::Crossing;
        }
      }
    }
  }
  const bool repeats =
      std::set<std::uint32_t>(corners.begin(), corners.end()).size() < corners.size();
  return repeats ? PolygonShape::Touching : PolygonShape::Simple;
}

TEST(FacetTriangles, ShapesAsAllPairsOfSidesSay) {
  Dice dice(4);
  std::array<int, 3> seen{};
  Context context;
  for (int round = 0; round < 3000; ++round) {
    std::set<Place> chosen;
    const int size = round % 2 == 0 ? 2 : 4;
    while (chosen.size() < 3 + dice.below(3)) {
      const int x = static_cast<int>(dice.between(0, size));
      chosen.insert({x, static_cast<int>(dice.between(0, size))});
    }
    const std::vector<Place> at(chosen.begin(), chosen.end());
    Corners corners;
    while (corners.size() < 3 + dice.below(5) || corners.front() == corners.back()) {
      const std::uint32_t v = dice.below(at.size());
      if (corners.empty() || corners.back() != v) corners.push_back(v);
    }
    const PolygonShape shape = shape_by_force(at, corners);
    const Laid laid(at);
    EXPECT_EQ(shape_of(laid.flat, corners, context), shape) << round;
    ++seen[static_cast<std::size_t>(shape)];
    if (shape != PolygonShape::Simple) continue;
    int area = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      area += turn(at[corners[0]], at[corners[i]], at[corners[i + 1]]);
    }
    if (area == 0) continue;
    EXPECT_EQ(orientation_of(laid.flat, corners), area > 0 ? Sign::Positive : Sign::Negative);
  }
  for (const int count : seen) EXPECT_GT(count, 30);
}

TEST(FacetTriangles, EdgesThatAreMetBothWaysCancel) {
  Dice dice(5);
  for (int round = 0; round < 200; ++round) {
    std::vector<IndexEdge> edges;
    std::map<IndexEdge, int> sum;  // from the lesser to the greater end
    for (std::size_t i = dice.below(12); i > 0; --i) {
      const std::uint32_t a = dice.below(3), b = a + 1 + dice.below(2);
      const bool is_back = dice.below(2) == 1;
      edges.push_back(is_back ? IndexEdge{b, a} : IndexEdge{a, b});
      sum[{a, b}] += is_back ? -1 : 1;
    }
    cancel_reverses(edges);
    std::vector<IndexEdge> expected;
    for (const auto& [e, times] : sum) {
      const IndexEdge kept = times > 0 ? e : IndexEdge{e[1], e[0]};
      expected.insert(expected.end(), static_cast<std::size_t>(std::abs(times)), kept);
    }
    EXPECT_EQ(edges, expected);
  }
  EXPECT_EQ(boundary_of(Corners{0, 1, 2, 3, 2, 1}), (std::vector<IndexEdge>{}));
  EXPECT_EQ(boundary_of(Corners{2, 0, 1}), (std::vector<IndexEdge>{{0, 1}, {2, 0}, {1, 2}}));
}

using testing::cross;
using testing::dot;
using testing::operator+;

/// Facets with holes, slits and vertices inside, reflex corners, corners of half a turn.
SpaceScene scene_of_facets() {
  SpaceScene scene;
  testing::add_frame_box(scene, {0, 0, 0}, {3, 6, Rational(7, 3)});
  scene.add_facet({{10, 0, 0}, {16, 0, 1}, {16, 6, 7}, {10, 6, 6}},
                  {{{11, 1, Rational(7, 6)}, {11, 3, Rational(19, 6)}, {13, 3, Rational(7, 2)}}});
  const std::uint32_t slit = scene.add_point({14, 2, Rational(8, 3)});
  scene.facets.back().cycles.push_back({slit, scene.add_point({15, 4, Rational(29, 6)})});
  scene.facets.back().inner = {scene.add_point({12, 5, Rational(16, 3)})};
  scene.add_facet({{20, 0, 0}, {22, 0, 0}, {24, 0, 0}, {21, 1, 0}, {20, 4, 0}});
  scene.add_facet({{30, 0, 0}, {34, 0, 0}, {34, 0, 4}, {32, 0, 1}, {30, 0, 4}});
  scene.add_facet({{40, 0, 0}, {41, 0, 0}, {40, 1, 5}});
  return scene;
}

TEST(FacetTriangles, CoverTheFacetOnce) {
  const SpaceComplex c = testing::complex_without_volumes(scene_of_facets());
  std::vector<RationalPoint3> at;
  for (const SpacePoint p : c.vertex_point) at.push_back(exact(c.points(), p));
  std::vector<RoundedPoint3> nearest;
  for (const SpacePoint p : c.vertex_point) nearest.push_back(rounded(c.points(), p));
  for (const bool is_rounded : {false, true}) {
    FacetTriangles triangles(c);
    if (is_rounded) triangles.use_nearest(nearest);
    for (std::uint32_t f = 0; f < c.facet_count(); ++f) {
      const IntegerRow row = c.planes().coefficients(c.facet_plane[f]);
      const RationalPoint3 normal{row[0], row[1], row[2]};
      RationalPoint3 area{0, 0, 0};
      std::set<VertexId> vertices(c.inner_of(FacetId(f)).begin(), c.inner_of(FacetId(f)).end());
      for (std::uint32_t u = 0; u < c.use_count(); ++u) {
        if (c.use_facet[u] != FacetId(f)) continue;
        const VertexId v = c.use_origin(UseId(u)), w = c.use_origin(c.use_next[u]);
        area = area + cross(at[v.value()], at[w.value()]);
        vertices.insert(v);
      }
      std::set<VertexId> corners;
      triangles.for_each(FacetId(f), [&](VertexId i, VertexId j, VertexId k) {
        const std::array<RationalPoint3, 3> p{at[i.value()], at[j.value()], at[k.value()]};
        const RationalPoint3 twice = cross(p[1] - p[0], p[2] - p[0]);
        EXPECT_GT(dot(twice, normal), 0) << "counter-clockwise";
        area = area - twice;
        corners.insert({i, j, k});
        for (const VertexId v : vertices) {  // none lies within or on a side
          int beside = 0;
          for (std::size_t s = 0; s < 3; ++s) {
            const RationalPoint3 side = p[(s + 1) % 3] - p[s];
            beside += dot(cross(side, at[v.value()] - p[s]), normal) < 0 ? 1 : 0;
          }
          EXPECT_EQ(beside == 0, v == i || v == j || v == k);
        }
      });
      EXPECT_EQ(area, (RationalPoint3{0, 0, 0})) << "facet " << f;
      EXPECT_EQ(corners, vertices) << "facet " << f;
    }
  }
}

}  // namespace
}  // namespace plumb::facet_triangles_test
