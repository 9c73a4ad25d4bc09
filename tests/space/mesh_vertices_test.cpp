// Meshes in an order of space: the same mesh, and whatever is said of it says the numbers of the
// input.
#include "plumb/space/mesh/mesh_vertices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "generate/meshes.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/nef3.h"

namespace plumb::testing::mesh_vertices_test {
namespace {

using Numbers = std::vector<std::uint32_t>;

Numbers shuffled_numbers(std::size_t n, std::mt19937& random) {
  Numbers numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0U);
  std::ranges::shuffle(numbers, random);
  return numbers;
}

/// Points and faces in any order; each face starts anywhere.
PolygonMesh shuffled(const PolygonMesh& mesh, std::uint32_t seed) {
  std::mt19937 random(seed);
  const Numbers place = shuffled_numbers(mesh.points.size(), random);
  PolygonMesh result;
  result.points.resize(mesh.points.size());
  for (std::size_t i = 0; i < place.size(); ++i) result.points[place[i]] = mesh.points[i];
  for (const std::uint32_t f : shuffled_numbers(mesh.face_count(), random)) {
    Face face(mesh.face(f).begin(), mesh.face(f).end());
    for (std::uint32_t& c : face) c = place[c];
    std::rotate(face.begin(), face.begin() + random() % 3, face.end());
    result.add_face(face);
  }
  return result;
}

/// Every triangle with points of its own, as in STL.
PolygonMesh soup_of(const PolygonMesh& mesh) {
  PolygonMesh soup;
  for (const std::uint32_t c : mesh.corners) {
    soup.corners.push_back(static_cast<std::uint32_t>(soup.points.size()));
    soup.points.push_back(mesh.points[c]);
    if (soup.corners.size() % 3 == 0) {
      soup.face_begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    }
  }
  return soup;
}

/// Closed, of some 7,000 triangles: two spheres that cross each other, one inside out, triangles
/// that are there twice and three times, triangles without area.
PolygonMesh bad_mesh() {
  PolygonMesh mesh = joined(icosphere_mesh(4, 1, {}), icosphere_mesh(3, 0.75, {0.625, 0.25, 0}));
  mesh = joined(std::move(mesh), reversed(icosphere_mesh(2, 0.5, {9, 0, 0})));
  for (std::uint32_t f = 0; f < 4000; f += 500) {
    const Face face(mesh.face(f).begin(), mesh.face(f).end());
    mesh.add_face(face);
    mesh.add_face(Face{face[1], face[0], face[2]});
    mesh.add_face(Face{face[0], face[1], face[1]});
  }
  return mesh;
}

std::array<std::array<double, 3>, 3> corners_of(const MeshView& mesh, std::size_t f) {
  std::array<std::array<double, 3>, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point3 p = mesh.point(mesh.face(f)[i]);
    corners[i] = {p.x, p.y, p.z};
  }
  return corners;
}

/// How far apart in memory the points of a face are from those of the next one.
double mean_step(const MeshView& mesh) {
  double sum = 0;
  for (std::size_t f = 1; f < mesh.face_count(); ++f) {
    sum += std::abs(static_cast<double>(mesh.face(f)[0]) - mesh.face(f - 1)[0]);
  }
  return sum / static_cast<double>(mesh.face_count());
}

void expect_equal_reports(const MeshReport& a, const MeshReport& b) {
  EXPECT_EQ(a.vertices_merged, b.vertices_merged);
  EXPECT_EQ(a.degenerate, b.degenerate);
  EXPECT_EQ(a.trimmed, b.trimmed);
  EXPECT_EQ(a.not_planar, b.not_planar);
  EXPECT_EQ(a.not_simple, b.not_simple);
  EXPECT_EQ(a.doubled, b.doubled);
  EXPECT_EQ(a.borders, b.borders);
  EXPECT_EQ(a.crossing_count, b.crossing_count);
  EXPECT_EQ(a.crossings, b.crossings);
  EXPECT_EQ(a.inside_out, b.inside_out);
}

