// Complexes made of meshes: the links are what they should be, and what is wrong with a mesh is
// said.
#include "plumb/space/from_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "generate/crowded_points.h"
#include "generate/meshes.h"
#include "plumb/predicates/error.h"
#include "plumb/space/mesh/mesh_vertices.h"
#include "space/complex_links.h"

namespace plumb::testing::from_mesh_test {
namespace {

using FacePair = MeshReport::FacePair;
using Faces = std::vector<std::uint32_t>;

MeshComplex made(const PolygonMesh& mesh, bool surface = false) {
  Context context;
  MeshOptions options;
  options.surface = surface;
  MeshComplex result = complex_of_mesh(mesh, options, context);
  EXPECT_EQ(broken_link(result.complex), "");
  EXPECT_EQ(result.jump.size(), result.complex.facet_count());
  return result;
}

// Faces are numbered: bottom, top, then the sides.
const PolygonMesh kCube = box_mesh({0, 0, 0}, {1, 1, 1});

TEST(FromMesh, Cube) {
  const MeshComplex cube = made(kCube);
  EXPECT_EQ(cube.complex.vertex_count(), 8U);
  EXPECT_EQ(cube.complex.edge_count(), 12U);
  EXPECT_EQ(cube.complex.facet_count(), 6U);
  EXPECT_EQ(enclosed_volume(cube.complex, cube.jump), 6);
  EXPECT_EQ(cube.complex.facet_origin, (Faces{0, 1, 2, 3, 4, 5}));
  EXPECT_TRUE(cube.report.inside_out.empty());
  EXPECT_EQ(cube.component, Faces(6, 0));
}

TEST(FromMesh, TrianglesOfOnePlaneGetAuxiliaryPlanes) {
  const MeshComplex cube = made(fanned(kCube));
  EXPECT_EQ(cube.complex.edge_count(), 18U);
  EXPECT_EQ(enclosed_volume(cube.complex, cube.jump), 6);
}

TEST(FromMesh, InsideOut) {
  const MeshComplex cube = made(reversed(kCube));
  EXPECT_EQ(enclosed_volume(cube.complex, cube.jump), -6);
  EXPECT_EQ(cube.report.inside_out, Faces{0});
  const MeshComplex two = made(joined(kCube, moved(reversed(kCube), {3, 0, 0})));
  EXPECT_EQ(two.report.inside_out, Faces{6});
  EXPECT_EQ(two.is_inside_out, (std::vector<std::uint8_t>{0, 1}));
}

TEST(FromMesh, EqualPointsAreOneVertex) {
  PolygonMesh soup;
  const PolygonMesh cube = fanned(kCube);
  for (const std::uint32_t v : cube.corners) soup.points.push_back(cube.points[v]);
  for (std::uint32_t i = 0; i < cube.corners.size(); i += 3)
    soup.add_face(std::array{i, i + 1, i + 2});
  for (Point3& p : soup.points) p.x = p.x == 0 && p.y == 0 ? -0.0 : p.x;
  soup.points.push_back({7, 7, 7});  // used by no face
  const MeshComplex result = made(soup);
  EXPECT_EQ(result.complex.vertex_count(), 8U);
  EXPECT_EQ(result.report.vertices_merged, 28U);
  EXPECT_EQ(enclosed_volume(result.complex, result.jump), 6);
}

TEST(FromMesh, PointsThatCrowdInATableAreFoundAsOthersAre) {
  PolygonMesh soup;
  soup.points = crowded_points(9999);
  soup.points.insert(soup.points.end(), soup.points.begin(), soup.points.end());
  for (std::uint32_t i = 0; i < soup.points.size(); i += 3)
    soup.add_face(std::array{i, i + 1, i + 2});
  SpaceTables tables;
  const MeshVertices vertices = merge_equal_points(soup, tables);
  EXPECT_EQ(vertices.point.size(), 9999U);
  EXPECT_EQ(vertices.merged, 9999U);
  for (std::uint32_t i = 0; i < 9999; ++i) {
    ASSERT_EQ(vertices.of_point[i], i);
    ASSERT_EQ(vertices.of_point[9999 + i], i);
  }
}

TEST(FromMesh, RationalVertices) {
  PolygonMesh cube = kCube;
  // Corner (1, 1, 1) and its copy go to (1/3 + 1, ...), exactly the same place.
  const Rational c = Rational(4) / 3;
  for (std::uint32_t v = 0; v < 8; ++v) {
    Point3& p = cube.points[v];
    const RationalPoint3 at{p.x * c, p.y * c, p.z * c};
    if (p.x + p.y + p.z > 0) cube.exact.emplace_back(v, at);
  }
  const MeshComplex result = made(fanned(cube));
  EXPECT_EQ(result.complex.vertex_count(), 8U);
  EXPECT_EQ(enclosed_volume(result.complex, result.jump), 6 * c * c * c);
  EXPECT_TRUE(result.report.not_planar.empty());
  EXPECT_TRUE(made(cube).report.not_planar.empty());
  EXPECT_EQ(made(reversed(cube)).report.inside_out, Faces{0});
}

TEST(FromMesh, OpenBoxListsItsBorder) {
  PolygonMesh box = kCube;
  box.corners.erase(box.corners.begin() + 4, box.corners.begin() + 8);  // the top: 4 5 6 7
  box.face_begin.pop_back();
  const MeshComplex open = made(box);
  ASSERT_EQ(open.report.borders.size(), 1U);
  Faces chain = open.report.borders[0];
  std::rotate(chain.begin(), std::ranges::min_element(chain), chain.end());
  EXPECT_EQ(chain, (Faces{4, 5, 6, 7}));  // the face that closes it
  EXPECT_EQ(open.complex.facet_count(), 0U);

  const MeshComplex surface = made(box, true);
  EXPECT_EQ(surface.complex.facet_count(), 5U);
  EXPECT_FALSE(surface.report.is_closed());
}

TEST(FromMesh, BordersOfAHoleAndAFlippedFace) {
  PolygonMesh cube = fanned(kCube);
  std::swap(cube.corners[0], cube.corners[1]);
  const MeshReport report = made(cube).report;
  // Each edge of the flipped triangle is run through twice: the border goes around it twice.
  ASSERT_EQ(report.borders.size(), 2U);
  for (const auto& chain : report.borders) EXPECT_EQ(chain.size(), 3U);
}

TEST(FromMesh, TwoTetrahedraAtAnEdge) {
  for (const bool is_second_out : {false, true}) {
    const PolygonMesh a = tetrahedron_mesh({0, 0, 0}, {0, 0, 2}, {1, 2, 0}, {2, 1, 0});
    const PolygonMesh b = tetrahedron_mesh({0, 0, 0}, {0, 0, 2}, {-1, -2, 0}, {-2, -1, 0});
    const MeshComplex two = made(joined(a, is_second_out ? reversed(b) : b));
    EXPECT_EQ(two.complex.vertex_count(), 6U);
    EXPECT_EQ(two.complex.edge_count(), 11U);
    EXPECT_EQ(two.report.vertices_merged, 2U);
    EXPECT_TRUE(two.report.is_closed());
    EXPECT_EQ(two.is_inside_out.size(), 2U);  // each closed on its own
  }
}

TEST(FromMesh, TwoCubesAtAVertex) {
  const MeshComplex two = made(joined(kCube, moved(kCube, {1, 1, 1})));
  EXPECT_EQ(two.complex.vertex_count(), 15U);
  EXPECT_EQ(two.is_inside_out, (std::vector<std::uint8_t>{0, 0}));
}

TEST(FromMesh, ManyUsesAroundAnEdge) {
  // Wedges around the z axis: a fan of n tetrahedra, every second sector.
  std::vector<Point3> ring = {{3, 0, 0},   {3, 1, 0},  {2, 2, 0},  {0, 3, 0},
                              {-1, 3, 0},  {-3, 3, 0}, {-3, 0, 0}, {-3, -1, 0},
                              {-1, -1, 0}, {0, -3, 0}, {1, -3, 0}, {2, -1, 0}};
  PolygonMesh all;
  Rational volume = 0;
  for (std::size_t i = 0; i < ring.size(); i += 2) {
    const PolygonMesh t = tetrahedron_mesh({0, 0, 1}, ring[i], ring[i + 1], {0, 0, 0});
    volume += ring[i].x * ring[i + 1].y - ring[i].y * ring[i + 1].x;
    all = joined(all, i % 4 == 0 ? t : fanned(t));
  }
  const MeshComplex made_all = made(all);
  EXPECT_EQ(made_all.complex.vertex_count(), 14U);
  EXPECT_EQ(enclosed_volume(made_all.complex, made_all.jump), volume);
  EXPECT_EQ(made_all.is_inside_out, std::vector<std::uint8_t>(6, 0));
}

TEST(FromMesh, DoubledFacesAreOneFacet) {
  const MeshComplex twice = made(joined(kCube, kCube));
  EXPECT_EQ(twice.complex.facet_count(), 6U);
  EXPECT_EQ(enclosed_volume(twice.complex, twice.jump), 12);
  EXPECT_EQ(twice.report.doubled.size(), 6U);
  EXPECT_EQ(twice.report.doubled[0], FacePair(6, 0));
  // Two cubes with a wall between them: the wall is there, and jumps by 0.
  const MeshComplex wall = made(joined(kCube, moved(kCube, {1, 0, 0})));
  EXPECT_EQ(wall.complex.facet_count(), 11U);
  EXPECT_EQ(std::ranges::count(wall.jump, 0), 1);
  EXPECT_EQ(enclosed_volume(wall.complex, wall.jump), 12);
  EXPECT_EQ(wall.is_inside_out.size(), 2U);  // all but the wall, which bounds nothing
}

TEST(FromMesh, QuadOffItsPlane) {
  PolygonMesh cube = kCube;
  cube.points[6].z += 1e-9;
  const MeshComplex result = made(cube);
  // The top by its diagonal 5-7 or 4-6; the sides at the corner are still in their planes.
  EXPECT_EQ(result.report.not_planar, Faces{1});
  EXPECT_EQ(result.complex.facet_count(), 7U);
  EXPECT_EQ(std::ranges::count(result.complex.facet_origin, 1U), 2);
}

TEST(FromMesh, DegenerateFacesAreNamed) {
  // A vertex in the middle of an edge of a tetrahedron, closed by a triangle without area.
  PolygonMesh mesh = tetrahedron_mesh({0, 0, 0}, {0, 2, 0}, {2, 0, 0}, {0, 0, 2});
  mesh.points.push_back({0, 1, 0});
  PolygonMesh split =
      make_mesh(mesh.points, {{0, 4, 2}, {4, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}, {0, 1, 4}});
  const MeshComplex result = made(split);
  EXPECT_EQ(result.report.degenerate, Faces{5});
  EXPECT_TRUE(result.report.is_closed());
  // Faces of one or two corners, and repeated ones.
  PolygonMesh odd = kCube;
  odd.add_face(Face{0, 1});
  odd.add_face(Face{0, 1, 0, 1});
  odd.add_face(Face{0, 0, 0});
  odd.add_face(Face{});
  const MeshReport report = made(odd).report;
  EXPECT_EQ(report.degenerate, (Faces{6, 7, 8, 9}));
  EXPECT_EQ(report.trimmed, (Faces{7, 8}));
}

TEST(FromMesh, SpikesAreCutOff) {
  PolygonMesh cube = kCube;
  cube.points.push_back({0.5, 0.5, 3});
  cube.corners.insert(cube.corners.begin() + 6, {6, 8, 6, 6, 8});  // in the top face
  // top: 4 5 6 | 8 ... : 4 5 6 8 6 6 8 6 7
  for (std::size_t f = 2; f < cube.face_begin.size(); ++f) cube.face_begin[f] += 5;
  const MeshComplex result = made(cube);
  EXPECT_EQ(result.report.trimmed, Faces{1});
  EXPECT_EQ(result.complex.vertex_count(), 8U);
  EXPECT_EQ(enclosed_volume(result.complex, result.jump), 6);
}

TEST(FromMesh, BadInputIsRefused) {
  PolygonMesh bad = kCube;
  bad.corners[3] = 8;
  Context context;
  EXPECT_THROW(complex_of_mesh(bad, {}, context), Error);
  bad = kCube;
  bad.points[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(complex_of_mesh(bad, {}, context), Error);
  EXPECT_EQ(made({}).complex.vertex_count(), 0U);
}

Rational doubled_area(const std::vector<Point2>& polygon) {
  Rational area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 p = polygon[i], q = polygon[(i + 1) % polygon.size()];
    area += Rational(p.x) * q.y - Rational(q.x) * p.y;
  }
  return area;
}

// A prism over a polygon keeps its volume, whatever the polygon.
TEST(FromMesh, PolygonsThatAreNotSimpleBecomeTriangles) {
  struct Case {
    const char* name;
    std::vector<Point2> polygon;
    bool is_simple;
  };
  const std::vector<Case> cases = {
      {"L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, true},
      {"flat corners", {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}}, true},
      {"square with a hole on a bridge",
       {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}},
       false},
      {"hole that touches",
       {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 2}, {2, 2}, {2, 1}},
       false},
      {"two squares at a corner",
       {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}},
       false},
      {"bow tie", {{0, 0}, {2, 2}, {2, 0}, {0, 3}}, false},
      {"winds twice", {{0, 0}, {4, 0}, {4, 4}, {1, 1}, {3, 1}, {3, 3}}, false},
  };
  for (const Case& c : cases) {
    const MeshComplex prism = made(prism_mesh(c.polygon, 0, 1));
    EXPECT_EQ(prism.report.not_simple.empty(), c.is_simple) << c.name;
    EXPECT_EQ(enclosed_volume(prism.complex, prism.jump), 3 * doubled_area(c.polygon)) << c.name;
    EXPECT_TRUE(prism.report.is_closed()) << c.name;
  }
}

TEST(FromMesh, SphereOfDoubles) {
  const MeshComplex sphere = made(icosphere_mesh(3, 0.3, {0.1, 0.2, 0.7}));
  EXPECT_EQ(sphere.complex.facet_count(), 1280U);
  EXPECT_EQ(sphere.complex.vertex_count() + 1280, sphere.complex.edge_count() + 2);
  EXPECT_TRUE(sphere.report.inside_out.empty());
}

TEST(FromMesh, FarAndTinyCoordinates) {
  for (const double scale : {1e300, 1e-300, 5e-324}) {
    const MeshComplex cube =
        made(fanned(box_mesh({-scale, -scale, -scale}, {scale, scale, scale})));
    EXPECT_EQ(cube.complex.edge_count(), 18U);
    EXPECT_TRUE(cube.report.inside_out.empty());
    EXPECT_EQ(made(reversed(box_mesh({0, 0, 0}, {scale, scale, scale}))).report.inside_out,
              Faces{0});
  }
}

}  // namespace
}  // namespace plumb::testing::from_mesh_test
