// Random programs against the twin, and the laws of sets.
#include <gtest/gtest.h>

#include "generate/sphere_program.h"
#include "generate/test_share.h"
#include "oracle/set_laws.h"
#include "plumb/sphere/sphere_locator.h"

namespace plumb::testing::nef_sphere_property_test {
namespace {

class RandomSpheres : public ::testing::TestWithParam<int> {
 protected:
  static SphereValues values() { return static_cast<SphereValues>(GetParam()); }
  static std::uint64_t rounds(std::uint64_t plain) {
    return share_of(values() == SphereValues::Plain ? plain : plain / 6);
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
    expect_laws(a, b, c, NefSphere::whole());
    EXPECT_TRUE((a + !a).is_whole());
  }
}

bool accepts(std::uint32_t id, std::uint64_t seed) { return (id * 2654435761U + seed) % 3 != 0; }

SphereSelector selector(std::uint64_t seed) {
  return {[=](std::uint32_t i) { return accepts(i, seed); },
          [=](std::uint32_t i) { return accepts(i, seed + 1); }, nullptr};
}

// The set with the marks of accepted items alone.
NefSphere selected(const NefSphere& set, std::uint64_t seed) {
  SphereMarks marks = set.marks();
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
    EXPECT_TRUE(boolean_op(a, selector(round), b, selector(round + 5), kUnion, context) ==
                selected(a, round) + selected(b, round + 5));
    EXPECT_TRUE(boolean_op(a, {}, b, selector(round), kDifference, context) ==
                a - selected(b, round));
  }
}

// Corners and their opposites, places on circles inside and outside of arcs, normals, any others.
std::vector<SphereVector> telling_directions(const NefSphere& set, Dice& dice) {
  std::vector<SphereVector> all;
  const SphereMap& map = set.map();
  for (std::uint32_t v = 0; v < map.point_count(); ++v) {
    all.push_back(set.direction(v));
    all.push_back(all.back().opposite());
  }
  for (std::uint32_t a = 0; a < map.arc_count(); ++a) {
    const SphereVector n = set.normal(a);
    all.push_back(n);
    const SphereVector from =
        map.is_loop(a) ? cross(n, {1, 2, -4}) : set.direction(map.origin[2 * a]);
    const SphereVector ahead = cross(n, from);
    all.push_back(ahead);
    all.push_back(
        {Rational(from.x + ahead.x), Rational(from.y + ahead.y), Rational(from.z + ahead.z)});
    if (map.is_loop(a)) continue;
    const SphereVector to = set.direction(map.target(2 * a));
    const SphereVector middle{Rational(from.x + to.x), Rational(from.y + to.y),
                              Rational(from.z + to.z)};
    if (!middle.is_zero()) all.push_back(middle);
  }
  for (std::size_t i = 0; i < 12; ++i) {
    const auto coordinate = [&] { return static_cast<double>(dice.between(-6, 6)) / 8; };
    const double x = coordinate();
    const double y = coordinate();
    all.emplace_back(x, y, x == 0 && y == 0 ? 1.0 : coordinate());
  }
  return all;
}

bool is_same_hit(const std::optional<SphereHit>& a, const std::optional<SphereHit>& b) {
  if (!a || !b) return !a && !b;
  return a->location == b->location && is_same_direction(a->point, b->point);
}

// One by one NefSphere looks at all of the map.
void expect_same_answers(const NefSphere& set, Dice& dice) {
  SphereLocator locator(set);
  const std::vector<SphereVector> directions = telling_directions(set, dice);
  const std::vector<SphereLocation> together = set.locate(directions);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const SphereVector& u = directions[i];
    const SphereLocation at = set.locate(u);
    EXPECT_EQ(locator.locate(u), at) << i;
    EXPECT_EQ(together[i], at) << i;
    EXPECT_EQ(locator.has_on_boundary(u), at.cell.kind() != SphereCell::Kind::Face) << i;
    for (std::size_t k = 0; k < 3; ++k) {
      const SphereVector& to = directions[dice.below(directions.size())];
      if (cross(u, to).is_zero()) continue;
      EXPECT_TRUE(is_same_hit(locator.shoot(u, to), set.shoot(u, to))) << i;
      EXPECT_TRUE(is_same_hit(locator.shoot_to_boundary(u, to), set.shoot_to_boundary(u, to))) << i;
    }
  }
}

TEST_P(RandomSpheres, AreLocatedInAsByALookAtAll) {
  for (std::uint64_t round = 0; round < rounds(60) && !HasFailure(); ++round) {
    SCOPED_TRACE(seed_of(round));
    Dice dice(seed_of(round) + 77000);
    NefSphere all;
    for (const NefSphere& s :
         sets_on_sphere(random_sphere_program(dice, values(), 3 + round % 9), 9)) {
      expect_same_answers(s, dice);
      all ^= s;
    }
    expect_same_answers(all, dice);
    expect_same_answers(!all, dice);
  }
}

std::string name_of_values(const ::testing::TestParamInfo<int>& tested) {
  static constexpr const char* kNames[] = {"Plain", "Tenths", "Thirds", "Large", "Uneven", "Long"};
  return kNames[tested.param];
}

INSTANTIATE_TEST_SUITE_P(NefSphere, RandomSpheres, ::testing::Range(0, kSphereValues),
                         name_of_values);

TEST(NefSpherePrograms, OfAnyBytesAreThoseOfTheTwin) {
  for (std::uint64_t seed = 0; seed < share_of(60) && !HasFailure(); ++seed) {
    Dice dice(seed);
    EXPECT_EQ(disagreement_on_sphere(wild_sphere_program(dice, 2 + seed % 10), 9), "")
        << "seed " << seed;
  }
}

}  // namespace
}  // namespace plumb::testing::nef_sphere_property_test
