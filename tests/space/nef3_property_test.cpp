// Random expressions against the twin, and the laws of sets.
#include <gtest/gtest.h>

#include "generate/space_program.h"
#include "generate/space_solids.h"
#include "generate/test_share.h"
#include "oracle/nef3_check.h"
#include "oracle/program_property.h"
#include "oracle/set_laws.h"

namespace plumb::testing::nef3_property_test {
namespace {

constexpr std::size_t kMaxPlanes = 9;

// ---------------------------------------------------------------- the twin

class RandomSpaceSets : public ::testing::TestWithParam<int> {
 protected:
  static ProgramValues values() { return static_cast<ProgramValues>(GetParam()); }
  // Long numbers make the twin slow.
  static std::uint64_t rounds(std::uint64_t plain) {
    return share_of(values() == ProgramValues::Plain ? plain : plain / 8);
  }
  static SpaceSetPointer any_set(Dice& dice, std::size_t records, std::size_t max_planes) {
    return space_set_of_program(random_space_program(dice, values(), records), max_planes);
  }
};

TEST_P(RandomSpaceSets, AreThoseOfTheTwin) {
  for (std::uint64_t seed = 0; seed < rounds(32) && !HasFailure(); ++seed) {
    Dice dice(seed * kProgramValues + static_cast<std::uint64_t>(GetParam()));
    const auto set = any_set(dice, 2 + seed % 7, kMaxPlanes);
    EXPECT_EQ(disagreement(*set), "") << "seed " << seed;
  }
}

TEST_P(RandomSpaceSets, ObeyTheLaws) {
  for (std::uint64_t seed = 0; seed < rounds(16) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto one = any_set(dice, 4, kMaxPlanes);
    const auto two = any_set(dice, 3, kMaxPlanes);
    const auto three = any_set(dice, 2, kMaxPlanes);
    SCOPED_TRACE(to_text(*one) + "\n" + to_text(*two) + "\n" + to_text(*three));
    const Nef3 a = to_nef(*one);
    const Nef3 b = to_nef(*two);
    const Nef3 c = to_nef(*three);
    expect_laws(a, b, c, Nef3::whole());
    EXPECT_TRUE((a + !a).is_whole());
  }
}

std::string name_of_values(const ::testing::TestParamInfo<int>& tested) {
  static constexpr const char* kNames[] = {"Plain", "Tenths", "Thirds", "Far",
                                           "Large", "Small",  "Uneven", "Long"};
  return kNames[tested.param];
}

INSTANTIATE_TEST_SUITE_P(Nef3, RandomSpaceSets, ::testing::Range(0, kProgramValues),
                         name_of_values);

// ---------------------------------------------------------------- special positions

std::string disagreement(const SolidPair& pair, SetOperator op) {
  return disagreement(*apply(op, pair.a, pair.b));
}

TEST(SpacePairs, InSpecialPositionAreThoseOfTheTwin) {
  for (const SolidPair& pair : special_pairs()) {
    for (int op = 0; op < 4; ++op) {
      EXPECT_EQ(disagreement(pair, static_cast<SetOperator>(op)), "") << pair.name;
    }
  }
}

// Every eleventh pair.
TEST(SpacePairs, OfOverlappingBoxesAreThoseOfTheTwin) {
  const std::vector<SolidPair> pairs = overlapping_boxes();
  for (std::size_t i = 0; i < pairs.size() && !HasFailure(); i += 11) {
    EXPECT_EQ(disagreement(pairs[i], static_cast<SetOperator>(i / 11 % 4)), "") << pairs[i].name;
  }
}

// ---------------------------------------------------------------- any program, shrunk when it
// fails

TEST(Nef3, OfAnyProgramIsTheTwins) {
  expect_no_flaw_of_programs("programs agree", 8, [](std::span<const std::uint8_t> program) {
    return disagreement(*space_set_of_program(program, kMaxPlanes));
  });
}

TEST(Nef3, OfAnyProgramsObeyTheLaws) {
  expect_programs_obey_the_laws(Nef3::whole(), [](std::span<const std::uint8_t> program) {
    return to_nef(*space_set_of_program(program, kMaxPlanes));
  });
}

}  // namespace
}  // namespace plumb::testing::nef3_property_test
