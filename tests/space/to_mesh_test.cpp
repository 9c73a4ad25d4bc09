// Meshes of complexes: round trips keep the solid, and what a mesh cannot hold is said.
#include "plumb/space/to_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "plumb/predicates/rounding.h"
#include "plumb/space/from_mesh.h"
#include "plumb/space/nef3.h"
#include "plumb/space/query/volumes.h"
#include "plumb/space/rounded_mesh.h"
#include "plumb/testing/dice.h"
#include "space/complex_links.h"

namespace plumb::testing::to_mesh_test {
namespace {

MeshComplex complex_of(const PolygonMesh& mesh) {
  Context context;
  MeshComplex result = complex_of_mesh(mesh, {}, context);
  EXPECT_TRUE(result.report.is_closed());
  EXPECT_FALSE(result.report.crosses_itself());
  return result;
}

/// Volume 1 is the solid: behind all faces. (Which volumes are one makes no difference to a mesh.)
SpaceComplex marked(const MeshComplex& mesh) {
  SpaceComplex complex = mesh.complex;
  complex.volume_mark = {0, 1};
  for (std::size_t f = 0; f < complex.facet_count(); ++f) {
    const VolumeId outside(0), solid(1);
    complex.facet_volume[f] = {mesh.jump[f] > 0 ? solid : outside,
                               mesh.jump[f] < 0 ? solid : outside};
    if (mesh.jump[f] == 0) complex.facet_volume[f] = {solid, solid};
  }
  std::ranges::fill(complex.facet_mark, Mark{1});
  std::ranges::fill(complex.edge_mark, Mark{1});
  std::ranges::fill(complex.vertex_mark, Mark{1});
  return complex;
}

MeshOfComplex mesh_of(const SpaceComplex& complex, ToMeshOptions options = {.keeps_exact = true}) {
  Context context;
  return mesh_of_complex(complex, options, context);
}

RoundingReport rounding_of(const PolygonMesh& mesh) {
  Context context;
  return check_rounding(mesh, 100, context);
}

const PolygonMesh kCube = box_mesh({0, 0, 0}, {3, 3, 3});
const std::vector<Point2> kLetterC = {{0, 0}, {3, 0}, {3, 1}, {1, 1},
                                      {1, 2}, {3, 2}, {3, 3}, {0, 3}};

struct Case {
  const char* name;
  PolygonMesh mesh;
};

std::vector<Case> solids() {
  return {{"cube", kCube},
          {"in triangles", fanned(kCube)},
          {"cavity", joined(kCube, reversed(box_mesh({1, 1, 1}, {2, 2, 2})))},
          {"letter", prism_mesh(kLetterC, -1, 0.1)},
          {"sphere", icosphere_mesh(2, 0.7, {0.1, 0.2, 0.3})},
          {"at an edge", joined(kCube, moved(kCube, {3, 3, 0}))},
          {"at a corner", joined(kCube, moved(kCube, {3, 3, 3}))},
          {"touching hole",
           prism_mesh({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 2}, {2, 2}, {2, 1}}, 0, 1)}};
}

TEST(ToMesh, RoundTripsKeepTheSolid) {
  for (const Case& c : solids()) {
    const MeshComplex given = complex_of(c.mesh);
    for (const MeshFaces faces :
         {MeshFaces::Polygons, MeshFaces::PlanarPolygons, MeshFaces::Triangles}) {
      for (const bool is_split : {false, true}) {
        SCOPED_TRACE(std::string(c.name) + " " + std::to_string(static_cast<int>(faces)));
        const MeshOfComplex out = mesh_of(marked(given), {faces, is_split});
        EXPECT_EQ(out.report.dropped.total() + out.report.filled.total(), 0U);
        EXPECT_EQ(out.facet.size(), out.mesh.face_count());
        EXPECT_TRUE(out.mesh.exact.empty());
        const MeshComplex again = complex_of(out.mesh);
        EXPECT_EQ(enclosed_volume(again.complex, again.jump),
                  enclosed_volume(given.complex, given.jump));
        EXPECT_EQ(again.complex.vertex_count(), given.complex.vertex_count());
        if (faces == MeshFaces::Triangles) {
          EXPECT_EQ(out.mesh.corners.size(), 3 * out.mesh.face_count());
        } else {
          EXPECT_EQ(again.complex.facet_count(), given.complex.facet_count());
        }
        EXPECT_EQ(again.report.vertices_merged,
                  out.mesh.points.size() - given.complex.vertex_count());
      }
    }
  }
}

// What the engine makes of a mesh before marks: one winding number a volume.
TEST(ToMesh, WindingNumbersOfMeshes) {
  const PolygonMesh inner = box_mesh({1, 1, 1}, {2, 2, 2});
  const std::vector<std::pair<PolygonMesh, std::vector<std::int32_t>>> cases = {
      {kCube, {0, 1}},
      {reversed(kCube), {0, -1}},
      {joined(kCube, kCube), {0, 2}},
      {joined(kCube, reversed(inner)), {0, 1, 0}},
      {joined(kCube, inner), {0, 1, 2}},
      {joined(kCube, moved(kCube, {3, 0, 0})), {0, 1, 1}},
      {joined(kCube, moved(kCube, {3, 3, 3})), {0, 1, 1}},
      {joined(kCube, moved(kCube, {9, 0, 0})), {0, 1, 1}},
  };
  for (const auto& [mesh, expected] : cases) {
    MeshComplex made = complex_of(mesh);
    Context context;
    label_volumes(made.complex, context);
    EXPECT_EQ(winding_numbers(made.complex, made.jump), expected);
  }
}

TEST(ToMesh, NonManifoldPlacesAreCountedAndSplit) {
  const SpaceComplex at_edge = marked(complex_of(joined(kCube, moved(kCube, {3, 3, 0}))));
  const MeshOfComplex soup = mesh_of(at_edge);
  EXPECT_EQ(soup.report.non_manifold_edges, 1U);
  EXPECT_EQ(soup.report.non_manifold_vertices, 2U);
  EXPECT_EQ(soup.mesh.points.size(), 14U);
  ToMeshOptions split{.keeps_exact = true};
  split.split_vertices = true;
  EXPECT_EQ(mesh_of(at_edge, split).mesh.points.size(), 16U);
  const MeshOfComplex corner = mesh_of(marked(complex_of(joined(kCube, moved(kCube, {3, 3, 3})))));
  EXPECT_EQ(corner.report.non_manifold_edges, 0U);
  EXPECT_EQ(corner.report.non_manifold_vertices, 1U);
  EXPECT_FALSE(mesh_of(marked(complex_of(kCube))).report.is_soup());
}

/// Returns the octants of an octahedron whose bits are set, as one mesh of tetrahedra.
PolygonMesh octants(std::uint32_t set) {
  PolygonMesh mesh;
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    if ((set >> octant & 1) == 0) continue;
    const auto sign = [octant](std::uint32_t axis) {
      return (octant >> axis & 1) != 0 ? 1.0 : -1.0;
    };
    const bool is_mirrored = sign(0) * sign(1) * sign(2) < 0;
    const PolygonMesh one =
        tetrahedron_mesh({sign(0), 0, 0}, {0, sign(1), 0}, {0, 0, sign(2)}, {0, 0, 0});
    mesh = joined(mesh, is_mirrored ? reversed(one) : one);
  }
  return mesh;
}

