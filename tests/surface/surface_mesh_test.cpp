// Checks the links of triangle meshes against pairs of vertices, searches and the definition of a
// manifold.
#include "plumb/surface/surface_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "generate/surface_scenes.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/dice.h"

namespace plumb::surface_mesh_test {

using testing::Dice;
using testing::MeshPointer;
using testing::sphere_mesh;

std::vector<MeshPointer> meshes() {
  const std::vector<MeshPointer> parts{testing::grid_mesh(1, 2, 3), testing::torus_mesh(4, 3),
                                       testing::cylinder_mesh(5, 2)};
  return {testing::grid_mesh(1, 1), testing::grid_mesh(4, 3, 7), testing::cube_mesh(),
          testing::joined_meshes(parts)};
}

TEST(SurfaceMesh, RefusesWhatIsNoOrientableManifold) {
  const std::vector<Point3> points(12);
  using Triangles = std::vector<SurfaceTriangle>;
  const auto refusal = [&](const Triangles& triangles) {
    try {
      SurfaceMesh(points, triangles);
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal({{0, 1, 2}, {1, 0, 3}}), "");
  EXPECT_NE(refusal({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}).find("edge 0-1 (faces 0 1 2)"),
            std::string::npos);
  EXPECT_NE(refusal({{0, 1, 2}, {0, 3, 4}}).find("vertex 0"), std::string::npos);
  EXPECT_NE(refusal({{0, 1, 12}}).find("face 0: no vertex 12"), std::string::npos);
  EXPECT_NE(refusal({{0, 1, 1}}).find("face 0: a repeated vertex"), std::string::npos);
  // A strip of five triangles, joined with half a turn.
  EXPECT_NE(refusal({{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}).find("not orientable"),
            std::string::npos);
}

TEST(SurfaceMesh, TurnsFacesToAgree) {
  const MeshPointer plain = sphere_mesh(3);
  std::vector<Point3> points;
  std::vector<SurfaceTriangle> triangles;
  for (std::uint32_t v = 0; v < plain->vertex_count(); ++v)
    points.push_back(plain->point(VertexId(v)));
  for (std::uint32_t f = 0; f < plain->face_count(); ++f) {
    SurfaceTriangle t = plain->corners(FaceId(f));
    if (f > 0 && f % 3 == 1) std::swap(t[1], t[2]);
    triangles.push_back(t);
  }
  const SurfaceMesh mesh(points, triangles);
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    EXPECT_EQ(mesh.corners(FaceId(f)), plain->corners(FaceId(f)));
    EXPECT_EQ(mesh.is_flipped(FaceId(f)), f > 0 && f % 3 == 1);
  }
  for (std::uint32_t h = 0; h < 3 * mesh.face_count(); ++h) {
    const HalfedgeId t = mesh.twin(HalfedgeId(h));
    EXPECT_EQ(mesh.twin(t), HalfedgeId(h));
    EXPECT_EQ(mesh.origin(t), mesh.target(HalfedgeId(h)));
    EXPECT_EQ(mesh.edge(t), mesh.edge(HalfedgeId(h)));
  }
}

TEST(SurfaceMesh, EdgesArePairsOfVertices) {
  for (const MeshPointer& mesh : meshes()) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<HalfedgeId>> sides;
    for (std::size_t i = 0; i < 3 * mesh->face_count(); ++i) {
      const HalfedgeId h(i);
      const std::uint32_t a = mesh->origin(h).value(), b = mesh->target(h).value();
      EXPECT_EQ(mesh->is_upward(h), a < b);
      sides[std::minmax(a, b)].push_back(h);
    }
    ASSERT_EQ(mesh->edge_count(), sides.size());
    std::set<EdgeId> seen;
    for (const auto& [ends, halfedges] : sides) {
      const EdgeId e = mesh->edge(halfedges[0]);
      EXPECT_TRUE(seen.insert(e).second);
      EXPECT_EQ(mesh->lower(e).value(), ends.first);
      EXPECT_EQ(mesh->upper(e).value(), ends.second);
      EXPECT_EQ(mesh->halfedge(e), halfedges[0]);  // that of the lower face
      ASSERT_LE(halfedges.size(), 2U);
      for (const HalfedgeId h : halfedges) {
        EXPECT_EQ(mesh->edge(h), e);
        EXPECT_EQ(mesh->is_border(h), halfedges.size() == 1);
        if (halfedges.size() == 1) continue;
        EXPECT_EQ(mesh->twin(h), h == halfedges[0] ? halfedges[1] : halfedges[0]);
        EXPECT_EQ(mesh->origin(mesh->twin(h)), mesh->target(h));
      }
    }
  }
}

/// From halfedge(v), turning counter-clockwise visits all half-edges that start in v.
TEST(SurfaceMesh, FansVisitAllHalfEdgesOfAVertex) {
  for (const MeshPointer& mesh : meshes()) {
    std::vector<std::set<HalfedgeId>> leaving(mesh->vertex_count());
    for (std::size_t i = 0; i < 3 * mesh->face_count(); ++i) {
      leaving[mesh->origin(HalfedgeId(i)).value()].insert(HalfedgeId(i));
    }
    for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      std::set<HalfedgeId> visited;
      HalfedgeId h = mesh->halfedge(VertexId(v));
      while (h.is_valid() && visited.insert(h).second) h = mesh->twin(SurfaceMesh::prev(h));
      EXPECT_EQ(visited, leaving[v]);
    }
  }
  const SurfaceMesh lonely({{}, {}, {}, {}}, {{3, 1, 0}});
  EXPECT_FALSE(lonely.halfedge(VertexId(2)).is_valid());
}

