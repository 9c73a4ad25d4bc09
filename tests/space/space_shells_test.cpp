// Shells of solids with voids, loose parts and unbounded sets: numbers and volumes by construction,
// and laws of all shells of random voxels, whose cells touch in edges and vertices.
#include "plumb/space/space_shells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/predicates/error.h"

namespace plumb::space_shells_test {
namespace {

using testing::box_mesh;
using testing::solid;

Nef3 cube(double low, double high) { return solid(box_mesh({low, low, low}, {high, high, high})); }

TEST(SpaceShells, OfASolidWithVoids) {
  const Nef3 cheese = cube(0, 9) - cube(1, 3) - cube(5, 8);
  const SpaceShells shells(cheese.complex());
  EXPECT_EQ(shells.size(), 6U) << "two sides of three boundaries";
  const VolumeId body = cheese.locate(Point3{4, 4, 4}).item.volume();
  const auto of_body = shells.shells_of(body);
  ASSERT_EQ(of_body.size(), 3U);
  for (const ShellId s : of_body) {
    EXPECT_EQ(shells.volume(s), body);
    EXPECT_EQ(shells.sides(s).size(), 6U);
    EXPECT_EQ(shells.edges(s).size(), 12U);
    EXPECT_EQ(shells.vertices(s).size(), 8U);
  }
  const auto volume = [&](ShellId s, ShellSolid side) {
    return solid(mesh_of_shell(shells, s, side).mesh).volume();
  };
  EXPECT_EQ(volume(of_body[0], ShellSolid::Volume), Rational(729)) << "the outer one is the first";
  EXPECT_EQ(volume(of_body[1], ShellSolid::Other), Rational(8));
  EXPECT_EQ(volume(of_body[2], ShellSolid::Other), Rational(27));
  EXPECT_EQ(volume(of_body[1], ShellSolid::Volume), Rational(0));
  const Nef3 hole = set_of_shell(cheese, shells, of_body[2], ShellMarks::All);
  EXPECT_TRUE(hole == cube(5, 8).boundary());
  EXPECT_TRUE(hole.with_bounded_volumes() == cube(5, 8));
  EXPECT_TRUE(set_of_shell(cheese, shells, of_body[2], ShellMarks::Own).is_empty());
  EXPECT_TRUE(set_of_shell(cheese, shells, of_body[0], ShellMarks::Own) == cube(0, 9).boundary());
}

/// A void of which one corner touches the outer boundary is on the same shell, seen from the solid,
/// though its volume is another one.
TEST(SpaceShells, AreJoinedAtAVertexWhereTheVolumeGoesOn) {
  const Nef3 set =
      cube(0, 9) - solid(testing::tetrahedron_mesh({0, 4, 4}, {4, 3, 4}, {4, 5, 3}, {4, 5, 5}));
  const Nef3 other = cube(0, 9) - solid(testing::reversed(testing::tetrahedron_mesh(
                                      {0, 4, 4}, {4, 3, 4}, {4, 5, 3}, {4, 5, 5})));
  const Nef3& touching = set.counts().volumes == 3 ? set : other;  // whichever is not inside out
  ASSERT_EQ(touching.counts().volumes, 3U);
  const SpaceShells shells(touching.complex());
  const VolumeId body = touching.locate(Point3{8, 8, 8}).item.volume();
  ASSERT_EQ(shells.shells_of(body).size(), 1U);
  EXPECT_EQ(shells.sides(shells.shells_of(body)[0]).size(), 10U);
  EXPECT_EQ(shells.vertices(shells.shells_of(body)[0]).size(), 12U);
  EXPECT_EQ(shells.size(), 3U);
}

TEST(SpaceShells, OfLooseParts) {
  const std::array<Point3, 4> corners{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}};
  const Nef3 set =
      Nef3::facet(corners) + Nef3::segment({1, 1, 0}, {1, 1, 3}) + Nef3::point({9, 9, 9});
  const SpaceShells shells(set.complex());
  ASSERT_EQ(shells.size(), 2U);
  const auto all = shells.shells_of(VolumeId(0));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(shells.sides(all[0]).size(), 2U) << "both sides of the square";
  EXPECT_EQ(shells.edges(all[0]).size(), 5U);
  EXPECT_EQ(shells.vertices(all[0]).size(), 6U);
  EXPECT_EQ(shells.vertices(all[1]).size(), 1U);
  EXPECT_TRUE(shells.sides(all[1]).empty());
}

/// Every side is on one shell, of its volume; the shells add up to the boundary, and neighbours
/// around an edge in one volume are on one shell.
TEST(SpaceShells, ArePartsOfTheBoundary) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    testing::Dice dice(seed);
    Nef3 set = solid(voxel_mesh(testing::random_voxels(dice, {3, 3, 3}, 5)));
    if (seed % 2 == 1) set ^= Nef3::half_space({1, 2, 3, -7}, Boundary::Open);
    const SpaceComplex& c = set.complex();
    const SpaceShells shells(c);
    std::vector<std::array<std::uint32_t, 2>> shell_of(c.facet_count(), {kNone, kNone});
    std::size_t sides = 0;
    Nef3 boundary;
    for (std::uint32_t s = 0; s < shells.size(); ++s) {
      for (const FacetSide& side : shells.sides(ShellId(s))) {
        const std::size_t k = side.is_reversed ? 0 : 1;
        EXPECT_EQ(c.facet_volume[side.facet.value()][k], shells.volume(ShellId(s)));
        shell_of[side.facet.value()][k] = s;
        ++sides;
      }
      boundary += set_of_shell(set, shells, ShellId(s), ShellMarks::All);
    }
    EXPECT_EQ(sides, 2 * set.counts().facets);
    EXPECT_TRUE(boundary == set.boundary());
    for (std::uint32_t u = 0; u < c.use_count(); ++u) {
      if (c.edge_mark[c.use_halfedge[u].value() / 2] == kBeyond) continue;
      const UseId next = c.use_radial[u];
      const std::size_t k = SpaceComplex::is_reverse(c.use_halfedge[u]) ? 1 : 0;
      const std::size_t l = SpaceComplex::is_reverse(c.use_halfedge[next.value()]) ? 0 : 1;
      EXPECT_EQ(shell_of[c.use_facet[u].value()][k],
                shell_of[c.use_facet[next.value()].value()][l]);
    }
  }
}