// A walk around each vertex counts cones if each edge has two facets; classes of corners count them
// when vertices are split, and at other edges.
TEST(ToMesh, WalksAndClassesCountTheSameCones) {
  std::size_t walks_with_cones = 0;
  for (std::uint32_t set = 1; set < 256; ++set) {
    Context context;
    const Nef3 solid = Nef3::from_mesh(octants(set), {.rule = WindingRule::Positive}, context);
    ToMeshOptions options{.faces = MeshFaces::Triangles};
    const ToMeshReport whole = mesh_of(solid.complex(), options).report;
    options.split_vertices = true;
    const ToMeshReport split = mesh_of(solid.complex(), options).report;
    EXPECT_EQ(whole.non_manifold_vertices, split.non_manifold_vertices) << set;
    EXPECT_EQ(whole.non_manifold_edges, split.non_manifold_edges) << set;
    if (whole.non_manifold_edges == 0) walks_with_cones += whole.non_manifold_vertices;
  }
  // Two opposite octants meet in a vertex only, and so do the two that the others leave out.
  EXPECT_EQ(walks_with_cones, 8U);
}

/// Facet `inside` lies in facet `around`, in the same plane: cuts it out.
void cut_out(SpaceComplex& complex, std::uint32_t around, std::uint32_t inside) {
  const UseId first = complex.cycles_of(FacetId(inside))[0];
  UseId u = first;
  do {
    const std::uint32_t i = u.value();
    u = complex.use_next[i];
    complex.use_halfedge[i] = SpaceComplex::twin(complex.use_halfedge[i]);
    std::swap(complex.use_next[i], complex.use_prev[i]);
    complex.use_facet[i] = FacetId(around);
  } while (u != first);
  ASSERT_EQ(inside + 1, complex.facet_count());  // the last one, so that no id changes
  complex.facet_plane.pop_back();
  complex.facet_mark.pop_back();
  complex.facet_volume.pop_back();
  complex.facet_origin.pop_back();
  complex.cycle.pop_back();
  complex.cycle_begin.pop_back();
  complex.inner_begin.pop_back();
  complex.cycle.insert(complex.cycle.begin() + complex.cycle_begin[around + 1], first);
  for (std::size_t f = around + 1; f < complex.cycle_begin.size(); ++f) ++complex.cycle_begin[f];
}

