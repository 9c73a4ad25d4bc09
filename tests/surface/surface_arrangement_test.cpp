// The laws of divided surfaces, on closed surfaces and others.
#include "plumb/surface/cells/surface_arrangement.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "divided.h"
#include "plumb/testing/dice.h"

namespace plumb::testing::surface_arrangement_test {
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
    return a.slot_of_face[SurfaceMesh::face(h).value()] == kNone;
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
    if (slot == kNone) ++faces;
  }
  return vertices - edges + faces;
}

/// Areas of cells add up; the Euler characteristic is that of the mesh. Empty, or what is wrong.
std::string euler_flaw(const SurfaceDivision& d) {
  double sum = 0;
  for (std::uint32_t c = 0; c < d.cell_count(); ++c) sum += d.area(CellId(c));
  if (std::fabs(sum - mesh_area(d.mesh())) > 1e-9 * sum) return "areas";
  const SurfaceMesh& m = d.mesh();
  for (std::uint32_t h = 0; h < 3 * m.face_count(); ++h) {
    if (m.is_border(HalfedgeId(h))) return "";
  }
  const long expected = static_cast<long>(m.vertex_count()) - static_cast<long>(m.edge_count()) +
                        static_cast<long>(m.face_count());
  return characteristic(d) == expected ? "" : "Euler characteristic";
}

/// What RapidCheck makes and shrinks: the steps of closed walks.
using Walks = std::vector<std::vector<std::uint8_t>>;
constexpr std::size_t kMostWalks = 5;

SurfaceDrawing drawn(const MeshPointer& mesh, const Walks& walks) {
  SurfaceDrawing s(mesh);
  for (std::size_t p = 0; p < std::min(walks.size(), kMostWalks); ++p) {
    s.add_vertex_polygon(closed_walk(*mesh, walks[p]));
  }
  return s;
}
SurfaceDivision divided_soundly(const SurfaceDrawing& drawing) {
  Context context;
  SurfaceDivision division(drawing.scene, context);
  RC_ASSERT(audit(division).value_or("") == "");
  return division;
}

TEST(SurfaceDivision, WalksObeyTheLaws) {
  const MeshPointer meshes[] = {torus_mesh(6, 5), sphere_mesh(3), chain_of_tori(3, 6, 4),
                                cylinder_mesh(7, 5), grid_mesh(5, 4, 9)};
  EXPECT_TRUE(rc::check("cells add up", [&](std::uint8_t mesh, const Walks& walks) {
    const SurfaceDivision d = divided_soundly(drawn(meshes[mesh % 5], walks));
    RC_ASSERT(euler_flaw(d) == "");
    for (std::uint32_t p = 0; mesh % 5 == 1 && p < d.shape_count(); ++p) {
      RC_ASSERT(d.polygon_separation(p).over_z);
    }
  }));
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
  EXPECT_TRUE(rc::check(
      "order does not matter", [&](std::uint8_t number, const Walks& walks, std::uint64_t seed) {
        const MeshPointer& mesh = meshes[number % 3];
        const SurfaceDrawing one = drawn(mesh, walks);
        Dice dice(seed);
        const Renumbered other = renumbered(*mesh, dice);
        SurfaceDrawing two(other.mesh);
        for (std::size_t p = std::min(walks.size(), kMostWalks); p-- > 0;) {
          std::vector<std::uint32_t> walk = closed_walk(*mesh, walks[p]);
          for (std::uint32_t& v : walk) v = other.to[v];
          two.add_vertex_polygon(walk);
        }
        const SurfaceDivision a = divided_soundly(one), b = divided_soundly(two);
        bool is_unique =
            true;  // modulo 2 the zero of a label is a choice where cells are equally large
        for (std::uint32_t p = 0; p < a.shape_count(); ++p) {
          const auto last = static_cast<std::uint32_t>(a.shape_count()) - 1;
          const Separation &here = a.shape_separation(p), &there = b.shape_separation(last - p);
          RC_ASSERT(here.over_z == there.over_z);
          RC_ASSERT(here.mod_2 == there.mod_2);
          is_unique = is_unique && (here.over_z || !here.mod_2);
        }
        RC_ASSERT(a.counts().crossings == b.counts().crossings);
        RC_ASSERT(a.counts().cell_edges == b.counts().cell_edges);
        if (is_unique) RC_ASSERT(sorted_cells(a, false) == sorted_cells(b, true));
      }));
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
  const MeshPointer meshes[] = {sphere_mesh(3), cylinder_mesh(7, 5), grid_mesh(5, 4, 9)};
  constexpr WindingRule kRules[] = {WindingRule::EvenOdd, WindingRule::NonZero,
                                    WindingRule::Positive};
  EXPECT_TRUE(rc::check("laws of sets", [&](std::uint8_t number, Walks walks) {
    walks.resize(3);
    const SurfaceDivision d = divided_soundly(drawn(meshes[number % 3], walks));
    const auto select = [&](const char* text, WindingRule rule) {
      return d.select(parse_set_expression(text), rule);
    };
    for (const WindingRule rule : kRules) {
      for (const auto& [left, right] : laws) {
        RC_ASSERT(select(left, rule).is_selected == select(right, rule).is_selected);
      }
      const double sum = select("A", rule).area + select("B", rule).area;
      const double parts = select("A + B", rule).area + select("A * B", rule).area;
      RC_ASSERT(std::fabs(sum - parts) <= 1e-9 * (1 + sum));
      // A region and its complement have the same border, run through the other way; along the mesh
      // border they have different ones.
      const SurfaceResult in = d.evaluate(parse_set_expression("A - B"), rule);
      const SurfaceResult out = d.evaluate(parse_set_expression("!(A - B)"), rule);
      if (number % 3 == 0) RC_ASSERT(in.borders.point.size() == out.borders.point.size());
    }
  }));
}

