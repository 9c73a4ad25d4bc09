// Checks generators of the homology of surfaces, the classes of polygons and the loops that repair
// them, against labels of divided surfaces and against boundaries of faces.
#include "plumb/surface/surface_homology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stop_token>
#include <utility>
#include <vector>

#include "generate/surface_scenes.h"
#include "plumb/predicates/error.h"
#include "plumb/surface/surface_audit.h"
#include "plumb/testing/dice.h"

namespace plumb::surface_homology_test {

using testing::chain_of_tori;
using testing::cylinder_mesh;
using testing::Dice;
using testing::grid_mesh;
using testing::MeshPointer;
using testing::sphere_mesh;
using testing::SurfaceDrawing;
using testing::torus_mesh;

/// Returns a generator with a detour around a random vertex of it, over a face that it may or may
/// not run along.
std::vector<std::uint32_t> loop_on(const SurfaceMesh& mesh, Dice& dice, const SurfaceHomology& h) {
  std::vector<std::uint32_t> loop;
  for (const VertexId v : h.generator(dice.below(h.generator_count()))) loop.push_back(v.value());
  const std::size_t at = dice.below(loop.size());
  const HalfedgeId out = mesh.halfedge(VertexId(loop[at]));
  const std::uint32_t detour[] = {mesh.target(out).value(),
                                  mesh.target(SurfaceMesh::next(out)).value(), loop[at]};
  loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(at) + 1, std::begin(detour),
              std::end(detour));
  return loop;
}

TEST(SurfaceHomology, GeneratorsAreTwiceTheGenus) {
  const std::pair<MeshPointer, std::size_t> cases[] = {
      {sphere_mesh(2), 0},         {torus_mesh(7, 5), 2},    {chain_of_tori(2, 6, 4), 4},
      {chain_of_tori(3, 6, 4), 6}, {cylinder_mesh(6, 3), 0}, {grid_mesh(3, 3), 0},
  };
  for (const auto& [mesh, count] : cases) {
    Context context;
    const SurfaceHomology h(*mesh, context);
    ASSERT_EQ(h.generator_count(), count);
    SurfacePolygons polygons(*mesh);
    for (std::size_t i = 0; i < count; ++i) h.add_generator(i, i % 2 == 1, polygons);
    require_valid(polygons);
    for (std::size_t i = 0; i < count; ++i) {
      std::vector<std::int64_t> expected(count);
      expected[i] = i % 2 == 1 ? -1 : 1;
      EXPECT_EQ(h.class_of(polygons, i, context), expected);
    }
  }
}

TEST(SurfaceHomology, RepairedShapesSeparate) {
  const MeshPointer meshes[] = {torus_mesh(7, 5), chain_of_tori(2, 6, 4), chain_of_tori(3, 6, 4)};
  for (std::uint64_t seed = 0; seed < 30 && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    SurfaceDrawing s(meshes[seed % 3]);
    Context context;
    const SurfaceHomology h(*s.scene.mesh, context);
    for (int p = 0; p < 3; ++p) s.add_vertex_polygon(loop_on(*s.scene.mesh, dice, h));
    std::vector<std::uint32_t> shape = {0, 1, 2, 1};
    const std::vector<std::int64_t> before = h.class_of(s.scene.polygons, shape, context);
    s.scene.shapes = {shape};
    {
      const SurfaceDivision d(s.scene, context);
      EXPECT_EQ(audit(d).value_or(""), "");
      const bool is_zero = std::ranges::all_of(before, [](std::int64_t k) { return k == 0; });
      EXPECT_EQ(d.shape_separation(0).over_z, is_zero);
      const bool is_even = std::ranges::all_of(before, [](std::int64_t k) { return k % 2 == 0; });
      EXPECT_EQ(d.shape_separation(0).mod_2, is_even);
    }
    const std::vector<std::uint32_t> added = h.add_repair(shape, s.scene.polygons, context);
    shape.insert(shape.end(), added.begin(), added.end());
    s.scene.shapes = {shape};
    const SurfaceDivision d(s.scene, context);
    EXPECT_TRUE(d.shape_separation(0).over_z);
    EXPECT_EQ(audit(d).value_or(""), "");
  }
}