/// Faces in any order, each turned at random: a component is oriented like most of its faces, or
/// like its lowest face if there is no majority.
TEST(SurfaceMesh, ComponentsAreOrientedLikeMostOfTheirFaces) {
  Dice dice(1);
  for (const MeshPointer& mesh : meshes()) {
    std::vector<Point3> points;
    for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      points.push_back(mesh->point(VertexId(v)));
    }
    std::vector<FaceId> from;
    for (std::uint32_t f = 0; f < mesh->face_count(); ++f) from.emplace_back(f);
    for (std::size_t i = from.size(); i > 1; --i) std::swap(from[i - 1], from[dice.below(i)]);
    std::vector<SurfaceTriangle> triangles;
    std::vector<std::uint8_t> turned;
    for (const FaceId f : from) {
      triangles.push_back(mesh->corners(f));
      turned.push_back(dice.below(2) == 0 ? 1 : 0);
      if (turned.back() != 0) std::swap(triangles.back()[1], triangles.back()[2]);
    }
    const SurfaceMesh made(points, triangles);
    ASSERT_EQ(made.component_count(), mesh->component_count());
    std::map<std::uint32_t, std::int64_t> majority;  // of the component before: faces kept - turned
    for (std::size_t f = 0; f < from.size(); ++f) {
      majority[mesh->component(from[f])] += turned[f] == 0 ? 1 : -1;
    }
    std::map<std::uint32_t, std::uint32_t> lowest;  // of the component before: its lowest face now
    for (std::uint32_t f = 0; f < made.face_count(); ++f) {
      const auto count = static_cast<std::uint32_t>(lowest.size());
      const auto [at, is_new] = lowest.try_emplace(mesh->component(from[f]), f);
      if (is_new) {
        EXPECT_EQ(made.component(FaceId(f)), count);
      }
      EXPECT_EQ(made.component(FaceId(f)), made.component(FaceId(at->second)));
      const std::int64_t most = majority[mesh->component(from[f])];
      const bool is_turned =
          most == 0 ? turned[f] != turned[at->second] : (turned[f] != 0) == (most > 0);
      EXPECT_EQ(made.is_flipped(FaceId(f)), is_turned);
      SurfaceTriangle corners = triangles[f];
      if (made.is_flipped(FaceId(f))) std::swap(corners[1], corners[2]);
      EXPECT_EQ(made.corners(FaceId(f)), corners);
    }
  }
}

/// A closed mesh with one face turned: this face is turned back, even if it is the first one.
TEST(SurfaceMesh, TheFewerFacesAreTurned) {
  const MeshPointer plain = sphere_mesh(3);
  for (const std::uint32_t turned : {0U, 5U}) {
    std::vector<Point3> points;
    std::vector<SurfaceTriangle> triangles;
    for (std::uint32_t v = 0; v < plain->vertex_count(); ++v) {
      points.push_back(plain->point(VertexId(v)));
    }
    for (std::uint32_t f = 0; f < plain->face_count(); ++f) {
      triangles.push_back(plain->corners(FaceId(f)));
    }
    std::swap(triangles[turned][1], triangles[turned][2]);
    const SurfaceMesh mesh(points, triangles);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      EXPECT_EQ(mesh.is_flipped(FaceId(f)), f == turned);
    }
  }
}

TEST(SurfaceMesh, ValuesOfEntriesHaveRepresentableNegatives) {
  constexpr std::int64_t kMost = 0x7fffffff;
  for (const std::int64_t sum : {-kMost, std::int64_t{-1}, std::int64_t{0}, kMost}) {
    EXPECT_EQ(entry_value(sum), sum);
  }
  EXPECT_THROW(entry_value(kMost + 1), Error);
  EXPECT_THROW(entry_value(-kMost - 1), Error);
}

}  // namespace plumb::surface_mesh_test
