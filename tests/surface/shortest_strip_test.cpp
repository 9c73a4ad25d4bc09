// Checks shortest paths on small meshes against a search over all strips of different faces. A
// shortest path meets each face at most once, so the shortest path is the shortest of the shortest
// paths in these strips.
#include "plumb/surface/strip/shortest_strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "generate/surface_scenes.h"
#include "plumb/base/context.h"
#include "plumb/predicates/error.h"
#include "plumb/surface/strip/unfolded_strip.h"
#include "plumb/surface/trace.h"
#include "plumb/testing/dice.h"

namespace plumb::shortest_strip_test {
namespace {

using testing::Dice;
using testing::MeshPointer;

/// Tries all strips of different faces between two points.
class AllStrips {
 public:
  AllStrips(const SurfacePointTable& points, SurfacePointId a, SurfacePointId b)
      : mesh_(points.mesh()), scaled_(scaled_positions(mesh_)), seen_(mesh_.face_count()) {
    from_ = end_at(points, a);
    to_ = end_at(points, b);
    for (const FaceId f : faces_at(points, a)) {
      strip_ = {f, {}};
      visit(f);
    }
  }
  double shortest() const { return std::ldexp(shortest_, scaled_.exponent); }

 private:
  StripEnd end_at(const SurfacePointTable& points, SurfacePointId p) const {
    const FaceId f = faces_at(points, p).front();
    const std::array<double, 3> w = weights_in(points, p, f);
    Point3 at;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& c = scaled_.at[mesh_.corner(f, k).value()];
      at = {at.x + w[k] * c.x, at.y + w[k] * c.y, at.z + w[k] * c.z};
    }
    return {&points, p, at};
  }
  void visit(FaceId f) {
    seen_[f] = 1;
    if (to_.lies_in(f)) {
      const UnfoldedStrip unfolded(mesh_, scaled_.at, strip_, from_, to_);
      shortest_ = std::min(shortest_, unfolded.path_length());
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const HalfedgeId door = SurfaceMesh::halfedge(f, k), twin = mesh_.twin(door);
      if (!twin.is_valid() || seen_[SurfaceMesh::face(twin)] != 0) continue;
      strip_.doors.push_back(door);
      visit(SurfaceMesh::face(twin));
      strip_.doors.pop_back();
    }
    seen_[f] = 0;
  }

