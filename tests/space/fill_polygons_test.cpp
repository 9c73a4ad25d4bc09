// What fills a hole, or replaces a face, has the same boundary; in a plane it has the same area.
#include "plumb/space/mesh/fill_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "generate/meshes.h"
#include "plumb/predicates/rational.h"
#include "plumb/space/mesh/mesh_vertices.h"
#include "plumb/space/nef3.h"
#include "plumb/space/repair_mesh.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::fill_polygons_test {
namespace {

using Boundary = std::map<std::array<std::uint32_t, 2>, std::int64_t>;

void add_boundary(Boundary& sum, std::span<const std::uint32_t> face, std::int64_t times) {
  for (std::size_t i = 0; i < face.size(); ++i) {
    const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
    if (a != b) sum[{std::min(a, b), std::max(a, b)}] += a < b ? times : -times;
  }
}

bool is_zero(const Boundary& sum) {
  return std::ranges::all_of(sum, [](const auto& s) { return s.second == 0; });
}

std::uint32_t filled(PolygonMesh& mesh, const std::vector<std::uint32_t>& chain) {
  PolygonMesh used = mesh;
  used.add_face(chain);  // Only points with a face have a place.
  SpaceTables tables;
  const MeshVertices vertices = merge_equal_points(used, tables);
  std::vector<SpacePoint> place;
  for (const std::uint32_t v : vertices.of_point) {
    place.push_back(v == kNone ? SpacePoint() : vertices.point[v]);
  }
  return fill_hole(mesh, chain, place, tables);
}

TEST(FillPolygons, AHoleInAPlaneIsOneFace) {
  PolygonMesh mesh;
  mesh.points = {{0, 0, 0}, {4, 0, 4}, {4, 3, 4}, {2, 1, 2}, {0, 3, 0}};  // Not convex.
  EXPECT_EQ(filled(mesh, {0, 1, 2, 3, 4}), 1U);
  EXPECT_EQ(mesh.face(0).size(), 5U);
}

TEST(FillPolygons, OtherHolesGetTrianglesWithTheirBoundary) {
  Dice dice(31);
  for (const std::uint32_t k : {4U, 5U, 9U, 40U, 100U, 101U, 300U}) {
    PolygonMesh mesh;
    std::vector<std::uint32_t> chain;
    for (std::uint32_t i = 0; i < k; ++i) {
      mesh.points.push_back(
          {std::cos(i * 6.28 / k), std::sin(i * 6.28 / k), static_cast<double>(dice.below(5))});
      chain.push_back(k - 1 - i);
    }
    const std::uint32_t added = filled(mesh, chain);
    EXPECT_EQ(added, k > 100 ? 1 : k - 2);
    Boundary sum;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) add_boundary(sum, mesh.face(f), 1);
    add_boundary(sum, chain, -1);
    EXPECT_TRUE(is_zero(sum)) << k;
  }
}

// A square whose corners 1 and 3 are lifted by different heights has two triangulations.
TEST(FillPolygons, TheSmallerAreaIsChosen) {
  PolygonMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 5}, {1, 1, 0}, {0, 1, 5}};
  EXPECT_EQ(filled(mesh, {0, 1, 2, 3}), 2U);
  // Both triangulations have equal areas here; the first apex is taken.
  EXPECT_EQ(std::vector(mesh.face(0).begin(), mesh.face(0).end()),
            (std::vector<std::uint32_t>{0, 1, 3}));
  PolygonMesh roof;
  roof.points = {{0, 0, 0}, {4, 0, 0}, {4, 1, 3}, {0, 1, 0}};
  EXPECT_EQ(filled(roof, {0, 1, 2, 3}), 2U);
  const auto shares = [&](std::uint32_t a, std::uint32_t b) {
    int count = 0;
    for (std::size_t f = 0; f < roof.face_count(); ++f) {
      const auto face = roof.face(f);
      count += std::ranges::count(face, a) > 0 && std::ranges::count(face, b) > 0 ? 1 : 0;
    }
    return count == 2;
  };
  const auto area = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Point3 &p = roof.points[a], &q = roof.points[b], &r = roof.points[c];
    const Point3 u{q.x - p.x, q.y - p.y, q.z - p.z}, v{r.x - p.x, r.y - p.y, r.z - p.z};
    return std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
  };
  const double by_02 = area(0, 1, 2) + area(0, 2, 3), by_13 = area(0, 1, 3) + area(1, 2, 3);
  EXPECT_NE(by_02, by_13);
  EXPECT_EQ(shares(0, 2), by_02 < by_13);
}

TEST(FillPolygons, FacesAreCutWithoutANewVertex) {
  const PolygonMesh comb = prism_mesh(
      {{0, 0}, {9, 0}, {9, 4}, {7, 4}, {7, 1}, {5, 1}, {5, 4}, {4, 2}, {3, 4}, {0, 4}}, 0, 2);
  for (const PolygonMesh& mesh : {comb, turned(comb, 0.3), reversed(comb)}) {
    const PolygonMesh cut = triangulated(mesh);
    EXPECT_EQ(cut.points.size(), mesh.points.size());
    Boundary sum;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) add_boundary(sum, mesh.face(f), -1);
    for (std::size_t f = 0; f < cut.face_count(); ++f) {
      EXPECT_EQ(cut.face(f).size(), 3U);
      add_boundary(sum, cut.face(f), 1);
    }
    EXPECT_TRUE(is_zero(sum));
  }
  EXPECT_TRUE(Nef3::from_mesh(triangulated(comb)) == Nef3::from_mesh(comb));
  // Faces without area, and a face that touches itself.
  PolygonMesh odd;
  odd.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 1, 0}};
  odd.add_face(std::array{0U, 1U, 2U, 3U});
  odd.add_face(std::array{0U, 1U, 4U, 0U, 2U, 4U});
  const PolygonMesh cut = triangulated(odd);
  Boundary sum;
  for (std::size_t f = 0; f < odd.face_count(); ++f) add_boundary(sum, odd.face(f), -1);
  for (std::size_t f = 0; f < cut.face_count(); ++f) add_boundary(sum, cut.face(f), 1);
  EXPECT_TRUE(is_zero(sum));
}

}  // namespace
}  // namespace plumb::testing::fill_polygons_test