// A pit dug into the top of a cube.
TEST(ToMesh, FacetsWithHolesAreCut) {
  PolygonMesh pit = reversed(box_mesh({1, 1, 1}, {2, 2, 3}));
  PolygonMesh last_is_lid;
  last_is_lid.points = pit.points;
  for (const std::size_t f : {0U, 2U, 3U, 4U, 5U, 1U}) last_is_lid.add_face(pit.face(f));
  Context context;
  const MeshComplex overlapping = complex_of_mesh(joined(kCube, last_is_lid), {}, context);
  SpaceComplex complex = marked(overlapping);
  cut_out(complex, 1, 11);
  ASSERT_EQ(broken_link(complex), "");
  for (const MeshFaces faces : {MeshFaces::Polygons, MeshFaces::Triangles}) {
    const MeshOfComplex out = mesh_of(complex, {faces, false});
    EXPECT_EQ(out.mesh.points.size(), 16U);
    EXPECT_EQ(std::ranges::count(out.facet, FacetId(1)), 8);
    const MeshComplex again = complex_of(out.mesh);
    EXPECT_EQ(enclosed_volume(again.complex, again.jump), 6 * (27 - 2));
  }
}

/// Voids touch the bottom of a cube along an edge and at points: triangles end at the edge.
TEST(ToMesh, EdgesInsideAFacetAreSidesOfTriangles) {
  int cases = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    Dice dice(i);
    const auto at = [&](double z) {
      const auto coordinate = [&] { return static_cast<double>(dice.between(1, 23)) / 8; };
      return Point3{coordinate(), coordinate(), z};
    };
    Nef3 set = solid(kCube);
    const auto hollow_out = [&](const PolygonMesh& mesh) {
      set = set - solid(mesh) - solid(reversed(mesh));
    };
    const Point3 a = at(0), b = at(0);
    hollow_out(tetrahedron_mesh(a, b, {a.x, a.y, 2}, {b.x + 0x1p-5, b.y + 0x1p-6, 2}));
    for (int k = 0; k < 4; ++k) {
      const Point3 p = at(0);
      hollow_out(tetrahedron_mesh(p, {p.x, p.y, 0x1p-3}, {p.x + 0x1p-4, p.y, 0x1p-3},
                                  {p.x, p.y + 0x1p-4, 0x1p-3}));
    }
    const MeshOfComplex made = mesh_of(set.regularization().complex(),
                                       {.faces = MeshFaces::Triangles, .keeps_exact = true});
    if (!made.mesh.exact.empty()) continue;  // The voids meet.
    ++cases;
    const MeshReport report = complex_of_mesh(made.mesh).report;
    EXPECT_TRUE(report.is_closed());
    EXPECT_FALSE(report.crosses_itself());
  }
  EXPECT_GT(cases, 20);
}

