// Single cuts of a surface: links of its half-edges, and pieces as sets that are disjoint, together
// the solid, with the edge that was cut no longer reflex.
#include "plumb/convex/part/surface_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "convex/cut_scene.h"
#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/complex/space_tables.h"
#include "plumb/testing/dice.h"

namespace plumb::surface_cut_test {

Nef3 box(Point3 low, Point3 high) { return testing::solid(testing::box_mesh(low, high)); }

using Scene = testing::CutScene;

/// Of all faces of the pieces: cycles of their own halves, pairs of twins between the same ends
/// within one piece, and reflex edges that are told so.
void expect_linked(const CutSurface& s, const CutPieces& pieces) {
  for (const std::vector<FaceId>& faces : pieces) {
    for (const FaceId f : faces) {
      s.for_each_half(f, [&](HalfedgeId h) {
        const CutSurface::Half& half = s.half(h);
        EXPECT_EQ(half.face, f);
        EXPECT_EQ(s.half(half.next).prev, h);
        EXPECT_EQ(s.half(half.twin).twin, h);
        EXPECT_EQ(s.half(half.twin).origin, s.target(h));
        EXPECT_EQ(half.is_reflex, s.is_reflex_at(h));
        EXPECT_EQ(side(s.points(), s.point[half.origin.value()], s.plane_of(h).plane()),
                  Sign::Zero);
        const FaceId other = s.half(half.twin).face;
        EXPECT_EQ(std::ranges::count(faces, other), 1);
      });
    }
  }
}

std::size_t reflex_halves(const CutSurface& s, const CutPieces& pieces, EdgeId edge) {
  std::size_t count = 0;
  for (const std::vector<FaceId>& faces : pieces) {
    for (const FaceId f : faces) {
      s.for_each_half(
          f, [&](HalfedgeId h) { count += s.half(h).edge == edge && s.half(h).is_reflex ? 1 : 0; });
    }
  }
  return count;
}

std::vector<Nef3> sets_of(CutSurface& s, const CutPieces& pieces, bool closed) {
  std::vector<Nef3> sets;
  for (const std::vector<FaceId>& faces : pieces) {
    sets.push_back(set_of_piece(s, faces, closed, unlimited_context()));
  }
  return sets;
}

/// A step parted by the level plane or the upright one: the lower piece comes first.
TEST(SurfaceCut, AStepBecomesTwoBoxes) {
  const Nef3 step = box({0, 0, 0}, {4, 4, 6}) - box({2, -1, 3}, {5, 5, 7}).interior();
  const std::vector<Nef3> below = {box({0, 0, 0}, {4, 4, 3}), box({0, 0, 0}, {2, 4, 6})};
  const std::vector<Nef3> above = {box({0, 0, 3}, {2, 4, 6}), box({2, 0, 0}, {4, 4, 3})};
  for (std::size_t i = 0; i < 2; ++i) {
    Scene s(step);
    ASSERT_EQ(s.reflex.size(), 1U);
    PlaneTable& planes = s.surface.tables->planes;
    const PlaneId plane = i == 0 ? planes.intern(0.0, 0.0, 1.0, -3.0).plane()
                                 : planes.intern(1.0, 0.0, 0.0, -2.0).plane();
    const CutPieces pieces = PlaneCut(s.surface).run(s.faces, plane, s.reflex[0]);
    ASSERT_EQ(pieces.size(), 2U);
    expect_linked(s.surface, pieces);
    const std::vector<Nef3> closed = sets_of(s.surface, pieces, true);
    EXPECT_TRUE(closed[0] == below[i]);
    EXPECT_TRUE(closed[1] == above[i]);
    const std::vector<Nef3> owned = sets_of(s.surface, pieces, false);
    EXPECT_TRUE((owned[0] * owned[1]).is_empty());
    EXPECT_TRUE(owned[0] + owned[1] == step);
  }
}

/// A ring is opened by its first cut, and stays one piece: with both walls on its surface.
TEST(SurfaceCut, ARingIsOpenedAndStaysOnePiece) {
  Scene s(box({0, 0, 0}, {9, 9, 3}) - box({3, 3, -1}, {6, 6, 4}));
  const HalfedgeId seed = s.reflex[0];
  const PlaneId plane = s.surface.plane_of(seed).plane();
  const std::size_t faces = s.faces.size();
  const CutPieces pieces = PlaneCut(s.surface).run(s.faces, plane, seed);
  ASSERT_EQ(pieces.size(), 1U);
  expect_linked(s.surface, pieces);
  EXPECT_TRUE(touches_itself(s.surface, pieces[0]));
  EXPECT_GE(pieces[0].size(), faces + 2);
  EXPECT_EQ(reflex_halves(s.surface, pieces, s.surface.half(seed).edge), 0U);
}

/// Planes of both faces and through vertices, at every reflex edge of solids that touch no other
/// part: open, closed and half-open.
TEST(SurfaceCut, PiecesAreDisjointAndTogetherTheSolid) {
  std::vector<Nef3> sets = {testing::solid(testing::comb_block(1, 1)),
                            testing::solid(testing::star_prism(3)).interior(),
                            box({0, 0, 0}, {4, 4, 4}) - box({1, 1, 1}, {5, 5, 5})};
  testing::Dice dice(1);
  sets.push_back(testing::solid(testing::voxel_mesh(testing::random_terrain(dice, 2, 2, 3))));
  int cuts = 0;
  for (const Nef3& set : sets) {
    const Scene given(set);
    for (std::size_t k = 0; k < given.reflex.size(); ++k) {
      const HalfedgeId seed = given.reflex[k];
      for (const bool is_twin : {false, true}) {
        Scene s = given;
        s.surface.tables = copy(*given.surface.tables);
        const HalfedgeId h = is_twin ? s.surface.half(seed).twin : seed;
        const PlaneId plane = s.surface.plane_of(h).plane();
        const CutPieces pieces = PlaneCut(s.surface).run(s.faces, plane, seed);
        if (pieces.empty()) continue;
        ++cuts;
        expect_linked(s.surface, pieces);
        EXPECT_EQ(reflex_halves(s.surface, pieces, s.surface.half(seed).edge), 0U);
        if (pieces.size() == 1) continue;
        const std::vector<Nef3> owned = sets_of(s.surface, pieces, false);
        EXPECT_FALSE(owned[0].audit() || owned[1].audit());
        EXPECT_TRUE((owned[0] * owned[1]).is_empty());
        EXPECT_TRUE(owned[0] + owned[1] == set);
      }
    }
  }
  EXPECT_GT(cuts, 10);
}

}  // namespace plumb::surface_cut_test
