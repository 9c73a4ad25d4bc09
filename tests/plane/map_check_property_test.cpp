// Laws of check_map on random maps: a valid one stays valid under every symmetric change, and on
// garbage it says what the brute-force twin says, to the last defect.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <numeric>

#include "plane/checked.h"
#include "plumb/testing/dice.h"
#include "plumb/testing/garbage_maps.h"
#include "plumb/testing/map_families.h"

namespace plumb::testing::map_check_property_test {
namespace {

std::uint64_t any_seed() { return *rc::gen::arbitrary<std::uint64_t>(); }
std::uint32_t between(std::uint32_t low, std::uint32_t high) {
  return *rc::gen::inRange(low, high + 1);
}

template <class Law>
void expect_law(const Law& law) {
  EXPECT_TRUE(rc::check(law));
}

TestMap any_subdivision() {
  TestMap map = random_subdivision(between(1, 9), between(3, 30), any_seed());
  RC_PRE(!map.cycles.empty());
  return map;
}

std::vector<std::uint32_t> any_order(std::size_t size) {
  std::vector<std::uint32_t> order(size);
  std::iota(order.begin(), order.end(), 0U);
  Dice dice(any_seed());
  for (std::size_t i = size; i > 1; --i) std::swap(order[i - 1], order[dice.below(i)]);
  return order;
}

// ---------------------------------------------------------------- symmetric changes

struct Symmetry {
  std::string name;
  TestMap (*apply)(const TestMap&);
};

void PrintTo(const Symmetry& symmetry, std::ostream* out) { *out << symmetry.name; }

const Symmetry kSymmetries[] = {
    {"relabelling", [](const TestMap& m) { return relabelled(m, any_order(m.points.size())); }},
    {"cycle_order", [](const TestMap& m) { return reordered(m, any_order(m.cycles.size())); }},
    {"rotation_of_cycles", [](const TestMap& m) { return rotated(m, between(0, 100)); }},
    {"scaling",
     [](const TestMap& m) {
       return scaled(m, power_of_two(static_cast<int>(between(0, 1800)) - 900));
     }},
    {"scaling_by_a_fraction",
     [](const TestMap& m) { return scaled(m, BigRational(between(1, 99), between(1, 99))); }},
    {"point_reflection", [](const TestMap& m) { return scaled(m, -1); }},
    {"translation",
     [](const TestMap& m) {
       const BigRational far = power_of_two(static_cast<int>(between(0, 70)));
       return translated(m, far, BigRational(between(0, 50), between(1, 7)) - far);
     }},
    {"axis_swap", [](const TestMap& m) { return axes_swapped(m); }},
};

class Symmetries : public ::testing::TestWithParam<Symmetry> {};

TEST_P(Symmetries, KeepAValidMapValid) {
  expect_law([] {
    const TestMap map = any_subdivision();
    const MapReport before = checked(map);
    const MapReport after = checked(GetParam().apply(map));
    RC_ASSERT(before.verdict == MapVerdict::Valid);
    RC_ASSERT(after.verdict == MapVerdict::Valid);
    RC_ASSERT(after.components == before.components);
    RC_ASSERT(after.regions.size() == before.regions.size());
    RC_ASSERT(after.edges == before.edges);
  });
}

TEST_P(Symmetries, KeepTheCountsOfADefectiveMap) {
  expect_law([] {
    const TestMap map = garbage_map(between(3, 12), between(1, 5), between(1, 8), any_seed());
    const MapReport before = checked(map);
    const MapReport after = checked(GetParam().apply(map));
    RC_ASSERT(after.verdict == before.verdict);
    RC_ASSERT(after.counts.duplicate == before.counts.duplicate);
    RC_ASSERT(after.counts.open == before.counts.open);
    RC_ASSERT(after.counts.crossing == before.counts.crossing);
    RC_ASSERT(after.counts.twin == before.counts.twin);
    RC_ASSERT(after.defects.size() == before.defects.size());
  });
}

INSTANTIATE_TEST_SUITE_P(MapCheck, Symmetries, ::testing::ValuesIn(kSymmetries),
                         [](const auto& tested) { return tested.param.name; });

// ---------------------------------------------------------------- the twin

class AgreesWithTheTwin : public ::testing::TestWithParam<OuterRule> {
 protected:
  void expect_agreement(const TestMap& map) const {
    const bool merge = between(0, 3) == 0;
    RC_ASSERT(disagreement(map, {GetParam(), merge}) == "");
  }
};

TEST_P(AgreesWithTheTwin, OnGarbage) {
  expect_law([this] {
    expect_agreement(garbage_map(between(3, 12), between(1, 6), between(1, 9), any_seed()));
  });
}

TEST_P(AgreesWithTheTwin, OnSubdivisions) {
  expect_law([this] { expect_agreement(any_subdivision()); });
}

TEST_P(AgreesWithTheTwin, OnRecombinedSubdivisions) {
  expect_law(
      [this] { expect_agreement(recombined(any_subdivision(), between(1, 12), any_seed())); });
}

TEST_P(AgreesWithTheTwin, OnIncompleteSubdivisions) {
  expect_law([this] {
    const TestMap map = recombined(any_subdivision(), between(0, 4), any_seed());
    expect_agreement(shuffled_cycles(map, between(1, 6), any_seed()));
  });
}

TEST_P(AgreesWithTheTwin, OnMovedVertices) {
  expect_law([this] {
    expect_agreement(moved_vertices(any_subdivision(), between(1, 4), 20, any_seed()));
  });
}

std::string name_of_rule(const ::testing::TestParamInfo<OuterRule>& tested) {
  static constexpr const char* kNames[] = {"Listed", "Infer", "Ignore"};
  return kNames[static_cast<int>(tested.param)];
}

INSTANTIATE_TEST_SUITE_P(MapCheck, AgreesWithTheTwin, ::testing::ValuesIn(kOuterRules),
                         name_of_rule);

}  // namespace
}  // namespace plumb::testing::map_check_property_test
