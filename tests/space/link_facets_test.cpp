// Edges, uses and radial orders of facets, held against maps of edges, exact angles about an edge
// and the incidences of exact ends and planes.
#include "plumb/space/mesh/link_facets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <numeric>
#include <vector>

#include "generate/meshes.h"
#include "generate/space_scenes.h"
#include "generate/voxel_mesh.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/mesh/mesh_topology.h"
#include "plumb/testing/dice.h"

namespace plumb::link_facets_test {

using testing::cross;
using testing::Dice;
using testing::dot;
using testing::make_mesh;

struct Linked {
  std::shared_ptr<SpaceTables> tables = std::make_shared<SpaceTables>();
  MeshVertices vertices;
  MeshFacets facets;
  MeshReport report;
  MeshLinks links;

  explicit Linked(const PolygonMesh& mesh) {
    Context context;
    vertices = merge_equal_points(mesh, *tables);
    facets = flatten_mesh(mesh, vertices, *tables, report, context);
    links = link_corners(facets, vertices.point.size());
  }
  std::vector<MeshReport::FacePair> merge() {
    return merge_doubled(facets, links, vertices.point.size());
  }
  SpaceComplex complex(FlatEdges flat_edges) const {
    return link_facets(facets, links, vertices.point, tables, flat_edges);
  }
};

RationalPoint3 place(const SpaceComplex& c, VertexId v) {
  return exact(c.points(), c.vertex_point[v.value()]);
}
RationalPoint3 place(const SpaceComplex& c, std::size_t halfedge) {
  return place(c, c.origin[halfedge]);
}

PolygonMesh in_thirds(PolygonMesh mesh) {
  for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
    const Point3& p = mesh.points[i];
    mesh.exact.emplace_back(i, RationalPoint3{Rational(p.x) / 3, Rational(p.y) / 3, p.z});
  }
  return mesh;
}

// Voxels give edges with two and with four uses.
TEST(LinkFacets, FindsTheUsesOfEveryEdge) {
  Dice dice(41);
  for (int round = 0; round < 8; ++round) {
    const Linked mesh(testing::voxel_mesh(testing::random_voxels(dice, {3, 3, 2}, 5)));
    std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> uses;
    for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
      const std::uint32_t begin = mesh.facets.begin[f], end = mesh.facets.begin[f + 1];
      for (std::uint32_t u = begin; u < end; ++u) {
        const std::uint32_t next = u + 1 < end ? u + 1 : begin;
        const std::uint32_t v = mesh.facets.corner[u], w = mesh.facets.corner[next];
        EXPECT_EQ(mesh.links.next[u], next);
        EXPECT_EQ(mesh.links.facet[u], f);
        EXPECT_EQ(mesh.links.is_forward(mesh.facets, u), v < w);
        uses[{std::min(v, w), std::max(v, w)}].push_back(u);
      }
    }
    ASSERT_EQ(mesh.links.edge_count(), uses.size());
    std::size_t e = 0;
    for (const auto& [end, of_edge] : uses) {
      EXPECT_EQ(mesh.links.end[e], end);
      const auto found = mesh.links.uses_of(e++);
      EXPECT_EQ(std::vector(found.begin(), found.end()), of_edge);
    }
  }
}

// The square of faces 0, 3, 4 and 5 in both directions and from any corner, and triangles within
// it, which begin with the same use.
TEST(LinkFacets, AddsTheJumpsOfDoubledFacets) {
  Linked mesh(make_mesh(
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 3}},
      {{0, 1, 2, 3}, {0, 1, 2}, {0, 1, 4}, {2, 3, 0, 1}, {3, 2, 1, 0}, {1, 2, 3, 0}, {4, 0, 1}}));
  const std::vector<std::int32_t> before = mesh.facets.jump;
  const auto doubled = mesh.merge();
  EXPECT_EQ(doubled, (std::vector<MeshReport::FacePair>{{3, 0}, {4, 0}, {5, 0}, {6, 2}}));
  EXPECT_EQ(mesh.facets.origin, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(mesh.facets.jump, (std::vector<std::int32_t>{2 * before[0], before[1], 2 * before[2]}));
  EXPECT_EQ(before[4], -before[0]);
  // The links are those of the facets that are left.
  EXPECT_EQ(mesh.links.next.size(), mesh.facets.corner.size());
  EXPECT_EQ(mesh.links.edge_count(), 7U);
  EXPECT_TRUE(mesh.merge().empty());
}

