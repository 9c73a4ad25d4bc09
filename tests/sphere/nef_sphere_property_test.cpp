// Random programs against the twin, and the laws of sets.
#include <gtest/gtest.h>

#include "generate/sphere_program.h"
#include "oracle/set_laws.h"

namespace plumb::testing {
namespace {

class RandomSpheres : public ::testing::TestWithParam<int> {
 protected:
  static SphereValues values() { return static_cast<SphereValues>(GetParam()); }
  static std::uint64_t rounds(std::uint64_t plain) {
    return values() == SphereValues::Plain ? plain : plain / 6;
  }
  static std::uint64_t seed_of(std::uint64_t round) {
    return round * kSphereValues + static_cast<std::uint64_t>(GetParam());
  }
};

TEST_P(RandomSpheres, AreThoseOfTheTwin) {
  for (std::uint64_t round = 0; round < rounds(120) && !HasFailure(); ++round) {
    Dice dice(seed_of(round));
    const auto program = random_sphere_program(dice, values(), 2 + round % 12);
    EXPECT_EQ(disagreement_on_sphere(program, 9), "") << "seed " << seed_of(round);
  }
}

TEST_P(RandomSpheres, ObeyTheLaws) {
  for (std::uint64_t round = 0; round < rounds(150) && !HasFailure(); ++round) {
    SCOPED_TRACE(seed_of(round));
    Dice dice(seed_of(round));
    const auto any_set = [&](std::size_t records) {
      NefSphere set;
      for (const NefSphere& s : sets_on_sphere(random_sphere_program(dice, values(), records), 9)) {
        set ^= s;
      }
      return set;
    };
    const NefSphere a = any_set(5);
    const NefSphere b = any_set(4);
    const NefSphere c = any_set(3);
    expect_laws(a, b, c, NefSphere::sphere());
    EXPECT_TRUE((a + !a).is_sphere());
  }
}

bool accepts(std::uint32_t id, std::uint64_t seed) { return (id * 2654435761U + seed) % 3 != 0; }

SphereSelector selector(std::uint64_t seed) {
  return {[=](std::uint32_t i) { return accepts(i, seed); },
          [=](std::uint32_t i) { return accepts(i, seed + 1); }, nullptr};
}

// The set with the marks of accepted items alone.
NefSphere selected(const NefSphere& set, std::uint64_t seed) {
  SphereItemMarks marks = set.marks();
  for (std::uint32_t i = 0; i < marks.point.size(); ++i) {
    if (!accepts(i, seed)) marks.point[i] = 0;
  }
  for (std::uint32_t i = 0; i < marks.arc.size(); ++i) {
    if (!accepts(i, seed + 1)) marks.arc[i] = 0;
  }
  return set.with_marks(marks);
}

TEST_P(RandomSpheres, CombineSelectively) {
  for (std::uint64_t round = 0; round < rounds(60) && !HasFailure(); ++round) {
    Dice dice(seed_of(round) + 9000);
    const auto sets = sets_on_sphere(random_sphere_program(dice, values(), 8), 9);
    if (sets.size() < 2) continue;
    const NefSphere& a = sets[0];
    const NefSphere& b = sets[1];
    Context context;
    EXPECT_TRUE(combine(a, selector(round), b, selector(round + 5), kUnion, context) ==
                selected(a, round) + selected(b, round + 5));
    EXPECT_TRUE(combine(a, {}, b, selector(round), kDifference, context) == a - selected(b, round));
  }
}

std::string name_of_values(const ::testing::TestParamInfo<int>& tested) {
  static constexpr const char* kNames[] = {"Plain", "Tenths", "Thirds", "Large", "Uneven", "Long"};
  return kNames[tested.param];
}

INSTANTIATE_TEST_SUITE_P(NefSphere, RandomSpheres, ::testing::Range(0, kSphereValues),
                         name_of_values);

TEST(NefSpherePrograms, OfAnyBytesAreThoseOfTheTwin) {
  for (std::uint64_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
    Dice dice(seed);
    EXPECT_EQ(disagreement_on_sphere(wild_sphere_program(dice, 2 + seed % 10), 9), "")
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace plumb::testing