TEST(ToMesh, WhatIsDroppedAndFilledIsCounted) {
  SpaceComplex open = marked(complex_of(kCube));
  std::ranges::fill(open.facet_mark, Mark{0});
  open.edge_mark[5] = 0;
  open.vertex_mark[1] = 0;
  MeshOfComplex out = mesh_of(open);
  EXPECT_EQ(out.report.closed.facets, 6U);
  EXPECT_EQ(out.report.closed.edges, 1U);
  EXPECT_EQ(out.report.closed.vertices, 1U);
  EXPECT_EQ(out.report.filled.total(), 0U);
  EXPECT_EQ(out.mesh.face_count(), 6U);

  SpaceComplex cracked = marked(complex_of(joined(kCube, moved(kCube, {3, 0, 0}))));
  const auto is_wall = [&](std::size_t f) {
    return cracked.volume_mark[cracked.facet_volume[f][0].value()] == 1 &&
           cracked.volume_mark[cracked.facet_volume[f][1].value()] == 1;
  };
  for (std::size_t f = 0; f < cracked.facet_count(); ++f) {
    if (is_wall(f)) cracked.facet_mark[f] = 0;
  }
  out = mesh_of(cracked);
  EXPECT_EQ(out.report.filled.facets, 1U);
  EXPECT_EQ(out.report.filled.total(), 1U);
  EXPECT_EQ(out.report.closed.total(), 0U);

  SpaceComplex shell = marked(complex_of(kCube));  // a marked surface around nothing
  shell.volume_mark = {0, 0};
  out = mesh_of(shell);
  EXPECT_EQ(out.report.dropped.facets, 6U);
  EXPECT_EQ(out.report.dropped.edges, 12U);
  EXPECT_EQ(out.report.dropped.vertices, 8U);
  EXPECT_EQ(out.mesh.face_count(), 0U);

  SpaceComplex outside = marked(complex_of(kCube));
  outside.volume_mark = {1, 0};
  out = mesh_of(outside);
  EXPECT_TRUE(out.report.is_unbounded);
  EXPECT_EQ(out.mesh.face_count(), 0U);
}

// A wall between two chambers is filled, not part of the boundary.
TEST(ToMesh, WallsInsideTheSolidAreNoFaces) {
  const MeshComplex chambers = complex_of(joined(kCube, moved(kCube, {3, 0, 0})));
  const MeshOfComplex out = mesh_of(marked(chambers));
  EXPECT_EQ(out.mesh.face_count(), 10U);
  EXPECT_FALSE(out.report.is_soup());
  const MeshComplex again = complex_of(out.mesh);
  EXPECT_EQ(enclosed_volume(again.complex, again.jump), 6 * 54);
}

TEST(ToMesh, BothSidesOfASheet) {
  Context context;
  const SpaceComplex cube = complex_of(kCube).complex;
  std::vector<FacetSide> sides;
  for (const bool is_reversed : {false, true}) {
    sides.push_back({FacetId(0), is_reversed});
    sides.push_back({FacetId(2), is_reversed});
  }
  const MeshOfComplex out = mesh_of_sides(cube, sides, {}, context);
  EXPECT_EQ(out.mesh.face_count(), 4U);
  EXPECT_EQ(out.report.non_manifold_edges, 1U);  // where the two squares meet
  EXPECT_TRUE(complex_of_mesh(out.mesh, {}, context).report.is_closed());
}

// ---------------------------------------------------------------- rounding

PolygonMesh scaled(PolygonMesh mesh, const Rational& by) {
  for (std::uint32_t v = 0; v < mesh.points.size(); ++v) {
    const Point3& p = mesh.points[v];
    mesh.exact.emplace_back(v, RationalPoint3{p.x * by, p.y * by, p.z * by});
  }
  return mesh;
}

TEST(ToMesh, CoordinatesAreRoundedAndKept) {
  const MeshComplex thirds = complex_of(scaled(kCube, Rational(1) / 30));
  for (const MeshFaces faces : {MeshFaces::Polygons, MeshFaces::PlanarPolygons}) {
    const MeshOfComplex out = mesh_of(marked(thirds), {.faces = faces, .keeps_exact = true});
    EXPECT_EQ(out.mesh.exact.size(), 7U);  // all but the origin
    EXPECT_EQ(out.mesh.points[6], (Point3{0.1, 0.1, 0.1}));
    EXPECT_EQ(out.mesh.face_count(), faces == MeshFaces::Polygons ? 6U : 12U);
    const MeshComplex again = complex_of(out.mesh);
    EXPECT_EQ(enclosed_volume(again.complex, again.jump), 6 * Rational(1) / 1000);
    EXPECT_TRUE(rounding_of(out.mesh).is_sound());
    EXPECT_EQ(rounding_of(out.mesh).rounded_vertices, 7U);
  }
}