// The walk of a surface, pushed off its vertices: through edge points around each vertex. In
// general position.
TEST(SurfaceDivision, CellsOfASphereFollowFromCrossings) {
  EXPECT_TRUE(rc::check("cells of a sphere", [](std::uint8_t n, const Walks& walks) {
    SurfaceDrawing s(sphere_mesh(2 + n % 3U));
    const SurfaceMesh& m = *s.scene.mesh;
    std::uint64_t count = n;
    // Never the same twice: in general position.
    const auto next_weight = [&] { return Rational(++count * 48271 % 99991) / 99991; };
    const auto edge_of = [&](SurfacePointId p) { return s.scene.polygons.points.edge(p); };
    for (std::size_t p = 0; p < std::min(walks.size(), kMostWalks); ++p) {
      // From face to face over edges until the first comes again.
      const auto choice = [&](std::size_t i) {
        return i < walks[p].size() ? walks[p][i] : static_cast<std::uint32_t>((i * i + p) % 7);
      };
      FaceId f(choice(0) % m.face_count());
      const FaceId start = f;
      std::vector<SurfacePointId> points;
      HalfedgeId last;
      bool is_closed = false;
      for (std::size_t step = 1; step < 400 && !is_closed; ++step) {
        HalfedgeId h = SurfaceMesh::halfedge(f, choice(step) % 3);
        if (h == last) h = SurfaceMesh::next(h);
        points.push_back(s.scene.polygons.points.add_on_edge(m.edge(h), next_weight()));
        last = m.twin(h);
        f = SurfaceMesh::face(last);
        is_closed =
            f == start && points.size() > 2 && edge_of(points.front()) != edge_of(points.back());
      }
      if (is_closed) s.add_polygon(points);
    }
    const SurfaceDivision d = divided_soundly(s);
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
    RC_ASSERT(d.cell_count() == d.counts().crossings + components + 1);
    for (std::uint32_t p = 0; p < part.size(); ++p) RC_ASSERT(d.polygon_separation(p).over_z);
    RC_ASSERT(euler_flaw(d) == "");
  }));
}

}  // namespace
}  // namespace plumb::testing::surface_arrangement_test