// However often a shape names a polygon, it is looked at once; and it can be stopped.
TEST(SurfaceHomology, ShapesThatNameOnePolygonOften) {
  SurfaceDrawing s(torus_mesh(7, 5));
  Context context;
  const SurfaceHomology h(*s.scene.mesh, context);
  std::vector<std::uint32_t> loop;
  for (const VertexId v : h.generator(0)) loop.push_back(v.value());
  const std::uint32_t there = loop[0], back = loop[1];
  for (int i = 0; i < 20000; ++i) loop.insert(loop.end(), {there, back});
  s.add_vertex_polygon(loop);
  const std::vector<std::uint32_t> shape(1000000, 0);
  Limits limits;
  limits.max_seconds = 5;
  Context timed(limits);
  std::vector<std::int64_t> expected = h.class_of(s.scene.polygons, 0, context);
  EXPECT_NE(expected, std::vector<std::int64_t>(2));
  for (std::int64_t& k : expected) k *= 1000000;
  EXPECT_EQ(h.class_of(s.scene.polygons, shape, timed), expected);
  std::stop_source stop;
  stop.request_stop();
  Context stopped({}, stop.get_token());
  EXPECT_THROW(h.class_of(s.scene.polygons, shape, stopped), Error);
}

// Paths across faces, not along edges: what separates is what has class zero.
TEST(SurfaceHomology, ClassesOfPathsAcrossFaces) {
  for (std::uint64_t seed = 0; seed < 30 && !::testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    SurfaceDrawing s(chain_of_tori(2, 5, 4));
    const SurfaceMesh& m = *s.scene.mesh;
    FaceId f(dice.below(m.face_count()));
    const FaceId start = f;
    std::vector<SurfacePointId> points;
    for (int step = 0; step < 3000 && (step < 4 || f != start); ++step) {
      const HalfedgeId side = SurfaceMesh::halfedge(f, dice.below(3));
      const Rational t = Rational(dice.between(1, 999)) / 1000;
      points.push_back(s.scene.polygons.points.add_on_edge(m.edge(side), t));
      f = SurfaceMesh::face(m.twin(side));
    }
    if (f != start) continue;
    s.add_polygon(points);
    Context context;
    const SurfaceDivision d(s.scene, context);
    EXPECT_EQ(audit(d).value_or(""), "");
    const SurfaceHomology h(m, context);
    const auto times = h.class_of(s.scene.polygons, 0, context);
    const bool is_zero = std::ranges::all_of(times, [](std::int64_t k) { return k == 0; });
    const bool is_even = std::ranges::all_of(times, [](std::int64_t k) { return k % 2 == 0; });
    EXPECT_EQ(d.polygon_separation(0).over_z, is_zero);
    EXPECT_EQ(d.polygon_separation(0).mod_2, is_even);
  }
}

/// The boundary of a face bounds, whatever the tree and the cotree are.
TEST(SurfaceHomology, BoundariesOfFacesAreZero) {
  const MeshPointer meshes[] = {torus_mesh(4, 3), chain_of_tori(3, 5, 4), cylinder_mesh(5, 2)};
  for (const MeshPointer& mesh : meshes) {
    const SurfaceHomology h(*mesh);
    const std::vector<std::int64_t> zero(h.generator_count());
    SurfacePolygons polygons(*mesh);
    for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
      for (std::size_t i = 0; i < 3; ++i) {
        polygons.add_segment(polygons.points.add_vertex(mesh->corner(FaceId(f), i)), FaceId(f),
                             SegmentStart::ControlPoint);
      }
      polygons.close();
      EXPECT_EQ(h.class_of(polygons, f), zero) << f;
    }
  }
}

/// A torus less one face still has two generators: the hole counts as closed by a disk, and its
/// border bounds.
TEST(SurfaceHomology, HolesAddNoGenerators) {
  const MeshPointer torus = torus_mesh(5, 4);
  std::vector<Point3> points;
  for (std::uint32_t v = 0; v < torus->vertex_count(); ++v)
    points.push_back(torus->point(VertexId(v)));
  std::vector<SurfaceTriangle> triangles;
  for (std::uint32_t f = 1; f < torus->face_count(); ++f)
    triangles.push_back(torus->corners(FaceId(f)));
  const SurfaceMesh open(points, triangles);
  const SurfaceHomology h(open);
  EXPECT_EQ(h.generator_count(), 2U);
  SurfacePolygons polygons(open);
  const SurfaceTriangle& hole = torus->corners(FaceId(0));
  for (std::size_t i = 0; i < 3; ++i) {
    std::uint32_t side = 0;
    while (open.origin(HalfedgeId(side)).value() != hole[(i + 1) % 3] ||
           open.target(HalfedgeId(side)).value() != hole[i]) {
      ++side;
    }
    EXPECT_TRUE(open.is_border(HalfedgeId(side)));
    polygons.add_segment(polygons.points.add_vertex(VertexId(hole[i])),
                         SurfaceMesh::face(HalfedgeId(side)), SegmentStart::ControlPoint);
  }
  polygons.close();
  require_valid(polygons);
  EXPECT_EQ(h.class_of(polygons, 0), std::vector<std::int64_t>(2));
}

}  // namespace plumb::surface_homology_test
