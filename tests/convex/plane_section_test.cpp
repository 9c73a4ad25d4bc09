// The part of a plane section that a reflex edge bounds: closed cycles with the inside of the solid
// to their left, of a known area.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "convex/cut_scene.h"
#include "generate/mesh_solid.h"
#include "generate/meshes.h"
#include "generate/voxel_mesh.h"
#include "plumb/convex/part/surface_cut.h"
#include "plumb/predicates/point3_signs.h"
#include "plumb/space/complex/space_tables.h"
#include "plumb/testing/dice.h"

namespace plumb::plane_section_test {

using Vector = std::array<Rational, 3>;
using Segment = PlaneSection::Segment;

Nef3 box(Point3 low, Point3 high) { return testing::solid(testing::box_mesh(low, high)); }

Rational dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

struct Scene : testing::CutScene {
  using CutScene::CutScene;
  Vector at(VertexId v) const {
    const RationalPoint3 p = exact(surface.points(), surface.point[v.value()]);
    return {p.x, p.y, p.z};
  }
  Vector normal(PlaneId p) const {
    const IntegerRow row = surface.planes().coefficients(p);
    return {Rational(row[0]), Rational(row[1]), Rational(row[2])};
  }
  /// Those of the faces at the edge, and all through it and a vertex of the input.
  std::vector<PlaneId> planes_through(HalfedgeId h) {
    std::vector<PlaneId> planes = {surface.plane_of(h).plane(),
                                   surface.plane_of(surface.half(h).twin).plane()};
    const SpacePoint a = surface.point[surface.half(h).origin.value()],
                     b = surface.point[surface.target(h).value()];
    for (const SpacePoint c : surface.point) {
      if (!a.is_input() || !b.is_input() || !c.is_input() || a == c || b == c) continue;
      const OrientedPlane p = surface.tables->planes.intern(a.input(), b.input(), c.input());
      if (p.is_valid()) planes.push_back(p.plane());
    }
    std::ranges::sort(planes);
    planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
    return planes;
  }
};

/// Twice the area, seen along the normal, times its length.
Rational area_of(const Scene& s, PlaneSection& section, PlaneId plane) {
  Vector sum = {0, 0, 0};
  for (const Segment& segment : section.segments()) {
    if (!section.is_selected(segment)) continue;
    const Vector turn = cross(s.at(segment.from), s.at(segment.to));
    for (std::size_t i = 0; i < 3; ++i) sum[i] += turn[i];
  }
  return dot(sum, s.normal(plane));
}

TEST(PlaneSection, AStepIsCutByEitherFace) {
  const Scene given(box({0, 0, 0}, {4, 4, 6}) - box({2, -1, 3}, {5, 5, 7}));
  ASSERT_EQ(given.reflex.size(), 1U);
  Scene s = given;
  for (const auto& [row, area] :
       {std::pair(std::array{1.0, 0.0, 0.0, -2.0}, 12), {{0, 0, 1, -3}, 8}, {{3, 0, -2, 0}, 0}}) {
    const PlaneId plane = s.surface.tables->planes.intern(row[0], row[1], row[2], row[3]).plane();
    PlaneSection section(s.surface);
    ASSERT_TRUE(section.find(s.faces, plane, s.reflex[0]));
    // The diagonal plane is 2 by 3 across and 4 long; its normal as long as its section is wide.
    const int expected = area == 0 ? 4 * 13 : area;
    const Rational length =
        row[0] != 0 && row[2] != 0 ? 1 : abs(s.normal(plane)[row[0] != 0 ? 0 : 2]);
    EXPECT_EQ(area_of(s, section, plane), 2 * expected * length);
  }
}

/// Of a plane across an axis.
Rational area_across(const Scene& s, PlaneSection& section, PlaneId plane, std::size_t axis) {
  return area_of(s, section, plane) / (2 * abs(s.normal(plane)[axis]));
}

/// Through the edges of a shaft: one part, on one side of it. Around a pillar: with a hole.
TEST(PlaneSection, OnlyThePartAtTheEdge) {
  Scene shaft(box({0, 0, 0}, {9, 9, 3}) - box({3, 3, -1}, {5, 5, 4}));
  for (const HalfedgeId h : shaft.reflex) {
    const Vector at = shaft.at(shaft.surface.half(h).origin);
    const PlaneId plane =
        shaft.surface.tables->planes.intern(1.0, 0.0, 0.0, at[0] == 3 ? -3.0 : -5.0).plane();
    PlaneSection section(shaft.surface);
    ASSERT_TRUE(section.find(shaft.faces, plane, h));
    EXPECT_EQ(area_across(shaft, section, plane, 0), at[1] == 3 ? 3 * 3 : 4 * 3);
  }
  Scene tower(box({0, 0, 0}, {9, 9, 3}) + box({3, 3, 3}, {5, 5, 6}));
  for (const HalfedgeId h : tower.reflex) {
    const PlaneId plane = tower.surface.tables->planes.intern(0.0, 0.0, 1.0, -3.0).plane();
    PlaneSection section(tower.surface);
    ASSERT_TRUE(section.find(tower.faces, plane, h));
    EXPECT_EQ(area_across(tower, section, plane, 2), 4);
  }
}

/// Segments are chained, lie in the plane and on the surface, and have the inside to their left.
TEST(PlaneSection, TheInsideIsToTheLeftOfEverySegment) {
  std::vector<Nef3> sets = {box({0, 0, 0}, {9, 9, 3}) - box({3, 3, -1}, {6, 6, 4}),
                            testing::solid(testing::comb_block(1, 2)),
                            testing::solid(testing::star_prism(4))};
  testing::Dice dice(1);
  for (int i = 0; i < 2; ++i) {
    sets.push_back(testing::solid(testing::voxel_mesh(testing::random_terrain(dice, 2, 2, 3))));
  }
  int found = 0;
  for (const Nef3& set : sets) {
    const Nef3 inside = set.interior();
    Scene s(set);
    const std::size_t vertices = s.surface.point.size();
    for (std::size_t k = 0; k < s.reflex.size(); k += 3) {
      const HalfedgeId seed = s.reflex[k];
      const std::vector<PlaneId> planes = s.planes_through(seed);
      for (std::size_t i = 0; i < planes.size(); i += 2) {
        s.surface.point.resize(vertices);
        PlaneSection section(s.surface);
        if (!section.find(s.faces, planes[i], seed)) continue;
        ++found;
        EXPECT_GT(area_of(s, section, planes[i]), 0);
        bool has_seed = false;
        for (const Segment& segment : section.segments()) {
          if (!section.is_selected(segment)) continue;
          EXPECT_EQ(section.segments()[segment.next].from, segment.to);
          EXPECT_EQ(section.segments()[segment.next].cycle, segment.cycle);
          const Vector a = s.at(segment.from), b = s.at(segment.to), way = minus(b, a);
          for (const VertexId v : {segment.from, segment.to}) {
            EXPECT_EQ(side(s.surface.points(), s.surface.point[v.value()], planes[i]), Sign::Zero);
          }
          if (segment.half.is_valid()) {
            has_seed |= segment.half == seed || segment.half == s.surface.half(seed).twin;
          }
          const Vector left = cross(s.normal(planes[i]), way);
          Rational size = 0;
          for (const Rational& x : left) size = std::max(size, x < 0 ? Rational(-x) : x);
          const Rational by = Rational(1, 1000) / size;
          const RationalPoint3 step{(a[0] + b[0]) / 2 + by * left[0],
                                    (a[1] + b[1]) / 2 + by * left[1],
                                    (a[2] + b[2]) / 2 + by * left[2]};
          EXPECT_TRUE(inside.contains(step));
        }
        EXPECT_TRUE(has_seed);
        for (std::size_t h = 0; h < s.surface.halves.size(); ++h) {
          const HalfedgeId half(h);
          const VertexId from = s.surface.half(half).origin, to = s.surface.target(half);
          const auto is_on = [&](VertexId v) {
            return side(s.surface.points(), s.surface.point[v.value()], planes[i]) == Sign::Zero;
          };
          if (!is_on(from) || !is_on(to)) continue;
          const OrientedPlane face = s.surface.plane_of(half);
          const Vector d = minus(s.at(to), s.at(from));
          const Rational turn = dot(s.normal(face.plane()), cross(s.normal(planes[i]), d));
          EXPECT_EQ(section.lean(half), sign_of(turn.sign()) * face.orientation());
        }
      }
    }
  }
  EXPECT_GT(found, 20);
}

/// A tip of a pit on the line of the edge touches every plane through it: no part is found, and the
/// tip is told.
TEST(PlaneSection, ATipThatTouchesThePartIsAPuncture) {
  const Nef3 step = box({0, 0, 0}, {8, 12, 8}) - box({4, -1, 4}, {9, 8, 9}).interior();
  const Nef3 pit =
      testing::solid(testing::make_mesh({{4, 9, 4}, {-3, 9, 10}, {-1, 8, 10}, {-1, 10, 10}},
                                        {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}),
                     WindingRule::NonZero)
          .interior();
  Scene s(step - pit);
  int punctured = 0;
  for (const HalfedgeId h : s.reflex) {
    const Vector a = s.at(s.surface.half(h).origin), b = s.at(s.surface.target(h));
    if (a[0] != 4 || a[2] != 4 || b[0] != 4 || b[2] != 4) continue;
    const PlaneId level = s.surface.tables->planes.intern(0.0, 0.0, 1.0, -4.0).plane();
    PlaneSection section(s.surface);
    EXPECT_FALSE(section.find(s.faces, level, h));
    ASSERT_TRUE(section.puncture().is_valid());
    EXPECT_EQ(s.at(section.puncture()), (Vector{4, 9, 4}));
    ++punctured;
  }
  EXPECT_EQ(punctured, 1);
}

}  // namespace plumb::plane_section_test
