// Facets of one plane merged as they lie in the arrays, against the same by sphere maps.
#include "plumb/space/boolean/simplify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/space/canonical.h"
#include "plumb/space/mesh/mesh_arrangement.h"
#include "plumb/space/nef3.h"
#include "plumb/space/query/volumes.h"
#include "plumb/space/set/compare_complexes.h"
#include "plumb/space/space_audit.h"
#include "plumb/testing/dice.h"
#include "space/complex_links.h"

namespace plumb::testing::simplify_test {
namespace {

/// Closed meshes as solids, others as surfaces; facets and edges as they are in the mesh.
SpaceComplex subdivided(const PolygonMesh& mesh, bool surface = false) {
  Context context;
  MeshOptions options;
  options.surface = surface;
  MeshComplex made = complex_of_mesh(mesh, options, context);
  arrange(made, context);
  SpaceComplex& c = made.complex;
  if (!surface) {
    const std::vector<std::int32_t> winding = winding_numbers(c, facet_jumps(made));
    for (std::size_t v = 0; v < winding.size(); ++v) c.volume_mark[v] = winding[v] != 0 ? 1 : 0;
  }
  c.facet_mark.assign(c.facet_count(), 1);
  c.edge_mark.assign(c.edge_count(), 1);
  c.vertex_mark.assign(c.vertex_count(), 1);
  return std::move(c);
}

/// One item in so many gets the other mark. Facets must not go, so those of a surface stay marked.
void change_marks(SpaceComplex& c, Dice& dice, std::uint32_t one_in, bool surface) {
  const auto change = [&](std::vector<Mark>& marks) {
    for (Mark& m : marks) {
      if (dice.below(one_in) == 0) m = static_cast<Mark>(1 - m);
    }
  };
  if (!surface) change(c.facet_mark);
  change(c.edge_mark);
  change(c.vertex_mark);
}

bool is_same_set(const SpaceComplex& a, const SpaceComplex& b) {
  Context context;
  return is_identical(canonical(Nef3::from_minimal_unchecked(a), context).complex(),
                      canonical(Nef3::from_minimal_unchecked(b), context).complex());
}

/// Planes of facets and the ids they carry.
std::vector<std::pair<PlaneId, std::uint32_t>> names(const SpaceComplex& c) {
  std::vector<std::pair<PlaneId, std::uint32_t>> all;
  for (std::size_t f = 0; f < c.facet_count(); ++f) {
    all.emplace_back(c.facet_plane[f], c.facet_origin[f]);
  }
  std::ranges::sort(all);
  return all;
}

void expect_as_by_maps(const SpaceComplex& c, const std::string& what) {
  Context context;
  CoplanarMerge merge(c, context);
  const SpaceComplex merged = merge.is_needed() ? merge.run(context) : c;
  const auto flaw = audit(merged, AuditForm::Minimal);
  ASSERT_FALSE(flaw) << what << ": " << flaw->invariant << ": " << flaw->place;
  const SpaceComplex other = simplified_by_maps(c, context);
  EXPECT_EQ(merged.vertex_count(), other.vertex_count()) << what;
  EXPECT_EQ(merged.edge_count(), other.edge_count()) << what;
  EXPECT_EQ(merged.facet_count(), other.facet_count()) << what;
  EXPECT_TRUE(is_same_set(merged, other)) << what;
  EXPECT_EQ(names(merged), names(other)) << what;
}

/// A tetrahedron above or below the point that touches it with a corner.
PolygonMesh cone_at(const Point3& apex, double height) {
  const PolygonMesh cone = tetrahedron_mesh(apex, {apex.x + 0.3, apex.y, apex.z + height},
                                            {apex.x - 0.2, apex.y + 0.3, apex.z + height},
                                            {apex.x - 0.2, apex.y - 0.3, apex.z + height});
  return height < 0 ? reversed(cone) : cone;
}

TEST(CoplanarMerge, OfVoxelsIsAsByMaps) {
  Dice dice(71);
  for (int i = 0; i < 60; ++i) {
    const VoxelGrid grid = random_voxels(dice, {3, 3, 1 + i % 3}, 2 + i % 7);
    PolygonMesh mesh = voxel_mesh(grid);
    if (i % 2 == 0) mesh = fanned(mesh);
    SpaceComplex c = subdivided(mesh);
    expect_as_by_maps(c, "voxels " + std::to_string(i));
    for (const std::uint32_t one_in : {40U, 8U, 2U}) {
      change_marks(c, dice, one_in, false);
      expect_as_by_maps(c, "voxels with marks " + std::to_string(i));
    }
  }
}

/// Where a cone touches a flat region, edges leave a vertex inside a facet.
TEST(CoplanarMerge, LeavesConesOnFlatRegions) {
  Dice dice(72);
  VoxelGrid grid({3, 3, 1});
  grid.is_full.assign(9, 1);
  for (int i = 0; i < 12; ++i) {
    PolygonMesh mesh = fanned(voxel_mesh(grid));
    mesh = joined(std::move(mesh), cone_at({1.0 + i % 2, 1.0 + i / 2 % 2, 1}, 0.5));
    if (i % 3 > 0) mesh = joined(std::move(mesh), cone_at({1.0 + i % 2, 1.0, 0}, -0.5));
    SpaceComplex c = subdivided(mesh);
    expect_as_by_maps(c, "cones " + std::to_string(i));
    if (i == 0) {
      Context context;
      CoplanarMerge merge(c, context);
      const SpaceComplex merged = merge.run(context);
      EXPECT_EQ(merged.vertex_count(), 8U + 4U);
      EXPECT_EQ(merged.facet_count(), 6U + 4U);
      EXPECT_EQ(merged.inner.size(), 1U);
    }
    change_marks(c, dice, 6, false);
    expect_as_by_maps(c, "cones with marks " + std::to_string(i));
  }
}

/// Sheets have borders with one facet, and holes.
TEST(CoplanarMerge, OfSurfacesIsAsByMaps) {
  Dice dice(73);
  for (int i = 0; i < 60; ++i) {
    PolygonMesh mesh;
    for (int y = 0; y <= 4; ++y) {
      for (int x = 0; x <= 4; ++x)
        mesh.points.push_back({x / 1.0, y / 1.0, i % 3 == 0 && x > 2 ? 1.0 : 0.0});
    }
    for (std::uint32_t y = 0; y < 4; ++y) {
      for (std::uint32_t x = 0; x < 4; ++x) {
        const std::uint32_t a = 5 * y + x;
        const std::array<std::uint32_t, 4> corners{a, a + 1, a + 6, a + 5};
        if (dice.below(4) != 0) mesh.add_face(corners);
      }
    }
    if (mesh.face_count() == 0) continue;
    SpaceComplex c = subdivided(mesh, true);
    expect_as_by_maps(c, "surface " + std::to_string(i));
    for (const std::uint32_t one_in : {30U, 5U}) {
      change_marks(c, dice, one_in, true);
      expect_as_by_maps(c, "surface with marks " + std::to_string(i));
    }
  }
}

SpaceComplex solid_of(const PolygonMesh& mesh, WindingRule rule, bool joins) {
  Context context;
  MeshOptions options;
  options.joins_coplanar = joins;
  MeshComplex made = complex_of_mesh(mesh, options, context);
  const SpaceComplex& c = made.complex;
  EXPECT_EQ(broken_link(c), "");
  EXPECT_EQ(made.jump.size(), c.facet_count());
  EXPECT_EQ(made.component.size(), c.facet_count());
  EXPECT_EQ(made.has_fan.size(), c.vertex_count());
  turn_inside_out(made, context);
  return Nef3::from_mesh_complex(std::move(made), rule, context).complex();
}

/// Neighbours in one plane may be joined before there are volumes: sets are the same, in the same
/// arrays but for their edges' planes.
void expect_same_if_joined_first(const PolygonMesh& mesh, const std::string& what) {
  for (const WindingRule rule :
       {WindingRule::NonZero, WindingRule::EvenOdd, WindingRule::Positive}) {
    const SpaceComplex early = solid_of(mesh, rule, true), late = solid_of(mesh, rule, false);
    const auto flaw = audit(early, AuditForm::Minimal);
    ASSERT_FALSE(flaw) << what << ": " << flaw->invariant << ": " << flaw->place;
    EXPECT_TRUE(is_same_set(early, late)) << what;
    EXPECT_EQ(names(early), names(late)) << what;
    EXPECT_EQ(early.facet_volume, late.facet_volume) << what;
    EXPECT_EQ(early.use_next, late.use_next) << what;
    EXPECT_EQ(early.star, late.star) << what;
    EXPECT_EQ(early.inner, late.inner) << what;
  }
}

TEST(CoplanarMerge, BeforeThereAreVolumesIsAsAfter) {
  Dice dice(74);
  for (int i = 0; i < 40; ++i) {
    const VoxelGrid grid = random_voxels(dice, {3, 3, 1 + i % 3}, 2 + i % 7);
    PolygonMesh mesh = voxel_mesh(grid);
    expect_same_if_joined_first(mesh, "voxels " + std::to_string(i));
    mesh = fanned(mesh);
    expect_same_if_joined_first(mesh, "triangles of voxels " + std::to_string(i));
    if (i % 4 == 0) expect_same_if_joined_first(reversed(mesh), "reversed");
    if (i % 4 == 1) expect_same_if_joined_first(joined(mesh, mesh), "twice");
    if (i % 4 == 2)
      expect_same_if_joined_first(joined(mesh, moved(mesh, {0.5, 0.25, 0})), "crossing");
    if (i % 4 == 3) {
      mesh = joined(mesh, cone_at({0.5, 0.5, 0.5}, 0.25));
      expect_same_if_joined_first(mesh, "with a tetrahedron inside");
      expect_same_if_joined_first(joined(mesh, cone_at({7, 0, 0}, 1)), "apart");
    }
  }
  PolygonMesh touched = fanned(box_mesh({0, 0, 0}, {2, 2, 1}));
  touched = joined(touched, moved(touched, {2, 0, 0}));
  expect_same_if_joined_first(touched, "boxes with a common face");
  expect_same_if_joined_first(grid_cube_mesh(4, {0, 0, 0}), "a cube of a grid");
}

/// A mesh whose faces are joined has no planes but those of its faces; one that crosses itself has
/// one for each edge.
TEST(CoplanarMerge, SparesThePlanesOfEdgesThatGo) {
  Context context;
  MeshOptions options;
  options.joins_coplanar = true;
  const PolygonMesh cube = grid_cube_mesh(4, {0, 0, 0});
  const MeshComplex made = complex_of_mesh(cube, options, context);
  EXPECT_EQ(made.complex.facet_count(), 6U);
  EXPECT_EQ(made.complex.edge_count(), 12U);
  EXPECT_EQ(made.complex.planes().size(), 6U);  // three of them are the axes'
  const MeshComplex crossing =
      complex_of_mesh(joined(cube, moved(cube, {0.5, 0.5, 0.5})), options, context);
  EXPECT_EQ(crossing.complex.facet_count(), 2 * cube.face_count());
  EXPECT_EQ(broken_link(crossing.complex), "");
}

/// An inner piece gives a facet no name.
TEST(CoplanarMerge, NamesFacetsByTheirCorners) {
  PolygonMesh mesh;
  for (int y = 0; y <= 3; ++y) {
    for (int x = 0; x <= 3; ++x) mesh.points.push_back({x / 1.0, y / 1.0, 0});
  }
  for (const std::uint32_t a :
       {5U, 4U, 6U, 1U, 9U, 0U, 2U, 8U, 10U}) {  // the middle, sides, corners
    const std::array<std::uint32_t, 4> corners{a, a + 1, a + 5, a + 4};
    mesh.add_face(corners);
  }
  Context context;
  const SpaceComplex c = subdivided(mesh, true);
  CoplanarMerge merge(c, context);
  const SpaceComplex merged = merge.run(context);
  ASSERT_EQ(merged.facet_count(), 1U);
  EXPECT_EQ(merged.facet_origin[0], 5U);
}

}  // namespace
}  // namespace plumb::testing::simplify_test
