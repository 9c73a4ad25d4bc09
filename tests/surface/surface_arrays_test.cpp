// Surfaces from and to plain arrays.
#include "plumb/surface/surface_arrays.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "divided.h"
#include "generate/counted_memory.h"
#include "plumb/predicates/error.h"
#include "plumb/space/nef3.h"

namespace plumb::testing::surface_arrays_test {
namespace {

using Doubles = std::vector<double>;
using Indices = std::vector<std::uint32_t>;

const Doubles kCorners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const Indices kTriangles = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

Indices indices(std::span<const std::uint32_t> corners) { return {corners.begin(), corners.end()}; }
Doubles doubles(std::span<const double> numbers) { return {numbers.begin(), numbers.end()}; }

ErrorCode code_of(const MeshView& mesh) {
  try {
    surface_of(mesh);
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::CannotOpen;
}

TEST(SurfaceArrays, go_in_and_come_out) {
  std::optional<Doubles> xyz = kCorners;
  std::optional<Indices> corners = kTriangles;
  const SurfaceMesh mesh = surface_of(mesh_of_triangles(*xyz, *corners));
  xyz.reset();
  corners.reset();
  ASSERT_EQ(mesh.face_count(), 4U);
  EXPECT_EQ(mesh.point(VertexId(3)), (Point3{0, 0, 1}));
  EXPECT_EQ(doubles(view_of(mesh).coordinates), kCorners);
  EXPECT_EQ(indices(view_of(mesh).corners), kTriangles);
}

TEST(SurfaceArrays, may_be_polygons_of_three_corners) {
  const Indices begin = {0, 3, 6, 9, 12};
  const SurfaceMesh mesh = surface_of(mesh_of_polygons(kCorners, begin, kTriangles));
  EXPECT_EQ(indices(view_of(mesh).corners), kTriangles);
}

TEST(SurfaceArrays, show_faces_as_they_were_turned) {
  Indices corners = kTriangles;
  std::swap(corners[4], corners[5]);
  const SurfaceMesh mesh = surface_of(mesh_of_triangles(kCorners, corners));
  EXPECT_TRUE(mesh.is_flipped(FaceId(1)));
  EXPECT_EQ(indices(view_of(mesh).corners), kTriangles);
}

TEST(SurfaceArrays, come_out_without_a_copy) {
  const SurfaceMesh mesh = surface_of(mesh_of_triangles(kCorners, kTriangles));
  const std::uint64_t before = counted_memory().bytes;
  const MeshView view = view_of(mesh);
  EXPECT_EQ(counted_memory().bytes, before);
  EXPECT_EQ(static_cast<const void*>(view.coordinates.data()), &mesh.point(VertexId(0)));
  EXPECT_EQ(static_cast<const void*>(view.corners.data()), &mesh.corners(FaceId(0)));
}

TEST(SurfaceArrays, of_nothing_are_nothing) {
  const SurfaceMesh mesh = surface_of(MeshView());
  EXPECT_EQ(mesh.vertex_count(), 0U);
  EXPECT_TRUE(view_of(mesh).coordinates.empty());
  EXPECT_TRUE(view_of(mesh).corners.empty());
  EXPECT_TRUE(view_of(SurfaceTriangulation()).corners.empty());
}

TEST(SurfaceArrays, are_a_solid_that_contains_what_the_surface_bounds) {
  Context context;
  const SurfaceMesh mesh = surface_of(mesh_of_triangles(kCorners, kTriangles));
  const Nef3 solid = Nef3::from_mesh(view_of(mesh), {.rule = WindingRule::Positive}, context);
  EXPECT_TRUE(solid.contains(Point3{0.125, 0.125, 0.125}));
  EXPECT_FALSE(solid.contains(Point3{0.5, 0.5, 0.5}));
}

/// A triangulation cuts faces along polygons: the same solid, in more triangles.
TEST(SurfaceArrays, of_a_divided_surface_bound_the_same_solid) {
  Context context;
  const auto mesh =
      std::make_shared<const SurfaceMesh>(surface_of(mesh_of_triangles(kCorners, kTriangles)));
  SurfacePolygons polygons(*mesh);
  for (const auto& [u, v] : {std::pair(.25, .25), std::pair(.5, .25), std::pair(.25, .5)}) {
    polygons.add_segment(polygons.points.add_in_face(FaceId(0), u, v), FaceId(0),
                         SegmentStart::ControlPoint);
  }
  polygons.close();
  const SurfaceDivision division({mesh, polygons, {}, FaceId(1)}, context);
  const SurfaceTriangulation triangles = triangulate_surface(division, context);
  const MeshView view = view_of(triangles);
  EXPECT_GT(view.face_count(), 4U);
  EXPECT_EQ(Nef3::from_mesh(view, {.rule = WindingRule::Positive}, context),
            Nef3::from_mesh(view_of(*mesh), {.rule = WindingRule::Positive}, context));
}

TEST(SurfaceArrays, refuse_what_is_no_surface) {
  const Indices square = {0, 1, 2, 3}, begin = {0, 4};
  EXPECT_EQ(code_of(mesh_of_polygons(kCorners, begin, square)), ErrorCode::BadArgument);
  const Indices beyond = {0, 1, 4};
  EXPECT_EQ(code_of(mesh_of_triangles(kCorners, beyond)), ErrorCode::BadIndex);
  for (const double value : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    Doubles xyz = kCorners;
    xyz[5] = value;
    EXPECT_EQ(code_of(mesh_of_triangles(xyz, kTriangles)), ErrorCode::NotFinite);
  }
  const Indices twice = {0, 1, 2, 0, 1, 3, 0, 1, 2};
  EXPECT_EQ(code_of(mesh_of_triangles(kCorners, twice)), ErrorCode::BadShape);
}

}  // namespace
}  // namespace plumb::testing::surface_arrays_test