  const SurfaceMesh& mesh_;
  ScaledPositions scaled_;
  IdVector<FaceId, std::uint8_t> seen_;
  StripEnd from_{}, to_{};
  FaceStrip strip_;
  double shortest_ = std::numeric_limits<double>::infinity();
};

SurfacePointId some_point(Dice& dice, SurfacePointTable& points) {
  const SurfaceMesh& mesh = points.mesh();
  const std::uint32_t kind = dice.below(3);
  if (kind == 0) return points.add_vertex(VertexId(dice.below(mesh.vertex_count())));
  const FaceId f(dice.below(mesh.face_count()));
  const auto u = static_cast<double>(dice.between(0, 16)) / 16;
  const double v = kind == 1 ? 0 : std::floor((1 - u) * 8) / 16;
  return points.add_in_face(f, u, v);
}

/// A box of 12 triangles.
MeshPointer box(double x, double y, double z) {
  std::vector<Point3> points;
  for (int i = 0; i < 8; ++i) {
    points.push_back({(i & 1) != 0 ? x : 0, (i & 2) != 0 ? y : 0, (i & 4) != 0 ? z : 0});
  }
  return std::make_shared<SurfaceMesh>(points, std::vector<SurfaceTriangle>{{0, 2, 1},
                                                                            {1, 2, 3},
                                                                            {4, 5, 6},
                                                                            {5, 7, 6},
                                                                            {0, 1, 4},
                                                                            {1, 5, 4},
                                                                            {2, 6, 3},
                                                                            {3, 6, 7},
                                                                            {0, 4, 2},
                                                                            {2, 4, 6},
                                                                            {1, 3, 5},
                                                                            {3, 7, 5}});
}

/// A box with random integer corners, so that it is bent and has vertices of both kinds.
MeshPointer bent_box(Dice& dice) {
  const MeshPointer flat = box(4, 4, 4);
  std::vector<Point3> points;
  std::vector<SurfaceTriangle> triangles;
  for (std::uint32_t v = 0; v < flat->vertex_count(); ++v) {
    const auto some = [&] { return static_cast<double>(dice.between(-3, 3)); };
    const Point3& p = flat->point(VertexId(v));
    points.push_back({p.x + some(), p.y + some(), p.z + some() / 2});
  }
  for (std::uint32_t f = 0; f < flat->face_count(); ++f) {
    triangles.push_back(flat->corners(FaceId(f)));
  }
  return std::make_shared<SurfaceMesh>(points, triangles);
}

/// Returns how often the locally shortest path was longer than the shortest path.
int expect_shortest(const MeshPointer& mesh, Dice& dice, int pairs) {
  Tracer local(*mesh), shortest(*mesh, PathChoice::Shortest);
  SurfacePointTable points(*mesh);
  int longer = 0;
  for (int i = 0; i < pairs; ++i) {
    const SurfacePointId a = some_point(dice, points), b = some_point(dice, points);
    if (points.is_same(a, b)) continue;
    const auto path = shortest.trace(points, a, b), back = shortest.trace(points, b, a);
    const auto quick = local.trace(points, a, b);
    if (!path || !back || !quick) {
      ADD_FAILURE() << "no path";
      continue;
    }
    const double expected = AllStrips(points, a, b).shortest();
    const double found = path_length(points, *path);
    EXPECT_NEAR(found, expected, 1e-9 * expected);
    EXPECT_NEAR(path_length(points, *back), found, 1e-14 * found);
    if (path_length(points, *quick) > expected * (1 + 1e-9)) ++longer;
    for (std::size_t k = 0; k < path->faces.size(); ++k) {
      EXPECT_TRUE(points.is_in(path->points[k], path->faces[k]));
      EXPECT_TRUE(points.is_in(path->points[k + 1], path->faces[k]));
    }
  }
  return longer;
}

TEST(ShortestStrip, IsShortestOfAllStripsOfABox) {
  Dice dice(1);
  EXPECT_GT(expect_shortest(box(30, 12, 12), dice, 200), 10);
}

TEST(ShortestStrip, IsShortestOfAllStripsOfBentBoxes) {
  Dice dice(2);
  int longer = 0;
  for (int i = 0; i < 60; ++i) longer += expect_shortest(bent_box(dice), dice, 6);
  EXPECT_GT(longer, 10);
}

TEST(ShortestStrip, IsShortestOfAllStripsOfSmallMeshes) {
  Dice dice(3);
  for (const MeshPointer& mesh :
       {testing::grid_mesh(3, 2, 5), testing::torus_mesh(3, 3), testing::cylinder_mesh(4, 2)}) {
    expect_shortest(mesh, dice, 30);
  }
}

// H. E. Dudeney's puzzle: in a room of 30 by 12 by 12 feet, the spider sits one foot below the
// ceiling, the fly one foot above the floor opposite. Five of six walls unfold to a way of 40 feet.
TEST(ShortestStrip, SolvesTheSpiderAndTheFly) {
  const MeshPointer room = box(30, 12, 12);
  SurfacePointTable points(*room);
  // The end at x = 0 is faces 8 and 9, the end at x = 30 faces 10 and 11.
  const auto on_wall = [&](std::array<std::uint32_t, 2> faces, double y, double z) {
    for (const std::uint32_t f : faces) {
      const FaceId face(f);
      const Point3 &o = room->point(room->corner(face, 0)), &p = room->point(room->corner(face, 1)),
                   &q = room->point(room->corner(face, 2));
      const double along = (p.y - o.y) * (q.z - o.z) - (p.z - o.z) * (q.y - o.y);
      const double u = ((y - o.y) * (q.z - o.z) - (z - o.z) * (q.y - o.y)) / along;
      const double v = ((p.y - o.y) * (z - o.z) - (p.z - o.z) * (y - o.y)) / along;
      if (u >= 0 && v >= 0 && u + v <= 1) return points.add_in_face(face, u, v);
    }
    throw BrokenInvariant("the point is not on the wall");
  };
  const SurfacePointId spider = on_wall({8, 9}, 6, 11), fly = on_wall({10, 11}, 6, 1);
  Tracer local(*room), shortest(*room, PathChoice::Shortest);
  EXPECT_NEAR(path_length(points, *shortest.trace(points, spider, fly)), 40, 1e-12);
  EXPECT_GT(path_length(points, *local.trace(points, spider, fly)), 40.1);
}

TEST(ShortestStrip, SearchesWithinLimits) {
  const MeshPointer torus = testing::torus_mesh(60, 40);
  SurfacePointTable points(*torus);
  const SurfacePointId a = points.add_vertex(VertexId(0)), b = points.add_vertex(VertexId(1230));
  Tracer shortest(*torus, PathChoice::Shortest);
  ASSERT_TRUE(shortest.trace(points, a, b).has_value());
  Limits limits;
  limits.max_memory_bytes = 1000;
  Context context(limits);
  EXPECT_THROW(static_cast<void>(shortest.trace(points, a, b, context)), Error);
}

}  // namespace
}  // namespace plumb::shortest_strip_test