// Two crossing beams: the four corners where they meet are constructed, and are doubles or are not.
TEST(ToMesh, ConstructedCornersThatAreDoublesMayBelongToPolygons) {
  const auto cross = [](double shear) {
    return solid(box_mesh({0, 0, 0}, {4, 1, 1})) +
           solid(prism_mesh({{1, -1}, {2, -1}, {2 + shear, 2}, {1 + shear, 2}}, 0, 1));
  };
  const auto sizes = [](const PolygonMesh& mesh) {
    std::map<std::size_t, int> count;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) ++count[mesh.face(f).size()];
    return count;
  };
  const std::map<std::size_t, int> polygons{{4, 12}, {12, 2}};
  EXPECT_EQ(sizes(mesh_of(cross(0).complex(), {}).mesh), polygons);
  const Nef3 sheared = cross(1);  // The beams meet at thirds.
  EXPECT_EQ(sizes(mesh_of(sheared.complex(), {.faces = MeshFaces::Polygons}).mesh), polygons);
  // Of the walls, the four at the free ends of the beams have no constructed corner.
  const auto some = sizes(mesh_of(sheared.complex(), {}).mesh);
  EXPECT_EQ(some.at(4), 4);
  EXPECT_FALSE(some.contains(12));
}

// Small and large numbers, both signs: rounding does not need lowest terms.
TEST(ToMesh, CoordinatesAreRoundedTheSameWithoutExactOnes) {
  for (const double unit : {1.0, -1.0 / 3, 1e100, -1e-100, 1e-280}) {
    const auto ball = [&](Point3 centre) {
      Context context;
      PolygonMesh mesh = icosphere_mesh(1, unit, centre);
      return Nef3::from_mesh(unit < 0 ? reversed(mesh) : mesh, {.rule = WindingRule::Positive},
                             context);
    };
    const Nef3 both = ball({0, 0, 0}) - ball({0.3 * unit, -0.2 * unit, unit / 7});
    const PolygonMesh kept = mesh_of(both.complex(), {.keeps_exact = true}).mesh;
    const PolygonMesh rounded = mesh_of(both.complex(), {}).mesh;
    EXPECT_EQ(rounded.points, kept.points);
    EXPECT_TRUE(rounded.exact.empty());
    EXPECT_FALSE(kept.exact.empty());
    for (const auto& [i, p] : kept.exact) {
      EXPECT_EQ(kept.points[i],
                (Point3{nearest_double(p.x), nearest_double(p.y), nearest_double(p.z)}));
    }
  }
}

/// Whether a mesh of the complex can be made under a limit of memory.
bool is_enough(const SpaceComplex& complex, std::uint64_t bytes, unsigned threads) {
  Context context({.max_memory_bytes = bytes}, {}, {}, threads);
  try {
    (void)mesh_of_complex(complex, {}, context);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ResourceLimit);
    return false;
  }
  EXPECT_NO_THROW(context.charge_memory(bytes, "all"));  // Nothing stays charged.
  return true;
}

// Several threads make parts of the mesh, which exist beside the mesh until they are joined.
TEST(ToMesh, PartsOfSeveralThreadsAreCharged) {
  const SpaceComplex complex = marked(complex_of(icosphere_mesh(5, 1, {0, 0, 0})));
  std::uint64_t least = 1, enough = std::uint64_t{1} << 26;
  ASSERT_TRUE(is_enough(complex, enough, 1));
  while (enough - least > 1) {
    const std::uint64_t middle = (least + enough) / 2;
    (is_enough(complex, middle, 1) ? enough : least) = middle;
  }
  // Three corners, a begin and a facet of each triangle. At least half of them are in parts.
  const std::uint64_t in_parts = (3 + 1 + 1) * sizeof(std::uint32_t) * 20'480 / 2;
  for (const unsigned threads : {2U, 5U}) {
    EXPECT_FALSE(is_enough(complex, enough + in_parts, threads)) << threads << " threads";
    EXPECT_TRUE(is_enough(complex, enough + 8 * in_parts, threads)) << threads << " threads";
  }
}

}  // namespace
}  // namespace plumb::testing::to_mesh_test
