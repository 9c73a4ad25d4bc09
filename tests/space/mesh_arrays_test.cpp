// Plain arrays in and out: read where they lie, nothing copied on the way.
#include "plumb/space/mesh_arrays.h"

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <vector>

#include "generate/counted_memory.h"
#include "plumb/convex/convexity.h"
#include "plumb/predicates/error.h"
#include "plumb/space/nef3.h"
#include "plumb/space/to_mesh.h"

namespace plumb::testing::mesh_arrays_test {
namespace {

using Doubles = std::vector<double>;
using Indices = std::vector<std::uint32_t>;

const Doubles kCorners = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
const Indices kTriangles = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
const Indices kBegin = {0, 3, 6, 9, 12};

Nef3 set_of(const MeshView& mesh) {
  Context context;
  return Nef3::from_mesh(mesh, {.rule = WindingRule::Positive}, context);
}

Nef3 tetrahedron(double shift) {
  Doubles moved = kCorners;
  for (double& x : moved) x += shift;
  return set_of(mesh_of_triangles(moved, kTriangles));
}

/// A strip of squares around an axis, closed by fans: large enough for copies to show in bytes.
struct Drum {
  static constexpr std::uint32_t kSides = 200;
  Doubles coordinates;
  Indices corners;

  Drum() {
    for (std::uint32_t i = 0; i < kSides; ++i) {  // on a parabola, so that it is convex
      const double x = i, y = x * x;
      for (const double z : {0.0, 1.0}) coordinates.insert(coordinates.end(), {x, y, z});
    }
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kSides);
      corners.insert(corners.end(), {a, b, b + 1, a, b + 1, a + 1});
      if (i < 2) continue;
      corners.insert(corners.end(), {0, a, a - 2, 1, a - 1, a + 1});
    }
  }
};

std::uint64_t bytes_asked_for(const std::function<void()>& work) {
  const std::uint64_t before = counted_memory().bytes;
  work();
  return counted_memory().bytes - before;
}

TEST(MeshArrays, are_read_where_they_lie) {
  const MeshView triangles = mesh_of_triangles(kCorners, kTriangles);
  const MeshView polygons = mesh_of_polygons(kCorners, kBegin, kTriangles);
  for (const MeshView& mesh : {triangles, polygons}) {
    EXPECT_EQ(mesh.coordinates.data(), kCorners.data());
    EXPECT_EQ(mesh.corners.data(), kTriangles.data());
    EXPECT_EQ(mesh.point_count(), 4U);
    ASSERT_EQ(mesh.face_count(), 4U);
    for (std::uint32_t f = 0; f < 4; ++f) {
      EXPECT_EQ(mesh.begin_of(f), 3 * f);
      EXPECT_EQ(mesh.face(f).data(), kTriangles.data() + std::size_t{3} * f);
      EXPECT_EQ(mesh.face(f).size(), 3U);
    }
    EXPECT_EQ(mesh.point(3), (Point3{0, 0, 1}));
  }
  EXPECT_EQ(polygons.face_begin.data(), kBegin.data());
  EXPECT_EQ(mesh_of_polygons({}, Indices{0}, {}).face_count(), 0U);
  EXPECT_EQ(mesh_of_triangles({}, {}).face_count(), 0U);
  EXPECT_TRUE(set_of(MeshView()).is_empty());
  const PolygonMesh nothing;
  EXPECT_TRUE(set_of(nothing).is_empty());
}

TEST(MeshArrays, cost_no_memory) {
  const Drum drum;
  PolygonMesh mesh;
  for (std::size_t i = 0; i < drum.coordinates.size(); i += 3) {
    mesh.points.push_back({drum.coordinates[i], drum.coordinates[i + 1], drum.coordinates[i + 2]});
  }
  for (std::size_t i = 0; i < drum.corners.size(); i += 3) {
    mesh.add_face(std::span(drum.corners).subspan(i, 3));
  }
  std::optional<MeshView> view;
  EXPECT_EQ(bytes_asked_for([&] { view = mesh_of_triangles(drum.coordinates, drum.corners); }), 0U);
  EXPECT_EQ(
      bytes_asked_for([&] { mesh_of_polygons(drum.coordinates, mesh.face_begin, drum.corners); }),
      0U);
  EXPECT_EQ(
      bytes_asked_for([&] { EXPECT_EQ(coordinates_of(mesh).size(), drum.coordinates.size()); }),
      0U);

  Nef3 of_arrays, of_mesh;
  const std::uint64_t arrays = bytes_asked_for([&] { of_arrays = set_of(*view); });
  const std::uint64_t whole = bytes_asked_for([&] { of_mesh = set_of(mesh); });
  EXPECT_EQ(arrays, whole) << "nothing is copied of arrays that is not of a mesh";
  EXPECT_EQ(of_arrays, of_mesh);

  bool is_convex = false;
  Context context;
  const std::uint64_t asked = bytes_asked_for([&] { is_convex = is_convex_mesh(*view, context); });
  EXPECT_TRUE(is_convex);
  EXPECT_EQ(asked, bytes_asked_for([&] { EXPECT_TRUE(is_convex_mesh(mesh, context)); }));
}