Numbers sorted(Numbers numbers) {
  std::ranges::sort(numbers);
  return numbers;
}

TEST(MeshOrder, IsTheSameMesh) {
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    PolygonMesh mesh = shuffled(bad_mesh(), seed);
    if (seed % 2 == 1) mesh = soup_of(mesh);
    const MeshView input = mesh;
    const OrderedMesh ordered = ordered_in_space(mesh);
    ASSERT_EQ(ordered.view().face_count(), mesh.face_count());
    ASSERT_EQ(ordered.view().point_count(), mesh.points.size());
    Numbers all(mesh.face_count());
    std::iota(all.begin(), all.end(), 0U);
    EXPECT_EQ(sorted(ordered.face), all);
    for (std::size_t f = 0; f < ordered.face.size(); ++f) {
      ASSERT_EQ(corners_of(ordered.view(), f), corners_of(input, ordered.face[f]));
    }
    const double step_of_any_order = static_cast<double>(mesh.points.size()) / 3;
    EXPECT_LT(mean_step(ordered.view()), 0.1 * step_of_any_order);
  }
}

// Points that come once, six times, in one cell, with zeros of both signs, and without a face.
TEST(MeshOrder, MergesEqualPointsAsAnyMeshDoes) {
  PolygonMesh crowded = soup_of(icosphere_mesh(2, 0x1p-20, {}));  // Far smaller than a cell.
  crowded = joined(std::move(crowded), icosphere_mesh(1, 1, {}));
  PolygonMesh flat = soup_of(icosphere_mesh(2, 1, {}));
  for (std::size_t i = 0; i < flat.points.size(); ++i) flat.points[i].z = i % 2 == 0 ? 0. : -0.;
  PolygonMesh unused = bad_mesh();
  unused.points.insert(unused.points.end(), {{0.5, 0.5, 0.5}, unused.points[7]});
  for (const PolygonMesh& mesh : {bad_mesh(), soup_of(bad_mesh()), crowded, flat, unused}) {
    const PolygonMesh any = shuffled(mesh, 3);
    const OrderedMesh ordered = ordered_in_space(any);
    ASSERT_TRUE(std::ranges::is_sorted(ordered.cell));
    SpaceTables tables_a, tables_b;
    const MeshVertices a = merge_equal_points(ordered, tables_a),
                       b = merge_equal_points(ordered.view(), tables_b);
    EXPECT_EQ(a.of_point, b.of_point);
    EXPECT_EQ(a.input, b.input);
    EXPECT_EQ(a.point, b.point);
    EXPECT_EQ(a.merged, b.merged);
    EXPECT_TRUE(std::ranges::equal(tables_a.planes.points(), tables_b.planes.points()));
  }
}

/// A surface is taken in the order of its file: what it tells is held against.
TEST(MeshOrder, ReportsSayTheNumbersOfTheInput) {
  Context context;
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    PolygonMesh mesh = shuffled(bad_mesh(), seed);
    if (seed % 2 == 1) mesh = soup_of(mesh);
    ASSERT_FALSE(ordered_in_space(mesh).is_empty());
    for (const std::uint64_t most : {1000U, 10U}) {
      const MeshComplex a = complex_of_mesh(mesh, {.surface = false, .max_listed = most}, context);
      const MeshComplex b = complex_of_mesh(mesh, {.surface = true, .max_listed = most}, context);
      expect_equal_reports(a.report, b.report);
      EXPECT_EQ(a.report.doubled.size(), 2 * 8U);
      EXPECT_EQ(a.report.degenerate.size(), 8U);
      EXPECT_EQ(a.report.inside_out.size(), 1U);
      EXPECT_GT(a.report.crossings.size(), 9U);
      EXPECT_NE(a.complex.facet_origin, b.complex.facet_origin);  // in other orders
      EXPECT_EQ(sorted(a.complex.facet_origin), sorted(b.complex.facet_origin));
    }
  }
}

