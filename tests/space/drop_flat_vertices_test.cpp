// drop_flat_vertices() on solids whose faces are divided more than they need: vertices near edges
// and faces go, distances are as stated by brute force, and real corners stay.
#include "plumb/space/mesh/drop_flat_vertices.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "generate/meshes.h"
#include "generate/test_share.h"
#include "oracle/valid_mesh_check.h"
#include "plumb/space/mesh/doubtful_faces.h"
#include "plumb/testing/dice.h"

namespace plumb::drop_flat_vertices_test {
namespace {

using testing::box_mesh;
using testing::Dice;
using testing::fanned;

constexpr double kUnit = 0x1p-52;

FlattenedMesh dropped(const PolygonMesh& mesh, const std::vector<std::uint8_t>& is_removable,
                      double width = 4 * kUnit) {
  return drop_flat_vertices(mesh, is_removable, faces_at(mesh, is_removable), width,
                            unlimited_context());
}
std::vector<std::uint8_t> from(const PolygonMesh& mesh, std::size_t first) {
  std::vector<std::uint8_t> result(mesh.points.size(), 0);
  for (std::size_t v = first; v < result.size(); ++v) result[v] = 1;
  return result;
}

/// Inserts a vertex into an edge, at a rounded place. All faces of the edge are divided.
PolygonMesh with_vertex_on_edge(const PolygonMesh& mesh, std::uint32_t a, std::uint32_t b,
                                double part) {
  const Point3 &p = mesh.points[a], &q = mesh.points[b];
  PolygonMesh result;
  result.points = mesh.points;
  const auto v = static_cast<std::uint32_t>(result.points.size());
  result.points.push_back(
      {p.x + part * (q.x - p.x), p.y + part * (q.y - p.y), p.z + part * (q.z - p.z)});
  for (std::size_t g = 0; g < mesh.face_count(); ++g) {
    const auto t = mesh.face(g);
    bool is_divided = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t x = t[i], y = t[(i + 1) % 3], z = t[(i + 2) % 3];
      if (!(x == a && y == b) && !(x == b && y == a)) continue;
      result.add_face(std::array{x, v, z});
      result.add_face(std::array{v, y, z});
      is_divided = true;
    }
    if (!is_divided) result.add_face(t);
  }
  return result;
}

/// The same for the first edge of a face.
PolygonMesh with_vertex_on_edge(const PolygonMesh& mesh, std::size_t f, double part) {
  return with_vertex_on_edge(mesh, mesh.face(f)[0], mesh.face(f)[1], part);
}

PolygonMesh turned_box(double angle) {
  return fanned(testing::turned(box_mesh({1, 1, 1}, {2, 2, 2}), angle));
}

TEST(DropFlatVertices, DividedBoxesBecomeBoxes) {
  const std::uint64_t cases = testing::share_of(30);
  std::uint64_t kept = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    SCOPED_TRACE(i);
    Dice dice(i);
    PolygonMesh mesh = turned_box(0.01 * static_cast<double>(dice.between(1, 150)));
    for (int k = 0; k < 12; ++k) {
      const double part = 0.1 * static_cast<double>(dice.between(2, 8)) + 0.01;
      mesh = with_vertex_on_edge(mesh, dice.below(mesh.face_count()), part);
    }
    if (testing::invalid_mesh(mesh, CoordinateType::Double) != "") continue;
    const FlattenedMesh flat = dropped(mesh, from(mesh, 8));
    const PolygonMesh& result = flat.changes.mesh;
    ASSERT_GT(flat.removed, 0U);
    EXPECT_EQ(testing::invalid_mesh(result, CoordinateType::Double), "");
    EXPECT_EQ(result.face_count(), mesh.face_count() - 2 * flat.removed);
    EXPECT_TRUE(testing::is_within(mesh, result, flat.changes.largest_move));
    EXPECT_TRUE(testing::is_within(result, mesh, flat.changes.largest_move));
    EXPECT_LT(flat.changes.largest_move, 64 * kUnit * 4);
    EXPECT_EQ(flat.changes.origin.size(), result.face_count());
    kept += 12 - flat.removed;
  }
  EXPECT_LT(kept, cases);  // Nearly all of the 12 vertices of each box go.
}

TEST(DropFlatVertices, OnlyChosenVerticesGo) {
  const PolygonMesh mesh = with_vertex_on_edge(turned_box(0.3), 0, 0.5);
  EXPECT_EQ(dropped(mesh, from(mesh, 8)).removed, 1U);
  EXPECT_EQ(dropped(mesh, from(mesh, 9)).removed, 0U);
  EXPECT_EQ(dropped(mesh, from(mesh, 0)).removed, 1U);  // Corners of the box stay.
  EXPECT_EQ(dropped(mesh, from(mesh, 0), 0).removed, 0U);
}

TEST(DropFlatVertices, CurvedSurfacesStay) {
  const PolygonMesh sphere = testing::icosphere_mesh(4, 1, {0, 0, 0});
  EXPECT_TRUE(dropped(sphere, from(sphere, 0)).changes.changed.empty());
}

TEST(DropFlatVertices, VerticesFartherThanTheWidthStay) {
  PolygonMesh mesh = with_vertex_on_edge(turned_box(0.3), 0, 0.5);
  mesh.points.back().z += 64 * kUnit;
  EXPECT_EQ(dropped(mesh, from(mesh, 8)).removed, 0U);
  EXPECT_EQ(dropped(mesh, from(mesh, 8), 256 * kUnit).removed, 1U);
}

/// Two boxes over a common edge. One of them has a vertex in the middle of it, the other one has
/// the whole edge, which would get four faces.
TEST(DropFlatVertices, EdgesOfMoreThanTwoFacesAreNotMade) {
  PolygonMesh mesh = testing::joined(fanned(box_mesh({0, 0, 0}, {1, 1, 1})),
                                     fanned(box_mesh({1, 1, 0}, {2, 2, 1})));
  std::vector<std::uint32_t> ends;  // Of the common edge, in the first box.
  for (std::uint32_t v = 0; v < 8; ++v) {
    if (mesh.points[v].x == 1 && mesh.points[v].y == 1) ends.push_back(v);
  }
  ASSERT_EQ(ends.size(), 2U);
  mesh = with_vertex_on_edge(mesh, ends[0], ends[1], 0.5);
  EXPECT_EQ(dropped(mesh, from(mesh, 16)).removed, 1U);  // The boxes have vertices of their own.
  for (std::uint32_t& v : mesh.corners) {
    for (std::uint32_t w = 0; w < v; ++w) {
      if (mesh.points[w] == mesh.points[v]) v = w;
    }
  }
  EXPECT_EQ(dropped(mesh, from(mesh, 16)).removed, 0U);
}

}  // namespace
}  // namespace plumb::drop_flat_vertices_test
