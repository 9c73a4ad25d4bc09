// Checks that the audit accepts maps of random sets and names the invariant that each damage to a
// map breaks, wherever it is.
#include "plumb/sphere/sphere_audit.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "plumb/sphere/nef_sphere.h"
#include "plumb/testing/dice.h"

namespace plumb::sphere_audit_test {

using testing::Dice;

const SphereVector kZ{0, 0, 1};

// A map of everything: islands, a loop, isolated points.
SphereMap sample_map(PlaneTable& planes) {
  const std::vector<SphereVector> corners{{0.5, 0, 1}, {-0.5, 0.5, 1}, {-0.5, -0.5, 1}};
  const NefSphere set = NefSphere::polygon(corners, Boundary::Closed) + NefSphere::circle(kZ) +
                        NefSphere::points(std::vector{kZ.opposite(), SphereVector{1, 1, 1}});
  planes = PlaneTable(set.planes());
  return set.map();
}

struct Damage {
  const char* invariant;
  std::function<void(SphereMap&)> make;
};

TEST(SphereAudit, NamesTheInvariantBroken) {
  PlaneTable planes;
  const SphereMap sound = sample_map(planes);
  ASSERT_FALSE(audit(planes, sound, AuditForm::Minimal).has_value());
  std::uint32_t island = 0;  // an arc of the triangle
  while (sound.is_loop(island)) ++island;
  std::uint32_t lone = 0;
  while (sound.first_out[lone] != kNone) ++lone;
  const std::uint32_t other_face = (sound.point_face[lone] + 1) % 3;
  const Damage damages[] = {
      {"arrays of points have one size", [](SphereMap& m) { m.point_mark.pop_back(); }},
      {"marks are 0, 1 or beyond", [](SphereMap& m) { m.face_mark[0] = 3; }},
      {"a point has a half-arc there is, or a face there is",
       [&](SphereMap& m) { m.point_face[lone] = 17; }},
      {"a direction is of two planes that cross",
       [&](SphereMap& m) { m.direction[lone].q = m.direction[lone].p; }},
      {"half-arcs follow each other", [&](SphereMap& m) { m.next[2 * island] = 2 * island; }},
      {"a boundary has one face",
       [&](SphereMap& m) { m.next[2 * island] = SphereMap::twin(2 * island); }},
      {"a point lies on the circles of its arcs",
       [&](SphereMap& m) { m.direction[m.origin[2 * island]] = m.direction[lone]; }},
      {"points are different",
       [&](SphereMap& m) {
         for (std::uint32_t v = 0; v < m.point_count(); ++v) {
           if (v != lone && m.first_out[v] == kNone) m.direction[v] = m.direction[lone];
         }
       }},
      {"boundaries of one face name it", [&](SphereMap& m) { m.point_face[lone] = other_face; }},
      {"the map is minimal",
       [&](SphereMap& m) { m.point_mark[lone] = m.face_mark[m.point_face[lone]]; }},
  };
  for (const Damage& damage : damages) {
    SphereMap damaged = sound;
    damage.make(damaged);
    const auto flaw = audit(planes, damaged, AuditForm::Minimal);
    ASSERT_TRUE(flaw.has_value()) << damage.invariant;
    EXPECT_EQ(flaw->invariant, damage.invariant);
  }
}

// Whatever one number of a map is changed to, it is no sound map of the same set any more.
TEST(SphereAudit, FindsEveryChangedLink) {
  PlaneTable planes;
  const SphereMap sound = sample_map(planes);
  const auto expect_flaw = [&](auto member, const char* name) {
    for (std::size_t i = 0; i < (sound.*member).size(); ++i) {
      for (std::uint32_t value = 0; value < 12; ++value) {
        if ((sound.*member)[i] == value) continue;
        SphereMap damaged = sound;
        (damaged.*member)[i] = value;
        const bool is_another_start = member == &SphereMap::first_out &&
                                      sound.first_out[i] != kNone && value < sound.origin.size() &&
                                      sound.origin[value] == i;
        EXPECT_EQ(audit(planes, damaged, AuditForm::Minimal).has_value(), !is_another_start)
            << name << '[' << i << "] = " << value;
      }
    }
  };
  expect_flaw(&SphereMap::origin, "origin");
  expect_flaw(&SphereMap::next, "next");
  expect_flaw(&SphereMap::face, "face");
  expect_flaw(&SphereMap::first_out, "first_out");
  expect_flaw(&SphereMap::point_face, "point_face");
}

/// Two loops cross, and a face without a boundary is none.
TEST(SphereAudit, RefusesASecondLoopAndAFaceTooMany) {
  PlaneTable planes;
  const SphereMap sound = sample_map(planes);
  SphereMap loops = NefSphere::circle(kZ).map();
  const PlaneTable two = [&] {
    PlaneTable table(NefSphere::circle(kZ).planes());
    loops.circle.push_back(table.intern(1.0, 0.0, 0.0, 0.0).plane());
    return table;
  }();
  loops.arc_mark.push_back(1);
  for (auto* ids : {&loops.origin, &loops.next, &loops.face}) ids->resize(4);
  loops.origin = {kNone, kNone, kNone, kNone};
  loops.next = {0, 1, 2, 3};
  loops.face = {0, 1, 0, 1};
  EXPECT_TRUE(audit(two, loops, AuditForm::Any).has_value());

  SphereMap faces = sound;
  faces.face_mark.push_back(0);
  const auto flaw = audit(planes, faces, AuditForm::Any);
  ASSERT_TRUE(flaw.has_value());
  EXPECT_EQ(flaw->invariant, std::string("a face has a boundary"));
}

/// A map that is not minimal is sound nevertheless.
TEST(SphereAudit, AsksForMinimalMapsOnlyIfToldTo) {
  Dice dice(1);
  for (int round = 0; round < 40; ++round) {
    NefSphere set;
    for (std::uint32_t leaves = 1 + dice.below(5); leaves > 0; --leaves) {
      const SphereVector n(static_cast<double>(dice.between(-2, 2)),
                           static_cast<double>(dice.between(-2, 2)), 1.0);
      set ^= dice.below(3) == 0 ? NefSphere::circle(n) : NefSphere::half_sphere(n, Boundary::Open);
    }
    EXPECT_FALSE(audit(set.planes(), set.map(), AuditForm::Minimal).has_value());
    SphereMap map = set.map();
    for (auto* marks : {&map.point_mark, &map.arc_mark, &map.face_mark}) {
      for (Mark& m : *marks) m = 1;
    }
    EXPECT_FALSE(audit(set.planes(), map, AuditForm::Any).has_value());
    EXPECT_EQ(audit(set.planes(), map, AuditForm::Minimal).has_value(), map.arc_count() > 0);
  }
}

}  // namespace plumb::sphere_audit_test