TEST(MeshOrder, MakesTheSameSet) {
  Context context;
  const PolygonMesh mesh = shuffled(bad_mesh(), 5);
  const auto set = [&](bool surface) {
    return Nef3::from_mesh_complex(complex_of_mesh(mesh, {.surface = surface}, context),
                                   WindingRule::NonZero, context);
  };
  const Nef3 a = set(false), b = set(true);
  EXPECT_TRUE(a == b);
  EXPECT_NE(a.complex().facet_origin, b.complex().facet_origin);
  EXPECT_EQ(sorted(a.complex().facet_origin), sorted(b.complex().facet_origin));
}

TEST(MeshOrder, BordersSayTheNumbersOfTheInput) {
  Context context;
  PolygonMesh mesh = shuffled(icosphere_mesh(4, 1, {}), 6);
  const Face gone(mesh.face(5119).begin(), mesh.face(5119).end());
  mesh.corners.resize(mesh.corners.size() - 3);
  mesh.face_begin.pop_back();
  const MeshReport report = complex_of_mesh(mesh, {}, context).report;
  expect_equal_reports(report, complex_of_mesh(mesh, {.surface = true}, context).report);
  ASSERT_EQ(report.borders.size(), 1U);
  EXPECT_EQ(sorted(report.borders[0]), sorted(gone));
}

TEST(MeshOrder, LeavesSomeMeshesAsTheyAre) {
  const PolygonMesh sphere = icosphere_mesh(1, 1, {});
  EXPECT_FALSE(ordered_in_space(sphere).is_empty());
  const PolygonMesh nothing;
  EXPECT_TRUE(ordered_in_space(nothing).is_empty());
  const PolygonMesh squares = box_mesh({0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(ordered_in_space(squares).is_empty());
  PolygonMesh mesh = sphere;
  mesh.face_begin[1] = 4;  // a quadrilateral and two corners
  EXPECT_TRUE(ordered_in_space(mesh).is_empty());
  mesh = sphere;
  mesh.exact = {{3, RationalPoint3{Rational(1) / 3, 0, 0}}};
  EXPECT_TRUE(ordered_in_space(mesh).is_empty());
  mesh = sphere;
  mesh.corners[7] = static_cast<std::uint32_t>(mesh.points.size());
  EXPECT_TRUE(ordered_in_space(mesh).is_empty());
  for (const double x :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    mesh = sphere;
    mesh.points[7].z = x;
    EXPECT_TRUE(ordered_in_space(mesh).is_empty());
  }
  mesh = sphere;
  mesh.points[7].z = 1.5e308;
  EXPECT_FALSE(ordered_in_space(mesh).is_empty());
  mesh.points[8].z = -1.5e308;  // too far apart
  EXPECT_TRUE(ordered_in_space(mesh).is_empty());
}

/// Flat, a point, and smaller than numbers can be: all places may be one.
TEST(MeshOrder, TakesAnyExtent) {
  for (const std::array<double, 3> scale : {std::array{1., 1., 0.},
                                            {0., 0., 0.},
                                            {0x1p-1060, 0x1p-1060, 0x1p-1060},
                                            {-1., 0x1p900, 0.}}) {
    PolygonMesh mesh = icosphere_mesh(2, 1, {});
    for (Point3& p : mesh.points) p = {p.x * scale[0], p.y * scale[1], p.z * scale[2]};
    const OrderedMesh ordered = ordered_in_space(mesh);
    ASSERT_EQ(ordered.face.size(), mesh.face_count());
    for (std::size_t f = 0; f < ordered.face.size(); ++f) {
      ASSERT_EQ(corners_of(ordered.view(), f), corners_of(mesh, ordered.face[f]));
    }
  }
}

}  // namespace
}  // namespace plumb::testing::mesh_vertices_test