/// Counts what it is shown; knows of no edges.
struct CountSidesAndVertices {
  void operator()(const FacetSide&) { ++sides; }
  void operator()(VertexId) { ++vertices; }
  std::size_t sides = 0, vertices = 0;
};

TEST(SpaceShells, ShowTheirItemsToAVisitor) {
  const Nef3 hollow = cube(0, 9) - cube(1, 3);
  const SpaceShells shells(hollow.complex());
  ASSERT_EQ(shells.size(), 4U);
  for (std::uint32_t s = 0; s < shells.size(); ++s) {
    CountSidesAndVertices count;
    shells.visit(ShellId(s), count);
    EXPECT_EQ(count.sides, 6U);
    EXPECT_EQ(count.vertices, 8U);
    std::vector<EdgeId> edges;
    shells.visit(ShellId(s), [&](EdgeId e) { edges.push_back(e); });
    EXPECT_TRUE(std::ranges::equal(edges, shells.edges(ShellId(s))));
  }
}

TEST(SpaceShells, ThatReachInfinityHaveNoMesh) {
  const Nef3 h = Nef3::half_space({0, 0, 1, 0}, Boundary::Closed);
  const SpaceShells shells(h.complex());
  ASSERT_EQ(shells.size(), 2U);
  EXPECT_EQ(shells.sides(ShellId(0)).size(), 1U);
  EXPECT_THROW(mesh_of_shell(shells, ShellId(0), ShellSolid::Volume), Error);
  EXPECT_TRUE(set_of_shell(h, shells, ShellId(0), ShellMarks::Own) == h.boundary());
  EXPECT_TRUE(h.with_bounded_volumes() == h);
}

}  // namespace
}  // namespace plumb::space_shells_test
