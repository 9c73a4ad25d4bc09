// Borders of meshes held against sums of directed edges, components and their volumes against boxes
// that are in or inside out, and fans against what is around a vertex.
#include "plumb/space/mesh/mesh_topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/dice.h"

namespace plumb::mesh_topology_test {

using testing::Dice;
using testing::Face;
using testing::make_mesh;

struct Linked {
  std::shared_ptr<SpaceTables> tables = std::make_shared<SpaceTables>();
  MeshVertices vertices;
  MeshFacets facets;
  MeshLinks links;

  explicit Linked(const PolygonMesh& mesh) {
    Context context;
    MeshReport report;
    vertices = merge_equal_points(mesh, *tables);
    facets = flatten_mesh(mesh, vertices, *tables, report, context);
    links = link_corners(facets, vertices.point.size());
  }
  std::vector<std::vector<std::uint32_t>> borders() const {
    return trace_borders(facets, links, vertices.point, tables->points, unlimited_context());
  }
  SpaceComplex complex() const { return link_facets(facets, links, vertices.point, tables); }
  MeshComponents components() const { return find_components(complex(), facets.jump); }
};

using Chain = std::map<std::array<std::uint32_t, 2>, std::int64_t>;

template <class Corners>
void add_boundary(Chain& chain, const Corners& corners, std::int64_t times) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t from = corners[i], to = corners[(i + 1) % corners.size()];
    chain[{std::min(from, to), std::max(from, to)}] += from < to ? times : -times;
  }
}

// Voxels without some of their squares, some turned over: many borders pass one vertex.
TEST(MeshTopology, BordersBalanceEveryEdge) {
  Dice dice(81);
  for (int round = 0; round < 30; ++round) {
    Linked mesh(testing::voxel_mesh(testing::random_voxels(dice, {3, 3, 2}, 5)));
    EXPECT_TRUE(mesh.borders().empty());
    for (std::int32_t& jump : mesh.facets.jump) {
      if (dice.below(4) == 0) jump = static_cast<std::int32_t>(dice.between(-1, 2));
    }
    Chain chain;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
      add_boundary(chain, mesh.facets.corners(f), -mesh.facets.jump[f]);
    }
    std::int64_t surplus = 0, length = 0;
    for (const auto& [edge, times] : chain) surplus += std::abs(times);
    for (const std::vector<std::uint32_t>& border : mesh.borders()) {
      EXPECT_EQ(std::set(border.begin(), border.end()).size(), border.size());
      add_boundary(chain, border, 1);
      length += static_cast<std::int64_t>(border.size());
    }
    for (const auto& [edge, times] : chain) EXPECT_EQ(times, 0);
    EXPECT_EQ(length, surplus);
  }
}

// A box one side of which has a corner in the middle of an edge: it is places that count.
TEST(MeshTopology, VerticesOnAnEdgeDoNotOpenIt) {
  const std::vector<Point3> points{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2},
                                   {2, 0, 2}, {2, 2, 2}, {0, 2, 2}, {1, 0, 0}};
  std::vector<Face> faces{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 8, 1, 5, 4},
                          {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  EXPECT_TRUE(Linked(make_mesh(points, faces)).borders().empty());
  faces.erase(faces.begin());
  const auto borders = Linked(make_mesh(points, faces)).borders();
  ASSERT_EQ(borders.size(), 1U);
  EXPECT_EQ(borders[0].size(), 5U);
}

// Boxes at places of a checkerboard, which meet in edges and corners; each in or inside out.
/// The vertices inside an edge, by one look at each end of an edge. Coordinates are integers below
/// 1024 in absolute value, so that doubles are exact.
std::vector<std::uint32_t> inner_vertices(const std::vector<Point3>& points,
                                          const std::set<std::uint32_t>& ends, const Point3& from,
                                          const Point3& to) {
  const Point3 d{to.x - from.x, to.y - from.y, to.z - from.z};
  std::map<double, std::uint32_t> at;  // By the scalar product with the edge.
  for (const std::uint32_t v : ends) {
    const Point3 e{points[v].x - from.x, points[v].y - from.y, points[v].z - from.z};
    const bool is_on_line =
        d.x * e.y == d.y * e.x && d.y * e.z == d.z * e.y && d.z * e.x == d.x * e.z;
    const double along = d.x * e.x + d.y * e.y + d.z * e.z;
    if (is_on_line && along > 0 && along < d.x * d.x + d.y * d.y + d.z * d.z) at[along] = v;
  }
  std::vector<std::uint32_t> result;
  for (const auto& [along, v] : at) result.push_back(v);
  return result;
}