// What is plainly closed has nothing that the searches for doubled facets and borders find.
TEST(LinkFacets, PlainlyClosedMeshesHaveNoDoublesAndNoBorders) {
  const auto is_plain = [](const PolygonMesh& mesh) {
    Linked linked(mesh);
    const bool result = is_plainly_closed(linked.facets, linked.links);
    if (result) {
      EXPECT_TRUE(trace_borders(linked.facets, linked.links, linked.vertices.point,
                                linked.tables->points, unlimited_context())
                      .empty());
      EXPECT_TRUE(linked.merge().empty());
    }
    return result;
  };
  const PolygonMesh sphere = testing::icosphere_mesh(2, 1, {});
  const PolygonMesh box = testing::box_mesh({0, 0, 0}, {1, 2, 3});
  for (const PolygonMesh& mesh : {sphere, testing::reversed(sphere), box, testing::fanned(box)}) {
    EXPECT_TRUE(is_plain(mesh));
    EXPECT_FALSE(is_plain(testing::joined(mesh, mesh)));
    EXPECT_FALSE(is_plain(testing::joined(mesh, testing::reversed(mesh))));
    PolygonMesh changed = mesh;
    changed.corners.resize(changed.corners.size() - mesh.face(mesh.face_count() - 1).size());
    changed.face_begin.pop_back();
    EXPECT_FALSE(is_plain(changed));  // A hole.
    changed = mesh;
    std::reverse(changed.corners.begin(), changed.corners.begin() + changed.face_begin[1]);
    EXPECT_FALSE(is_plain(changed));  // A flipped face.
    changed = mesh;
    changed.add_face(std::vector<std::uint32_t>{0, 1, 1});
    EXPECT_TRUE(is_plain(changed));  // What is left of the face has no edges.
  }
  // A triangle twice, once in each direction, bounds nothing.
  EXPECT_FALSE(is_plain(make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}})));
  Dice dice(44);
  int plain = 0;
  for (int round = 0; round < 40; ++round) {
    plain += is_plain(testing::voxel_mesh(testing::random_voxels(dice, {3, 2, 2}, 4))) ? 1 : 0;
  }
  EXPECT_GT(plain, 0);
  EXPECT_LT(plain, 40);
}

// Facets at one edge, some of them equal, against a comparison of all pairs; and so many that this
// comparison would not end.
TEST(LinkFacets, FindsDoubledFacetsAmongManyAtOneEdge) {
  Dice dice(43);
  for (int round = 0; round < 30; ++round) {
    std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}};
    for (int i = 0; i < 6; ++i) points.push_back({0.5, 1. + i % 3, i < 3 ? 0. : 1.});
    std::vector<std::vector<std::uint32_t>> faces;
    for (int i = 0; i < 20; ++i) {
      const std::uint32_t tip = 2 + dice.below(6);
      faces.push_back(dice.below(2) == 0 ? std::vector{0U, 1U, tip} : std::vector{1U, 0U, tip});
    }
    Linked mesh(make_mesh(points, faces));
    std::vector<MeshReport::FacePair> expected;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      for (std::uint32_t g = 0; g < f; ++g) {
        if (faces[f][2] != faces[g][2]) continue;
        expected.emplace_back(f, g);
        break;
      }
    }
    EXPECT_EQ(mesh.merge(), expected);
  }
  constexpr std::uint32_t kMany = 100'000;
  std::vector<Point3> points{{0, 0, 0}, {1, 0, 0}};
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < kMany; ++i) {
    points.push_back({0.5, 1. + i, 0});
    faces.push_back({0, 1, 2 + i});
  }
  Linked mesh(make_mesh(points, faces));
  EXPECT_TRUE(mesh.merge().empty());
}

