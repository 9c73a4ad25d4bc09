// Which plane cuts a piece: candidates against exact sides of all reflex edges, and the fixed plane
// of each edge against the tips that it must not touch.
#include "plumb/convex/part/choose_plane.h"

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

namespace plumb::choose_plane_test {

Nef3 box(Point3 low, Point3 high) { return testing::solid(testing::box_mesh(low, high)); }

/// A surface, all its faces, and one half of each reflex edge.
struct Scene : testing::CutScene {
  using CutScene::CutScene;
  std::array<Sign, 2> sides(HalfedgeId h, PlaneId p) const {
    const auto at = [&](VertexId v) { return side(surface.points(), surface.point[v.value()], p); };
    return {at(surface.half(h).origin), at(surface.target(h))};
  }
  std::array<PlaneId, 2> faces_at(HalfedgeId h) const {
    return {surface.plane_of(h).plane(), surface.plane_of(surface.half(h).twin).plane()};
  }
};

std::vector<Nef3> solids() {
  std::vector<Nef3> all = {box({0, 0, 0}, {4, 4, 4}) - box({2, -1, 2}, {5, 5, 5}),
                           box({0, 0, 0}, {9, 9, 3}) - box({3, 3, -1}, {6, 6, 4}),
                           testing::solid(testing::comb_block(2, 2)),
                           testing::solid(testing::star_prism(5)),
                           testing::solid(testing::saddle_block(2))};
  testing::Dice dice(1);
  for (int i = 0; i < 4; ++i) {
    all.push_back(testing::solid(testing::voxel_mesh(testing::random_terrain(dice, 3, 2, 3))));
  }
  return all;
}

/// A combination of primitive rows, whatever multiples the table has.
TEST(ChoosePlane, PencilsAreOfPrimitiveRows) {
  PlaneTable planes;
  const PlaneId p = planes.intern(6.0, 0.0, 0.0, -12.0).plane();  // x = 2
  const PlaneId q = planes.intern(0.0, 10.0, 5.0, 5.0).plane();   // 2 y + z + 1 = 0
  for (int a = -2; a <= 2; ++a) {
    for (int b = -2; b <= 2; ++b) {
      const PlaneId found = intern_pencil(planes, p, q, {a, b});
      EXPECT_EQ(found.is_valid(), a != 0 || b != 0);
      if (!found.is_valid()) continue;
      const double x = a, y = 2 * b, z = b, d = b - 2 * a;
      EXPECT_EQ(found, planes.intern(x, y, z, d).plane());
    }
  }
}

/// The seed lies in the plane, and others are counted as exact signs count them.
TEST(ChoosePlane, CandidatesCountEdgesRightly) {
  std::size_t by_faces = 0, by_points = 0;
  for (const Nef3& set : solids()) {
    Scene s(set);
    CutChooser chooser(s.surface);
    const auto found = chooser.candidates(s.faces, s.reflex);
    ASSERT_GT(found.size(), 2U);
    const std::vector<CutCandidate> all(found.begin(), found.end());
    const std::size_t judged = all.size() - 2;
    // The last two are the planes of the faces of one edge: they always do.
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(all[judged + i].plane, s.faces_at(s.reflex.front())[i]);
      EXPECT_EQ(all[judged + i].seed, s.reflex.front());
    }
    for (std::size_t i = 0; i < judged; ++i) {
      const CutCandidate& each = all[i];
      EXPECT_GE(each.score, all[0].score);
      const PlaneId plane = chooser.intern(each);
      ASSERT_TRUE(plane.is_valid());
      ++(each.plane.is_valid() ? by_faces : by_points);
      EXPECT_EQ(s.sides(each.seed, plane), (std::array{Sign::Zero, Sign::Zero}));
      if (each.through.is_valid()) {
        EXPECT_EQ(side(s.surface.points(), SpacePoint(each.through), plane), Sign::Zero);
      }
      int crossed = 0, resolved = 0, above = 0, below = 0;
      for (const HalfedgeId h : s.reflex) {
        const auto [a, b] = s.sides(h, plane);
        crossed += a * b == Sign::Negative ? 1 : 0;
        resolved += a == Sign::Zero && b == Sign::Zero ? 1 : 0;
        const int sum = static_cast<int>(a) + static_cast<int>(b);
        above += sum > 0 ? 1 : 0;
        below += sum < 0 ? 1 : 0;
      }
      EXPECT_EQ(each.crossed, crossed);
      EXPECT_EQ(each.resolved, resolved);
      EXPECT_EQ(each.lesser, std::min(above, below));
      EXPECT_TRUE(each.sheets == 1 || each.sheets == 2);
    }
  }
  EXPECT_GT(by_faces, 10U);
  EXPECT_GT(by_points, 3U);
}

/// Through each edge, of the pencil of its faces; a face's own plane where no tip is in the way.
TEST(ChoosePlane, EveryReflexEdgeHasAPlaneThroughIt) {
  for (const Nef3& set : solids()) {
    Scene s(set);
    const FixedPlanes planes(s.surface, s.reflex, unlimited_context());
    for (const HalfedgeId h : s.reflex) {
      const PlaneId plane = planes.plane(s.surface.half(h).edge);
      ASSERT_TRUE(plane.is_valid());
      EXPECT_EQ(s.sides(h, plane), (std::array{Sign::Zero, Sign::Zero}));
    }
  }
}

/// A pit in a block, from its tip to a triangle outside.
Nef3 pit_to(Point3 tip, Point3 a, Point3 b, Point3 c) {
  return testing::solid(
             testing::make_mesh({tip, a, b, c}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
             WindingRule::NonZero)
      .interior();
}

/// A step whose edge runs along y at x = 4, z = 4, and tips of pits in either face's plane or both.
TEST(ChoosePlane, PlanesPassTipsThatTouchThem) {
  const Nef3 step = box({0, 0, 0}, {8, 12, 8}) - box({4, -1, 4}, {9, 8, 9}).interior();
  const Nef3 above = pit_to({2, 2, 4}, {1, 1, 9}, {3, 1, 9}, {2, 3, 9});
  const Nef3 beside = pit_to({4, 5, 2}, {9, 4, 1}, {9, 6, 1}, {9, 5, 3});
  for (const bool has_above : {false, true}) {
    for (const bool has_beside : {false, true}) {
      Nef3 set = step;
      if (has_above) set = set - above;
      if (has_beside) set = set - beside;
      Scene s(set);
      const FixedPlanes planes(s.surface, s.reflex, unlimited_context());
      const PlaneId level = s.surface.tables->planes.intern(0.0, 0.0, 1.0, -4.0).plane();
      const PlaneId upright = s.surface.tables->planes.intern(1.0, 0.0, 0.0, -4.0).plane();
      std::size_t seen = 0;
      for (const HalfedgeId h : s.reflex) {
        const std::array<PlaneId, 2> faces = s.faces_at(h);
        const bool is_step = (faces[0] == level && faces[1] == upright) ||
                             (faces[1] == level && faces[0] == upright);
        if (!is_step) continue;
        ++seen;
        const PlaneId plane = planes.plane(s.surface.half(h).edge);
        if (has_above) {
          EXPECT_NE(plane, level);
        }
        if (has_beside) {
          EXPECT_NE(plane, upright);
        }
        EXPECT_EQ(plane == level || plane == upright, !(has_above && has_beside));
      }
      EXPECT_EQ(seen, 1U);
    }
  }
}

}  // namespace plumb::choose_plane_test