// Edges between random points of a small lattice, which often have others inside. A factor makes
// coordinates so large that the difference of two is not a double any more.
TEST(MeshTopology, VerticesInsideEdgesAreThoseOfABruteForceSearch) {
  Dice dice(57);
  std::size_t found = 0;
  for (int round = 0; round < 200; ++round) {
    const int most = round % 2 == 0 ? 3 : 40;
    const double factor = std::array{1.0, most == 3 ? 0x1p1022 : 0x1p1018,
                                     0x1p-1060}[static_cast<std::size_t>(round % 3)];
    std::vector<Point3> points, scaled;
    for (int i = 0; i < 60; ++i) {
      const auto draw = [&] { return static_cast<double>(dice.between(-most, most)); };
      const Point3 p{draw(), draw(), draw()};
      if (std::ranges::find(points, p) == points.end()) points.push_back(p);
    }
    std::vector<std::uint32_t> corners;
    for (const Point3& p : points) scaled.push_back({p.x * factor, p.y * factor, p.z * factor});
    for (std::uint32_t i = 0; i < points.size(); ++i) corners.push_back(i);
    SpaceTables tables;
    const PolygonMesh mesh = make_mesh(scaled, {Face(corners.begin(), corners.end())});
    const MeshVertices vertices = merge_equal_points(mesh, tables);
    std::vector<std::array<std::uint32_t, 2>> edges;
    std::set<std::uint32_t> ends;
    for (int i = 0; i < 40; ++i) {
      const auto pick = [&] { return static_cast<std::uint32_t>(dice.below(points.size())); };
      const std::array<std::uint32_t, 2> edge{pick(), pick()};
      if (edge[0] == edge[1]) continue;
      edges.push_back(edge);
      ends.insert(edge.begin(), edge.end());
    }
    MemoryCharge memory(unlimited_context());
    const InnerVertices inner =
        vertices_inside(edges, vertices.point, tables.points, memory, unlimited_context());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const std::vector<std::uint32_t> expected =
          inner_vertices(points, ends, points[edges[i][0]], points[edges[i][1]]);
      EXPECT_TRUE(std::ranges::equal(inner.of(i), expected)) << "round " << round << ", edge " << i;
      found += expected.size();
    }
  }
  EXPECT_GT(found, 100U);
}

// Edges all along one line, each with all the others' ends inside: the list of vertices is larger
// than the limit, and that is told before it is made.
TEST(MeshTopology, VerticesInsideEdgesAreCharged) {
  std::vector<Point3> points;
  std::vector<std::array<std::uint32_t, 2>> edges;
  Face face;
  for (std::uint32_t i = 0; i < 4000; ++i) {
    points.push_back({i < 2000 ? i - 4000.0 : i + 0.0, 0, 0});
    face.push_back(i);
  }
  for (std::uint32_t i = 0; i < 2000; ++i) edges.push_back({i, 3999 - i});
  SpaceTables tables;
  const PolygonMesh mesh = make_mesh(points, {face});
  const MeshVertices vertices = merge_equal_points(mesh, tables);
  Limits limits;
  limits.max_memory_bytes = 4 << 20;
  Context context(limits);
  MemoryCharge memory(context);
  EXPECT_THROW(
      static_cast<void>(vertices_inside(edges, vertices.point, tables.points, memory, context)),
      Error);
}

TEST(MeshTopology, ComponentsAreBoxesAndHaveTheirSigns) {
  Dice dice(82);
  for (int round = 0; round < 20; ++round) {
    PolygonMesh mesh;
    std::vector<Sign> expected;
    for (int cell = 0; cell < 18; ++cell) {
      const int x = cell % 3, y = cell / 3 % 3, z = cell / 9;
      if ((x + y + z) % 2 != 0 || dice.below(3) == 0) continue;
      const double scale = round % 2 == 0 ? 1 : 0x1p-30, far = round % 3 == 0 ? 1 : 0;
      const auto at = [&](int i) { return far + scale * i; };
      const PolygonMesh box =
          testing::box_mesh({at(x), at(y), at(z)}, {at(x + 1), at(y + 1), at(z + 1)});
      const bool is_in = dice.below(2) == 0;
      mesh = testing::joined(mesh, is_in ? testing::reversed(box) : box);
      expected.push_back(is_in ? Sign::Negative : Sign::Positive);
    }
    if (expected.empty()) continue;
    const MeshComponents found = Linked(mesh).components();
    EXPECT_EQ(found.volume, expected);
    for (std::size_t f = 0; f < found.of_facet.size(); ++f) EXPECT_EQ(found.of_facet[f], f / 6);
  }
}

// A fan is one ring of facets: no vertex of a border, and none where solids touch. Voxels are
// turned so that an axis runs into most of their corners.
TEST(MeshTopology, FansAreRingsOfFacets) {
  Dice dice(83);
  int fans = 0, others = 0;
  for (int round = 0; round < 20; ++round) {
    PolygonMesh mesh = testing::voxel_mesh(testing::random_voxels(dice, {3, 3, 3}, 4));
    for (Point3& p : mesh.points) p = {-p.y - p.z, p.z - p.x, p.y - p.x};
    const SpaceComplex c = Linked(mesh).complex();
    const std::vector<std::uint8_t> has_fan = find_fans(c);
    ASSERT_EQ(has_fan.size(), c.vertex_count());
    for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
      const auto star = c.star_of(VertexId(v));
      std::size_t ring = 0;
      HalfedgeId h = star[0];
      UseId u = c.edge_use[h.value() / 2];
      do {  // across a facet, then on to the other facet of the edge there
        ++ring;
        const bool leaves = c.use_halfedge[u.value()] == h;
        const UseId w = leaves ? c.use_prev[u.value()] : c.use_next[u.value()];
        h = leaves ? SpaceComplex::twin(c.use_halfedge[w.value()]) : c.use_halfedge[w.value()];
        u = c.use_radial[w.value()];
        if (c.use_radial[u.value()] != w) break;  // more than two facets
      } while (h != star[0]);
      EXPECT_TRUE(has_fan[v] == 0 || (h == star[0] && ring == star.size()));
      ++(has_fan[v] != 0 ? fans : others);
    }
  }
  EXPECT_GT(fans, 100);
  EXPECT_GT(others, 20);
  for (const std::uint8_t fan : find_fans(Linked(testing::icosphere_mesh(1, 1, {})).complex())) {
    EXPECT_EQ(fan, 1);
  }
  const Linked open(
      make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 3, 1}}));
  for (const std::uint8_t fan : find_fans(open.complex())) EXPECT_EQ(fan, 0);
}

}  // namespace plumb::mesh_topology_test