TEST(MeshArrays, may_go_when_the_set_is_there) {
  std::optional<Drum> drum(std::in_place);
  const Nef3 set = set_of(mesh_of_triangles(drum->coordinates, drum->corners));
  const Nef3 twin = set_of(mesh_of_triangles(drum->coordinates, drum->corners));
  drum->coordinates.assign(drum->coordinates.size(), 0);
  drum.reset();
  EXPECT_EQ(set, twin);
  EXPECT_TRUE(set.contains(Point3{100, 15000, 0.5}));
}

/// A small part of a large buffer of points: what it takes for points of nobody is 4 bytes each,
/// within the limits.
TEST(MeshArrays, may_name_few_of_many_points) {
  Doubles many = kCorners;
  many.resize(3'000'000, 0.5);
  const MeshView mesh = mesh_of_triangles(many, kTriangles);
  Limits limits;
  limits.max_memory_bytes = 4'500'000;
  Context enough(limits);
  Nef3 set;
  const std::uint64_t bytes = bytes_asked_for(
      [&] { set = Nef3::from_mesh(mesh, {.rule = WindingRule::Positive}, enough); });
  EXPECT_LT(bytes, limits.max_memory_bytes);
  EXPECT_EQ(set, tetrahedron(0));
  limits.max_memory_bytes = 3'500'000;
  Context little(limits);
  try {
    static_cast<void>(Nef3::from_mesh(mesh, {.rule = WindingRule::Positive}, little));
    FAIL() << "a million points are not charged";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
  }
}

TEST(MeshArrays, go_through_a_boolean_and_come_back) {
  Context context;
  const Nef3 both = tetrahedron(0) + tetrahedron(.25);
  const PolygonMesh mesh =
      mesh_of_complex(both.complex(), {.faces = MeshFaces::Triangles, .keeps_exact = true}, context)
          .mesh;
  ASSERT_TRUE(mesh.exact.empty()) << "its corners are multiples of 1/4";
  EXPECT_EQ(static_cast<const void*>(coordinates_of(mesh).data()), mesh.points.data());
  EXPECT_EQ(set_of(mesh_of_triangles(coordinates_of(mesh), mesh.corners)), both);
  EXPECT_EQ(set_of(mesh_of_polygons(coordinates_of(mesh), mesh.face_begin, mesh.corners)), both);
}

TEST(MeshArrays, keep_exact_points_of_a_mesh) {
  PolygonMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.333}};
  mesh.exact = {{3, {0, 0, Rational(1) / 3}}};
  for (std::size_t f = 0; f < 4; ++f) mesh.add_face(std::span(kTriangles).subspan(3 * f, 3));
  const Nef3 set = set_of(mesh);
  EXPECT_TRUE(set.contains(RationalPoint3{0, 0, Rational(1) / 3}));
  EXPECT_FALSE(set.contains(RationalPoint3{0, 0, Rational(1) / 3 + Rational(1) / 1000000}));
}

TEST(MeshArrays, refuse_sizes_that_do_not_agree) {
  const auto code = [](const std::function<void()>& make) {
    try {
      make();
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::CannotOpen;
  };
  const Doubles four(4);
  const std::vector<Indices> begins = {{}, {1, 12}, {0, 11}, {0, 13}, {0, 9, 6, 12}};
  EXPECT_EQ(code([&] { mesh_of_triangles(four, {}); }), ErrorCode::BadArgument);
  const Indices two_and_a_third = {0, 1, 2, 3};
  EXPECT_EQ(code([&] { mesh_of_triangles(kCorners, two_and_a_third); }), ErrorCode::BadArgument);
  for (const Indices& begin : begins) {
    EXPECT_EQ(code([&] { mesh_of_polygons(kCorners, begin, kTriangles); }), ErrorCode::BadArgument);
  }
  const Indices beyond = {0, 2, 1, 0, 1, 4, 0, 4, 2, 1, 2, 4};
  EXPECT_EQ(code([&] { set_of(mesh_of_triangles(kCorners, beyond)); }), ErrorCode::BadIndex);
}

}  // namespace
}  // namespace plumb::testing::mesh_arrays_test
