// Sizes at which a quadratic step or a recursion would show, and coordinates at which doubles
// would.
#include <gtest/gtest.h>

#include "plane/checked.h"
#include "plumb/testing/map_defects.h"
#include "plumb/testing/map_families.h"

namespace plumb::testing::map_check_scale_test {
namespace {

TEST(MapCheckScale, NestedRings) {
  constexpr std::uint32_t kDepth = 100000;
  const MapReport report = checked(nest(kDepth));
  EXPECT_EQ(report.verdict, MapVerdict::Valid);
  EXPECT_EQ(report.components, kDepth);
  ASSERT_EQ(report.regions.size(), kDepth + 1U);
  // Ring i is cycle 2i; its only hole is the clockwise cycle of ring i + 1.
  for (std::uint32_t i = 0; i < kDepth; ++i) {
    const MapRegion& region = report.regions[i + 1];
    ASSERT_EQ(region.outer, 2 * i);
    ASSERT_EQ(region.holes, i + 1 == kDepth ? std::vector<std::uint32_t>{}
                                            : std::vector<std::uint32_t>{2 * i + 3});
  }
}

TEST(MapCheckScale, NestedRingsWithoutOuterCycles) {
  TestMap rings = nest(20000);
  std::erase_if(rings.cycles, [&](const Cycle& c) { return doubled_area(rings, c) < 0; });
  EXPECT_EQ(checked(rings).counts.open, 80000U);
  EXPECT_EQ(checked(rings, {OuterRule::Infer, false}).verdict, MapVerdict::Valid);
  EXPECT_EQ(checked(rings, {OuterRule::Ignore, false}).counts.nested, 19999U);
}

TEST(MapCheckScale, OneFaceOfAMillionCorners) {
  const MapReport report = checked(star(1000000, 3));
  EXPECT_EQ(report.verdict, MapVerdict::Valid);
  EXPECT_EQ(report.edges, 1000000U);
  EXPECT_EQ(report.regions.size(), 2U);
}

TEST(MapCheckScale, CombOfLongEdges) {
  const MapReport comb_report = checked(comb(33000));
  EXPECT_EQ(comb_report.verdict, MapVerdict::Valid);
  EXPECT_GE(comb_report.edges, 100000U);
  EXPECT_EQ(checked(zigzag(100000)).verdict, MapVerdict::Valid);
}

// Every tooth of one comb crosses a bar laid across: 2 * 10^4 crossings, each listed once.
TEST(MapCheckScale, BarAcrossAComb) {
  constexpr std::uint32_t kTeeth = 10000;
  TestMap map = zigzag(kTeeth, 1 << 20);
  TestMap bar;
  bar.add_point(-1, 1000);
  bar.add_point(kTeeth + 1, 1000);
  bar.add_point(kTeeth + 1, 2000);
  bar.add_point(-1, 2000);
  bar.cycles = {{0, 1, 2, 3}, {3, 2, 1, 0}};
  const MapReport report = checked(joined(map, bar), {}, 5);
  EXPECT_EQ(report.verdict, MapVerdict::Superposed);
  // Each of the bar's long edges meets every tooth edge and the two sides of the box.
  EXPECT_EQ(report.counts.crossing, 2 * (kTeeth + 2));
  EXPECT_EQ(report.defects.size(), 5U);
}

// Two lattices, one turned by 45 degrees and scaled so that its vertices lie on the other's: edges
// of one pass exactly through vertices of the other.
TEST(MapCheckScale, FacesCrossingExactlyAtVertices) {
  const TestMap upright = grid(6);
  TestMap turned = grid(4);
  for (ExactPoint& p : turned.points) p = {p.x - p.y + 6, p.x + p.y - 2};
  EXPECT_EQ(disagreement(joined(upright, turned)), "");
  EXPECT_EQ(disagreement(joined(upright, turned), {OuterRule::Listed, true}), "");
}

// Integers that doubles merge in pairs, and fractions no double holds.
TEST(MapCheckScale, CoordinatesBeyondDoubles) {
  const BigRational far = power_of_two(62) + 1;
  const BigRational third(1, 3);
  for (const MapFamily& family : map_families()) {
    const TestMap map = family.make(40);
    for (const TestMap& moved :
         {translated(map, far, -far), translated(scaled(map, third), far, third),
          scaled(map, power_of_two(-1060)), scaled(map, power_of_two(960))}) {
      EXPECT_EQ(checked(moved).verdict, MapVerdict::Valid) << family.name;
      for (const MapDefectMaker& maker : map_defect_makers()) {
        const DefectiveMap wrong = maker.make(moved, {3, 1});
        if (!wrong.expected.refused.empty() || !wrong.expected.verdict) continue;
        EXPECT_EQ(checked(wrong.map).verdict, *wrong.expected.verdict)
            << family.name << ' ' << maker.name;
      }
    }
  }
}

}  // namespace
}  // namespace plumb::testing::map_check_scale_test
