// The laws of divided surfaces, on closed surfaces and others; and meshes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "divided.h"
#include "generate/dice.h"
#include "plumb/base/error.h"
#include "plumb/surface/surface_arrangement.h"

namespace plumb::testing {
namespace {

// ---------------------------------------------------------------- laws

double mesh_area(const SurfaceMesh& m) {
  double whole = 0;
  for (std::uint32_t f = 0; f < m.face_count(); ++f) {
    const Point3 a = m.point(m.corner(FaceId(f), 0)), b = m.point(m.corner(FaceId(f), 1)),
                 c = m.point(m.corner(FaceId(f), 2));
    const Point3 u{b.x - a.x, b.y - a.y, b.z - a.z}, v{c.x - a.x, c.y - a.y, c.z - a.z};
    whole += std::hypot(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x) / 2;
  }
  return whole;
}

/// V - E + F of the arrangement where faces are touched, of the mesh elsewhere. Of closed meshes.
long characteristic(const SurfaceDivision& d) {
  const SurfaceArrangement& a = d.arrangement();
  const SurfaceMesh& m = d.mesh();
  const auto is_whole = [&](HalfedgeId h) {
    return a.slot_of_face[SurfaceMesh::face(h).value()] == SurfaceArrangement::kNone;
  };
  // Nodes that no half-edge starts in, points of polygons that are not there, do not count.
  std::vector<std::uint8_t> is_node(a.node_count());
  for (const NodeId n : a.origin) is_node[n.value()] = 1;
  long vertices = std::accumulate(is_node.begin(), is_node.end(), 0L);
  vertices += static_cast<long>(m.vertex_count() - a.corner_vertex.size());
  for (const SurfacePointId p : a.node_point) {
    if (d.scene().polygons.points.place(p) == SurfacePlace::Vertex) --vertices;
  }
  long edges = static_cast<long>(
      std::count_if(a.twin.begin(), a.twin.end(), [](HalfedgeId t) { return t.is_valid(); }) / 2);
  for (std::uint32_t e = 0; e < m.edge_count(); ++e) {
    const HalfedgeId h = m.halfedge(EdgeId(e));
    if (is_whole(h) || is_whole(m.twin(h))) ++edges;
  }
  // A piece with holes is no disk.
  long faces = static_cast<long>(2 * a.piece_count()) - static_cast<long>(a.loop.size());
  for (const std::uint32_t slot : a.slot_of_face) {
    if (slot == SurfaceArrangement::kNone) ++faces;
  }
  return vertices - edges + faces;
}

void expect_euler(const SurfaceDivision& d) {
  double sum = 0;
  for (std::uint32_t c = 0; c < d.cell_count(); ++c) sum += d.area(CellId(c));
  EXPECT_NEAR(sum, mesh_area(d.mesh()), 1e-9 * sum);
  const SurfaceMesh& m = d.mesh();
  for (std::uint32_t h = 0; h < 3 * m.face_count(); ++h) {
    if (m.is_border(HalfedgeId(h))) return;
  }
  EXPECT_EQ(characteristic(d), static_cast<long>(m.vertex_count()) -
                                   static_cast<long>(m.edge_count()) +
                                   static_cast<long>(m.face_count()));
}

TEST(SurfaceDivision, RandomWalksObeyTheLaws) {
  const MeshPointer meshes[] = {torus_mesh(6, 5), sphere_mesh(3), chain_of_tori(3, 6, 4),
                                cylinder_mesh(7, 5), grid_mesh(5, 4, 9)};
  for (std::uint64_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const MeshPointer& mesh = meshes[seed % 5];
    SurfaceDrawing s(mesh);
    for (int p = 0; p < 4; ++p) s.add_vertex_polygon(random_walk(*mesh, dice, 3 + seed % 12));
    const SurfaceDivision d = divide(s);
    expect_euler(d);
    if (seed % 5 == 1) {
      for (std::uint32_t p = 0; p < 4; ++p) EXPECT_TRUE(d.polygon_separation(p).over_z);
    }
  }
}

// ---------------------------------------------------------------- order does not matter

/// The same mesh with other numbers and its faces turned, and where vertices went.
struct Renumbered {
  MeshPointer mesh;
  std::vector<std::uint32_t> to;
};
Renumbered renumbered(const SurfaceMesh& mesh, Dice& dice) {
  Renumbered out;
  out.to.resize(mesh.vertex_count());
  std::iota(out.to.begin(), out.to.end(), 0U);
  for (std::size_t i = out.to.size(); i > 1; --i) std::swap(out.to[i - 1], out.to[dice.below(i)]);
  std::vector<Point3> points(mesh.vertex_count());
  for (std::uint32_t v = 0; v < points.size(); ++v) points[out.to[v]] = mesh.point(VertexId(v));
  std::vector<SurfaceTriangle> triangles;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    SurfaceTriangle t = mesh.corners(FaceId(f));
    for (std::uint32_t& v : t) v = out.to[v];
    std::rotate(t.begin(), t.begin() + dice.between(0, 2), t.end());
    triangles.push_back(t);
  }
  for (std::size_t i = triangles.size(); i > 1; --i) {
    std::swap(triangles[i - 1], triangles[dice.below(i)]);
  }
  out.mesh = std::make_shared<const SurfaceMesh>(points, triangles);
  return out;
}

using CellKey = std::pair<std::vector<std::pair<std::uint32_t, std::int32_t>>, std::int64_t>;
std::vector<CellKey> sorted_cells(const SurfaceDivision& d, bool polygons_are_reversed) {
  std::vector<CellKey> cells;
  const auto last = static_cast<std::uint32_t>(d.shape_count()) - 1;
  for (std::uint32_t c = 0; c < d.cell_count(); ++c) {
    CellKey& key = cells.emplace_back();
    for (const SignedEntry& e : d.labels(CellId(c))) {
      key.first.emplace_back(polygons_are_reversed ? last - e.id : e.id, e.value);
    }
    std::sort(key.first.begin(), key.first.end());
    key.second = std::llround(d.area(CellId(c)) * 1e6);
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

TEST(SurfaceDivision, OrderDoesNotMatter) {
  const MeshPointer meshes[] = {sphere_mesh(3), torus_mesh(6, 5), cylinder_mesh(7, 5)};
  for (std::uint64_t seed = 0; seed < 30 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const SurfaceMesh& mesh = *meshes[seed % 3];
    SurfaceDrawing one(meshes[seed % 3]);
    std::vector<std::vector<std::uint32_t>> walks;
    for (int p = 0; p < 4; ++p) walks.push_back(random_walk(mesh, dice, 4 + seed % 15));
    for (const auto& walk : walks) one.add_vertex_polygon(walk);
    const Renumbered other = renumbered(mesh, dice);
    SurfaceDrawing two(other.mesh);
    std::reverse(walks.begin(), walks.end());
    for (auto& walk : walks) {
      for (std::uint32_t& v : walk) v = other.to[v];
      two.add_vertex_polygon(walk);
    }
    const SurfaceDivision a = divide(one), b = divide(two);
    for (std::uint32_t p = 0; p < 4; ++p) {
      EXPECT_EQ(a.shape_separation(p).over_z, b.shape_separation(3 - p).over_z);
      EXPECT_EQ(a.shape_separation(p).mod_2, b.shape_separation(3 - p).mod_2);
    }
    EXPECT_EQ(a.counts().crossings, b.counts().crossings);
    EXPECT_EQ(a.counts().cell_edges, b.counts().cell_edges);
    // Modulo 2 the zero of a label is a choice where cells are equally large.
    const bool is_unique = std::ranges::all_of(std::array{0U, 1U, 2U, 3U}, [&](std::uint32_t p) {
      return a.shape_separation(p).over_z || !a.shape_separation(p).mod_2;
    });
    if (is_unique) {
      EXPECT_EQ(sorted_cells(a, false), sorted_cells(b, true));
    }
  }
}

TEST(SurfaceDivision, SetsObeyTheirLaws) {
  const std::pair<const char*, const char*> laws[] = {
      {"!(A + B)", "!A * !B"},
      {"!(A * B)", "!A + !B"},
      {"A - B", "A * !B"},
      {"A ^ B", "(A + B) - (A * B)"},
      {"A * (B + C)", "A * B + A * C"},
      {"A ^ A", "A - A"},
      {"!!A", "A"},
      {"A + (B + C)", "C + (A + B)"},
  };
  for (std::uint64_t seed = 0; seed < 10 && !HasFailure(); ++seed) {
    Dice dice(seed);
    SurfaceDrawing s(sphere_mesh(3));
    for (int p = 0; p < 3; ++p) s.add_vertex_polygon(random_walk(*s.scene.mesh, dice, 12));
    const SurfaceDivision d = divide(s);
    for (const WindingRule rule :
         {WindingRule::EvenOdd, WindingRule::NonZero, WindingRule::Positive}) {
      for (const auto& [left, right] : laws) {
        SCOPED_TRACE(left);
        EXPECT_EQ(d.select(parse_set_expression(left), rule).is_selected,
                  d.select(parse_set_expression(right), rule).is_selected);
      }
      // A region and its complement have the same border, run through the other way.
      const SurfaceResult in = d.evaluate(parse_set_expression("A - B"), rule);
      const SurfaceResult out = d.evaluate(parse_set_expression("!(A - B)"), rule);
      EXPECT_EQ(in.borders.point.size(), out.borders.point.size());
    }
  }
}

// The walk of a surface, pushed off its vertices: through edge points around each vertex. In general position.
TEST(SurfaceDivision, CellsOfASphereFollowFromCrossings) {
  for (std::uint64_t seed = 0; seed < 40 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    SurfaceDrawing s(sphere_mesh(2 + static_cast<std::uint32_t>(seed % 3)));
    const SurfaceMesh& m = *s.scene.mesh;
    const int polygons = 1 + static_cast<int>(seed % 6);
    for (int p = 0; p < polygons; ++p) {
      // From face to face over random edges until the first comes again.
      FaceId f(dice.below(m.face_count()));
      const FaceId start = f;
      std::vector<SurfacePointId> points;
      HalfedgeId last;
      for (int step = 0; step < 400; ++step) {
        HalfedgeId h;
        do {
          h = SurfaceMesh::halfedge(f, dice.below(3));
        } while (h == last);
        const Rational t = Rational(dice.between(1, 99999)) / 100000;
        points.push_back(s.scene.polygons.points.add_on_edge(m.edge(h), t));
        last = m.twin(h);
        f = SurfaceMesh::face(last);
        if (f == start && points.size() > 2 &&
            s.scene.polygons.points.edge(points.front()) !=
                s.scene.polygons.points.edge(points.back())) {
          break;
        }
      }
      if (f != start) continue;
      if (s.scene.polygons.points.edge(points.front()) ==
          s.scene.polygons.points.edge(points.back())) {
        continue;
      }
      s.add_polygon(points);
    }
    const SurfaceDivision d = divide(s);
    // Curves that cross are one component.
    const SurfaceArrangement& a = d.arrangement();
    std::vector<std::uint32_t> part(s.scene.polygons.size());
    std::iota(part.begin(), part.end(), 0U);
    const auto root = [&](std::uint32_t i) {
      while (part[i] != i) i = part[i];
      return i;
    };
    std::vector<std::uint32_t> first_at(a.node_count(), ~0U);
    for (std::uint32_t i = 0; i < a.arc_count(); ++i) {
      const std::uint32_t p = a.multiplicities(ArcId(i)).front().id;
      const HalfedgeId h = a.arc_halfedge[i];
      for (const NodeId n : {a.origin[h.value()], a.target(h)}) {
        if (first_at[n.value()] == ~0U) first_at[n.value()] = p;
        part[root(p)] = root(first_at[n.value()]);
      }
    }
    std::size_t components = 0;
    for (std::uint32_t p = 0; p < part.size(); ++p) components += part[p] == p ? 1 : 0;
    EXPECT_EQ(d.cell_count(), d.counts().crossings + components + 1);
    for (std::uint32_t p = 0; p < part.size(); ++p) EXPECT_TRUE(d.polygon_separation(p).over_z);
    expect_euler(d);
  }
}

// ---------------------------------------------------------------- meshes

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

}  // namespace
}  // namespace plumb::testing
