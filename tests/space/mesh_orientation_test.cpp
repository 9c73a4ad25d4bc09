// Faces that are turned round on purpose are found again, and holes are told apart from them.
#include "plumb/space/mesh/mesh_orientation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

#include "generate/meshes.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::mesh_orientation_test {
namespace {

using Faces = std::vector<std::uint32_t>;

MeshOrientation orientation(const PolygonMesh& mesh) {
  SpaceTables tables;
  const MeshView view(mesh);
  const MeshVertices vertices = merge_equal_points(view, tables);
  MeshOrientation found = orient_faces(view, vertices, tables.points, unlimited_context());
  for (auto& chain : found.holes) {
    for (std::uint32_t& v : chain) v = vertices.input[v];
  }
  return found;
}

PolygonMesh with_flips(PolygonMesh mesh, const Faces& faces) {
  reverse_faces(mesh, faces);
  return mesh;
}

const PolygonMesh kCube = box_mesh({0, 0, 0}, {1, 1, 1});

TEST(MeshOrientation, ClosedMeshesStayAsTheyAre) {
  const PolygonMesh hollow =
      joined(box_mesh({0, 0, 0}, {9, 9, 9}), moved(reversed(kCube), {2, 2, 2}));
  const PolygonMesh wall = joined(kCube, moved(kCube, {1, 0, 0}));
  const PolygonMesh touching = joined(kCube, moved(kCube, {1, 1, 0}));
  for (const PolygonMesh& mesh : {kCube, reversed(kCube), hollow, wall, touching,
                                  joined(kCube, kCube), joined(kCube, reversed(kCube))}) {
    const MeshOrientation found = orientation(mesh);
    EXPECT_EQ(found.flipped, Faces());
    EXPECT_TRUE(found.holes.empty());
    EXPECT_TRUE(found.one_sided.empty());
  }
}

// Any minority of the faces of each component.
TEST(MeshOrientation, FlippedFacesAreFound) {
  Dice dice(5);
  const PolygonMesh ball = icosphere_mesh(2, 3, {0, 0, 0});
  const PolygonMesh two = joined(ball, reversed(moved(ball, {9, 0, 0})));
  const auto half = static_cast<std::uint32_t>(ball.face_count());
  for (int round = 0; round < 50; ++round) {
    std::set<std::uint32_t> flips;
    const std::uint32_t most = half / 2 - 1;
    for (std::uint32_t i = dice.below(most); i > 0; --i) flips.insert(dice.below(half));
    for (std::uint32_t i = dice.below(most); i > 0; --i) flips.insert(half + dice.below(half));
    const Faces faces(flips.begin(), flips.end());
    const MeshOrientation found = orientation(with_flips(two, faces));
    EXPECT_EQ(found.flipped, faces);
    EXPECT_TRUE(found.holes.empty());
  }
}

TEST(MeshOrientation, OfEqualPartsTheOneThatMakesTheVolumePositiveIsTurned) {
  for (const Faces& faces : {Faces{0, 1, 2}, Faces{1, 3, 5}, Faces{0, 4, 5}}) {
    EXPECT_EQ(orientation(with_flips(kCube, faces)).flipped, faces);
    Faces others;
    for (std::uint32_t f = 0; f < 6; ++f) {
      if (std::ranges::find(faces, f) == faces.end()) others.push_back(f);
    }
    // Far away from the origin, where cones are large.
    const PolygonMesh far = moved(with_flips(reversed(kCube), faces), {1e6, -3e5, 7});
    EXPECT_EQ(orientation(far).flipped, others);
  }
}

// Solids that touch along an edge or have a wall in common are oriented by themselves.
TEST(MeshOrientation, ManyFacesAtAnEdge) {
  const PolygonMesh touching = joined(kCube, moved(kCube, {1, 1, 0}));
  for (std::uint32_t f = 0; f < 12; ++f) {
    EXPECT_EQ(orientation(with_flips(touching, {f})).flipped, Faces{f});
  }
  const PolygonMesh wall = joined(kCube, moved(kCube, {1, 0, 0}));
  for (const std::uint32_t f : {0U, 1U, 6U, 7U}) {  // Not the wall itself.
    const MeshOrientation found = orientation(with_flips(wall, {f}));
    EXPECT_EQ(found.flipped, Faces{f});
    EXPECT_TRUE(found.holes.empty());
  }
}

// A side of the cube in two rectangles, whose common edge ends inside edges of top and bottom.
TEST(MeshOrientation, VerticesOnEdges) {
  PolygonMesh cube = make_mesh({{0, 0, 0},
                                {2, 0, 0},
                                {2, 2, 0},
                                {0, 2, 0},
                                {0, 0, 2},
                                {2, 0, 2},
                                {2, 2, 2},
                                {0, 2, 2},
                                {1, 0, 0},
                                {1, 0, 2}},
                               {{3, 2, 1, 0},
                                {4, 5, 6, 7},
                                {0, 8, 9, 4},
                                {8, 1, 5, 9},
                                {1, 2, 6, 5},
                                {2, 3, 7, 6},
                                {3, 0, 4, 7}});
  EXPECT_TRUE(orientation(cube).holes.empty());
  for (std::uint32_t f = 0; f < 7; ++f) {
    const MeshOrientation found = orientation(with_flips(cube, {f}));
    EXPECT_EQ(found.flipped, Faces{f});
    EXPECT_TRUE(found.holes.empty());
  }
}

TEST(MeshOrientation, HolesAndFlippedFacesAreToldApart) {
  PolygonMesh box = kCube;
  box.corners.resize(box.corners.size() - 4);
  box.face_begin.pop_back();
  const Faces last(kCube.face(5).begin(), kCube.face(5).end());
  for (const Faces& flips : {Faces{}, Faces{0}, Faces{2}, Faces{1, 3}}) {
    const MeshOrientation found = orientation(with_flips(box, flips));
    EXPECT_EQ(found.flipped, flips);
    ASSERT_EQ(found.holes.size(), 1U);
    Faces hole = found.holes[0];
    std::rotate(hole.begin(), std::ranges::find(hole, last[0]), hole.end());
    EXPECT_EQ(hole, last);
  }
}

TEST(MeshOrientation, AMoebiusStripHasOneSide) {
  // Five quadrilaterals around; the last one is joined to the first one upside down.
  std::vector<Point3> points;
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i < 5; ++i) {
    const double x = i * i, y = i;  // No matter where: only incidences count.
    points.push_back({x, y, 0});
    points.push_back({x, y, 1.0 + i});
  }
  for (std::uint32_t i = 0; i < 4; ++i) faces.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  faces.push_back({8, 1, 0, 9});
  const MeshOrientation found = orientation(make_mesh(points, faces));
  EXPECT_EQ(found.one_sided, Faces{0});
  EXPECT_EQ(found.flipped, Faces());
  EXPECT_FALSE(found.holes.empty());
}

// A face of two corners, one with a repeated corner, and one without area between two others.
TEST(MeshOrientation, FacesWithoutAreaDisturbNothing) {
  PolygonMesh cube = kCube;
  cube.add_face(std::array{0U, 1U});
  cube.add_face(std::array{0U, 1U, 1U});
  cube.add_face(std::array{3U});
  EXPECT_EQ(orientation(with_flips(cube, {2})).flipped, Faces{2});
  EXPECT_TRUE(orientation(cube).holes.empty());
  EXPECT_EQ(orientation(PolygonMesh{}).flipped, Faces());
}

}  // namespace
}  // namespace plumb::testing::mesh_orientation_test
