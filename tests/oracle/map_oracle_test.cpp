// The twin itself against the truth table, and the generators against the twin.
#include "plumb/testing/map_oracle.h"

#include <gtest/gtest.h>

#include "plumb/testing/map_defects.h"
#include "plumb/testing/map_families.h"
#include "plumb/testing/small_maps.h"

namespace plumb::testing::map_oracle_test {
namespace {

class TruthTable : public ::testing::TestWithParam<SmallMap> {};

TEST_P(TruthTable, OracleAgrees) {
  const SmallMap& wanted = GetParam();
  const TestMap map = parse_map(wanted.text);
  ASSERT_EQ(refusal(map, {wanted.outer, wanted.merge}), "");
  const OracleReport got = judge(map, {wanted.outer, wanted.merge});
  EXPECT_EQ(got.verdict, wanted.verdict);
  EXPECT_EQ(got.counts.duplicate, wanted.duplicate);
  EXPECT_EQ(got.counts.open, wanted.open);
  EXPECT_EQ(got.counts.crossing, wanted.crossing);
  EXPECT_EQ(got.counts.twin, wanted.twin);
  EXPECT_EQ(got.counts.mixed ? static_cast<int>(*got.counts.mixed) : -1, wanted.mixed);
  EXPECT_EQ(got.counts.nested, wanted.nested);
  EXPECT_EQ(got.components, wanted.components);
}

INSTANTIATE_TEST_SUITE_P(Oracle, TruthTable, ::testing::ValuesIn(small_maps()));

TEST(Oracle, FamiliesAreValidAndOfTheirSize) {
  for (const MapFamily& family : map_families()) {
    const TestMap map = family.make(30);
    const OracleReport report = judge(map, {});
    EXPECT_EQ(report.verdict, MapVerdict::Valid) << family.name;
    EXPECT_NEAR(static_cast<double>(face_count(map)), 30.0, 15.0) << family.name;
    // Euler: V - E + F = 1 + components, F counting the unbounded face.
    std::set<std::uint32_t> used;
    for (const Cycle& cycle : map.cycles) used.insert(cycle.begin(), cycle.end());
    EXPECT_EQ(used.size() + report.regions.size(), report.edges + 1 + report.components)
        << family.name;
  }
}

TEST(Oracle, RandomSubdivisionsAreValid) {
  std::size_t components = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const OracleReport report = judge(random_subdivision(6, 12, seed), {});
    EXPECT_EQ(report.verdict, MapVerdict::Valid) << "seed " << seed;
    components = std::max(components, report.components);
  }
  EXPECT_GE(components, 3U);
}

TEST(Oracle, RegionsOfIslandsInIslands) {
  const OracleReport report = judge(nest(3), {});
  ASSERT_EQ(report.regions.size(), 4U);
  EXPECT_EQ(report.regions[0].holes, std::vector<std::uint32_t>{1});
  EXPECT_EQ(report.regions[1].outer, 0U);
  EXPECT_EQ(report.regions[1].holes, std::vector<std::uint32_t>{3});
  EXPECT_EQ(report.regions[3].outer, 4U);
  EXPECT_TRUE(report.regions[3].holes.empty());
}

}  // namespace
}  // namespace plumb::testing::map_oracle_test