// Pages of a book, triangles with one common edge: some opposite, some at less than a degree.
TEST(LinkFacets, TurnsAroundAnEdgeCounterClockwise) {
  Dice dice(42);
  for (int round = 0; round < 40; ++round) {
    const Point3 spine{1.0 * (round % 3), 1.0 * (round % 2), 1};
    std::vector<Point3> points{{0, 0, 0}, spine};
    std::vector<testing::Face> faces;
    const auto add_page = [&](double x, double y) {
      points.push_back({x, y, 0});
      const auto tip = static_cast<std::uint32_t>(points.size() - 1);
      faces.push_back(dice.below(2) == 0 ? testing::Face{0, 1, tip} : testing::Face{1, 0, tip});
    };
    for (int i = 0; i < 7; ++i) {
      const auto x = static_cast<double>(dice.between(-3, 3)), y = 3.5 - std::abs(x);
      const int side = dice.below(2) == 0 ? 1 : -1;
      add_page(x, side * y);
      if (i == 0) add_page(-x, -side * y);
      if (i == 1) add_page(x + 0x1p-40, side * y);
    }
    Linked mesh(make_mesh(points, faces));
    mesh.merge();
    const SpaceComplex c = mesh.complex(FlatEdges::Complete);
    const auto spine_edge = std::ranges::find_if(mesh.links.end, [](const auto& e) {
      return e == std::array<std::uint32_t, 2>{0, 1};
    });
    const auto e = static_cast<std::size_t>(spine_edge - mesh.links.end.begin());
    const RationalPoint3 d = place(c, 2 * e + 1) - place(c, 2 * e);
    const RationalPoint3 from = place(c, 2 * e);

    struct Spoke {
      Rational x, y;
      int half;
    };
    std::vector<Spoke> spokes;
    RationalPoint3 first;
    const UseId start = c.edge_use[e];
    UseId u = start;
    do {
      const VertexId tip = c.use_origin(c.use_prev[u.value()]);
      const RationalPoint3 n = cross(d, place(c, tip) - from);
      if (spokes.empty()) first = n;
      const Rational x = dot(n, first), y = dot(cross(first, n), d);
      spokes.push_back({x, y, y < 0 || (y == 0 && x < 0) ? 1 : 0});
      u = c.use_radial[u.value()];
    } while (u != start);
    EXPECT_EQ(spokes.size(), mesh.links.uses_of(e).size());
    for (std::size_t i = 1; i < spokes.size(); ++i) {
      const Spoke &s = spokes[i - 1], &t = spokes[i];
      EXPECT_TRUE(s.half < t.half || (s.half == t.half && s.x * t.y - s.y * t.x > 0)) << round;
    }
  }
}

void expect_sound_edges(const SpaceComplex& c) {
  for (std::size_t e = 0; e < c.edge_count(); ++e) {
    std::array<RationalPoint3, 2> normal;
    for (std::size_t i = 0; i < 2; ++i) {
      ASSERT_TRUE(c.edge_planes[e][i].is_valid());
      const IntegerRow row = c.planes().coefficients(c.edge_planes[e][i]);
      normal[i] = {row[0], row[1], row[2]};
      for (const std::size_t h : {2 * e, 2 * e + 1}) {
        EXPECT_EQ(dot(normal[i], place(c, h)), -Rational(row[3]));
      }
    }
    EXPECT_GT(dot(cross(normal[0], normal[1]), place(c, 2 * e + 1) - place(c, 2 * e)), 0);
  }
  std::vector<int> times(c.origin.size(), 0);
  for (std::uint32_t v = 0; v < c.vertex_count(); ++v) {
    for (const HalfedgeId h : c.star_of(VertexId(v))) {
      EXPECT_EQ(c.origin[h.value()].value(), v);
      ++times[h.value()];
    }
  }
  EXPECT_TRUE(std::ranges::all_of(times, [](int n) { return n == 1; }));
  for (std::uint32_t u = 0; u < c.use_count(); ++u) {
    EXPECT_EQ(c.use_origin(c.use_next[u]), c.target(c.use_halfedge[u]));
    EXPECT_EQ(c.use_prev[c.use_next[u].value()], UseId(u));
  }
}

// Diagonals of the sides of a box, and of squares on slanted planes, lie in one plane only.
TEST(LinkFacets, GivesFlatEdgesASecondPlane) {
  const PolygonMesh box = testing::fanned(testing::box_mesh({0, 0, 0}, {1, 2, 3}));
  const PolygonMesh roof = testing::fanned(
      make_mesh({{0, 0, 0}, {2, 1, 1}, {3, 3, 4}, {1, 2, 3}, {-1, 3, -2}, {1, 4, -1}},
                {{0, 1, 2, 3}, {0, 1, 5, 4}}));
  for (const PolygonMesh& mesh : {box, roof, in_thirds(box), in_thirds(roof)}) {
    const Linked linked(mesh);
    expect_sound_edges(linked.complex(FlatEdges::Complete));
  }
}

TEST(LinkFacets, LeavesFlatEdgesOfInputTrianglesOpenWhenTold) {
  const PolygonMesh box = testing::fanned(testing::box_mesh({0, 0, 0}, {1, 2, 3}));
  for (const bool has_fractions : {false, true}) {
    const Linked linked(has_fractions ? in_thirds(box) : box);
    const std::size_t planes = linked.tables->planes.size();
    SpaceComplex c = linked.complex(FlatEdges::Open);
    std::size_t open = 0;
    for (const auto& [p, q] : c.edge_planes) open += q.is_valid() ? 0U : 1U;
    EXPECT_EQ(open, has_fractions ? 0U : 6U);  // one diagonal a side
    EXPECT_EQ(c.planes().size() == planes, !has_fractions);
    complete_flat_edges(c, *linked.tables);
    expect_sound_edges(c);
  }
}

}  // namespace plumb::link_facets_test
