// Which items the audit says to meet where they must not: segments in space held against exact
// intersection, and one item in the way of each kind.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "generate/space_scenes.h"
#include "plumb/space/audit/audit_parts.h"
#include "plumb/testing/dice.h"

namespace plumb::audit_meeting_test {

using testing::cross;
using testing::Dice;
using testing::dot;
using testing::rational_point;
using testing::SpaceScene;

std::string complaint(const SpaceScene& scene) {
  Context context;
  const SpaceComplex c = testing::complex_without_volumes(scene);
  const std::vector<std::uint8_t> no_fans(c.vertex_count(), 0);
  const auto flaw = audit_meeting(c, no_fans, context);
  return flaw ? std::string(flaw->invariant) : "";
}

/// Have the closed segments a b and c d a common point?
bool meet(const RationalPoint3& a, const RationalPoint3& b, const RationalPoint3& c,
          const RationalPoint3& d) {
  const RationalPoint3 u = b - a, v = d - c, w = c - a, n = cross(u, v);
  const Rational square = dot(n, n);
  if (square == 0) {
    const RationalPoint3 off = cross(w, u);
    if (dot(off, off) != 0) return false;
    return dot(c - a, c - b) <= 0 || dot(d - a, d - b) <= 0 || dot(a - c, a - d) <= 0;
  }
  if (dot(n, w) != 0) return false;
  const Rational s = dot(cross(w, v), n), t = dot(cross(w, u), n);
  return s >= 0 && s <= square && t >= 0 && t <= square;
}

TEST(AuditMeeting, OfSegmentsAsTheirIntersection) {
  Dice dice(71);
  int crossing = 0, apart = 0;
  for (int round = 0; round < 500; ++round) {
    SpaceScene scene;
    std::vector<RationalPoint3> p;
    while (p.size() < 4) {
      const auto c = [&](std::int64_t most) { return static_cast<int>(dice.between(0, most)); };
      const int x = c(3), y = c(3), z = c(round % 2);
      p.push_back(rational_point(x, y, z));
      for (std::size_t i = 0; i + 1 < p.size(); ++i) {
        if (p[i] == p.back()) {
          p.pop_back();
          break;
        }
      }
    }
    scene.add_free_edge(p[0], p[1]);
    scene.add_free_edge(p[2], p[3]);
    const bool expected = meet(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(!complaint(scene).empty(), expected) << round;
    ++(expected ? crossing : apart);
  }
  EXPECT_GT(crossing, 50);
  EXPECT_GT(apart, 50);
}

SpaceScene box_with_antenna() {
  SpaceScene scene;
  testing::add_box(scene, rational_point(0, 0, 0), rational_point(4, 4, 4));
  scene.add_free_edge(rational_point(0, 0, 4), rational_point(0, 0, 8));
  return scene;
}

TEST(AuditMeeting, NamesWhatIsInTheWay) {
  EXPECT_EQ(complaint(box_with_antenna()), "");
  const auto with_point = [](int x, int y, int z) {
    SpaceScene scene = box_with_antenna();
    scene.add_point(rational_point(x, y, z));
    return complaint(scene);
  };
  EXPECT_EQ(with_point(0, 0, 6), "no vertex lies inside an edge");
  EXPECT_EQ(with_point(4, 4, 1), "no vertex lies inside an edge");
  EXPECT_EQ(with_point(4, 1, 1), "no vertex lies inside a facet unlisted");
  EXPECT_EQ(with_point(5, 1, 1), "");
  EXPECT_EQ(with_point(1, 1, 1), "");
  EXPECT_EQ(with_point(0, 0, 9), "");
  const auto with_edge = [](const RationalPoint3& a, const RationalPoint3& b) {
    SpaceScene scene = box_with_antenna();
    scene.add_free_edge(a, b);
    return complaint(scene);
  };
  EXPECT_EQ(with_edge(rational_point(-1, 0, 6), rational_point(1, 0, 6)), "edges do not cross");
  EXPECT_EQ(with_edge(rational_point(1, 1, 1), rational_point(1, 1, 5)),
            "no edge passes through a facet");
  EXPECT_EQ(with_edge(rational_point(1, 1, 1), rational_point(1, 1, 3)), "");
}

// A vertex inside a facet is fine where the facet lists it.
TEST(AuditMeeting, TakesListedVertices) {
  SpaceScene scene;
  testing::add_box(scene, rational_point(0, 0, 0), rational_point(4, 4, 4));
  const std::uint32_t v = scene.add_point(rational_point(0, 1, 2));
  EXPECT_NE(complaint(scene), "");
  for (testing::SceneFacet& f : scene.facets) {
    bool is_left = true;
    for (const std::uint32_t corner : f.cycles[0]) is_left &= scene.points[corner].x == 0;
    if (is_left) f.inner.push_back(v);
  }
  EXPECT_EQ(complaint(scene), "");
}

}  // namespace plumb::audit_meeting_test
