// Intersections of half-spaces against Booleans of the same half-spaces; what these cost because
// they reach to infinity.
#include "plumb/space/set/half_space_hull.h"

#include <gmp.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "generate/counted_memory.h"
#include "generate/meshes.h"
#include "plumb/predicates/error.h"
#include "plumb/space/space_audit.h"
#include "plumb/testing/dice.h"

namespace plumb::half_space_hull_test {
namespace {

using testing::Dice;

Nef3 fold(const std::vector<HalfSpace3>& half_spaces) {
  Nef3 result = Nef3::whole();
  for (const HalfSpace3& h : half_spaces) result *= Nef3::half_space(h.plane, h.boundary);
  return result;
}

HalfSpace3 half_space(int a, int b, int c, int d, Boundary boundary = Boundary::Closed) {
  return {{a, b, c, d}, boundary};
}

std::vector<HalfSpace3> cube(int size, Boundary boundary = Boundary::Closed) {
  return {half_space(1, 0, 0, -size, boundary), half_space(-1, 0, 0, -size, boundary),
          half_space(0, 1, 0, -size, boundary), half_space(0, -1, 0, -size, boundary),
          half_space(0, 0, 1, -size, boundary), half_space(0, 0, -1, -size, boundary)};
}

/// Planes of small numbers: many through one point, parallel, equal, opposite ones.
std::vector<HalfSpace3> scene(Dice& dice) {
  std::vector<HalfSpace3> result;
  if (dice.between(0, 1) == 0) result = cube(2);
  const auto count = static_cast<std::size_t>(dice.between(1, 9));
  const std::int64_t least = dice.between(-3, 0);
  while (result.size() < count + 4) {
    const std::int64_t a = dice.between(-2, 2);
    const std::int64_t b = dice.between(-2, 2);
    const std::int64_t c = dice.between(-2, 2);
    const std::int64_t d = dice.between(least - 2, least + 1);
    const bool is_open = dice.between(0, 1) == 0;
    if (a == 0 && b == 0 && c == 0) continue;
    result.push_back({{a, b, c, d}, is_open ? Boundary::Open : Boundary::Closed});
  }
  return result;
}

/// Thirds of the numbers, which are no doubles, say the same.
HalfSpaceList list_of(const std::vector<HalfSpace3>& half_spaces) {
  HalfSpaceList list;
  for (const HalfSpace3& h : half_spaces) {
    for (const Rational* number : {&h.plane.a, &h.plane.b, &h.plane.c, &h.plane.d}) {
      list.add_number(Rational(*number / 3));
    }
    list.end(h.boundary);
  }
  return list;
}

TEST(HalfSpaceList, RefusesNumbersThatAreNotFinite) {
  HalfSpaceList list;
  for (const double value : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    EXPECT_THROW(list.add_number(value), Error);
  }
  for (const double value : {0.5, 0.0, -0.0, 0x1p-1074}) list.add_number(value);
  list.end(Boundary::Closed);
  ASSERT_EQ(list.size(), 1U);
  EXPECT_EQ(list[0].plane.a, Rational(1, 2));
  EXPECT_EQ(list[0].plane.c, 0);
  EXPECT_EQ(list[0].plane.d, Rational(1, Integer(1) << 1074));
}

TEST(HalfSpaceHull, IsTheFoldOfTheHalfSpaces) {
  Dice dice(7);
  std::size_t polytopes = 0, unbounded = 0, without_inside = 0, spared = 0;
  for (int i = 0; i < 120 && !HasFailure(); ++i) {
    const std::vector<HalfSpace3> half_spaces = scene(dice);
    const Nef3 expected = fold(half_spaces);
    Context context;
    const HalfSpaceHull hull = hull_of_half_spaces(half_spaces, context);
    const bool is_solid = !expected.interior().is_empty();
    ASSERT_EQ(hull.polytope.has_value(), is_solid && expected.is_bounded()) << i;
    if (hull.polytope) {
      const auto flaw = audit(*hull.polytope, AuditForm::Minimal);
      ASSERT_FALSE(flaw) << i << ": " << flaw->invariant;
      EXPECT_EQ(Nef3::from_minimal_unchecked(*hull.polytope), expected) << i;
    }
    std::vector<HalfSpace3> needed;
    for (const std::uint32_t k : hull.needed) needed.push_back(half_spaces[k]);
    EXPECT_EQ(fold(needed), expected) << i;
    EXPECT_EQ(Nef3::intersection(half_spaces, context), expected) << i;
    EXPECT_EQ(intersection_of(list_of(half_spaces), context), expected) << i;
    ++(!is_solid ? without_inside : hull.polytope ? polytopes : unbounded);
    spared += half_spaces.size() - needed.size();
  }
  EXPECT_GT(polytopes, 30u);
  EXPECT_GT(unbounded, 10u);
  EXPECT_GT(without_inside, 10u);
  EXPECT_GT(spared, 100u);
}

/// Open half-spaces that touch a cube in a vertex, an edge, a facet; closed ones that do so change
/// nothing.
TEST(HalfSpaceHull, OpenOnesTakeAwayWhatTheyTouch) {
  for (const auto& [a, b, c, d] :
       {std::array{1, 1, 1, -3}, std::array{1, 1, 0, -2}, std::array{1, 0, 0, -1}}) {
    for (const Boundary boundary : {Boundary::Open, Boundary::Closed}) {
      std::vector<HalfSpace3> half_spaces = cube(1);
      half_spaces.push_back(half_space(a, b, c, d, boundary));
      Context context;
      const Nef3 set = Nef3::intersection(half_spaces, context);
      EXPECT_EQ(set, fold(half_spaces));
      EXPECT_EQ(set.contains(Point3{1, 1, 1}), boundary == Boundary::Closed);
      EXPECT_TRUE(set.contains(Point3{-1, 1, 1}));
      EXPECT_EQ(set.counts().facets, 6u);
    }
  }
}

TEST(HalfSpaceHull, NoneOneAndTwo) {
  Context context;
  EXPECT_TRUE(Nef3::intersection({}, context).is_whole());
  const std::vector<HalfSpace3> one{half_space(1, 2, 3, 4)};
  EXPECT_EQ(Nef3::intersection(one, context), Nef3::half_space(one[0].plane, one[0].boundary));
  const std::vector<HalfSpace3> plane{half_space(1, 2, 3, 4), half_space(-1, -2, -3, -4)};
  EXPECT_EQ(Nef3::intersection(plane, context), Nef3::plane({1, 2, 3, 4}));
  EXPECT_THROW(Nef3::intersection(std::vector{half_space(0, 0, 0, 1)}, context), Error);
}

/// Every plane through one vertex; then the polar one: every vertex on one plane.
TEST(HalfSpaceHull, ConesOfManyFacets) {
  std::vector<HalfSpace3> cone{half_space(0, 0, -1, 0)};
  for (int i = -20; i <= 20; ++i) {
    cone.push_back(half_space(40, 2 * i, 50, -100));
    cone.push_back(half_space(-40, 2 * i, 50, -100));
    cone.push_back(half_space(2 * i, 40, 50, -100));
    cone.push_back(half_space(2 * i, -40, 50, -100, Boundary::Open));
  }
  Context context;
  const Nef3 set = Nef3::intersection(cone, context);
  EXPECT_EQ(set, fold(cone));
  EXPECT_FALSE(audit(set.complex(), AuditForm::Minimal));
  EXPECT_FALSE(set.contains(Point3{0, 0, 2}));
}

// ---------------------------------------------------------------- what infinity costs Seen to go
// wrong elsewhere: 0.15 s for each Boolean of half-spaces, with numbers that hold infinity. Memory
// that is asked for is counted, not time: it is the same in every run.

struct Work {
  std::uint64_t blocks = 0;
  std::uint64_t bytes = 0;
};

/// Of GMP, which has its numbers from malloc.
Work of_numbers;

void* new_number(std::size_t bytes) {
  ++of_numbers.blocks;
  of_numbers.bytes += bytes;
  return std::malloc(bytes);
}

void* longer_number(void* block, std::size_t, std::size_t bytes) {
  ++of_numbers.blocks;
  of_numbers.bytes += bytes;
  return std::realloc(block, bytes);
}

/// What `job` asks for, and its result.
std::pair<Work, Nef3> worked(const std::function<Nef3()>& job) {
  const testing::CountedMemory before = testing::counted_memory();
  of_numbers = {};
  mp_set_memory_functions(new_number, longer_number, nullptr);
  Nef3 result = job();
  mp_set_memory_functions(nullptr, nullptr, nullptr);
  const testing::CountedMemory& after = testing::counted_memory();
  const Work work{after.allocations - before.allocations + of_numbers.blocks,
                  after.bytes - before.bytes + of_numbers.bytes};
  return {work, std::move(result)};
}

/// One after the other, or in pairs, pairs of pairs ...
Nef3 combined(const std::vector<Nef3>& sets, MarkFunction f, bool in_pairs) {
  Context context;
  std::vector<Nef3> left = sets;
  while (left.size() > 1) {
    const std::size_t pairs = in_pairs ? left.size() / 2 : 1;
    for (std::size_t i = 0; i < pairs; ++i) {
      left[i] = boolean_op(left[2 * i], left[2 * i + 1], f, context);
    }
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(pairs),
               left.begin() + static_cast<std::ptrdiff_t>(2 * pairs));
  }
  return left.front();
}

constexpr int kClip = 4096;

struct EightHalfSpaces {
  const char* name;
  std::vector<HalfSpace3> half_spaces;
};

/// Every vertex of their planes lies within kClip.
std::vector<EightHalfSpaces> eights() {
  std::vector<EightHalfSpaces> result{{"octahedron", {}}, {"cone", {}}, {"slanted", {}}};
  for (int i = 0; i < 8; ++i) {
    const int x = (i & 1) != 0 ? 1 : -1, y = (i & 2) != 0 ? 1 : -1, z = (i & 4) != 0 ? 1 : -1;
    const Boundary boundary = i < 4 ? Boundary::Closed : Boundary::Open;
    result[0].half_spaces.push_back(half_space(x, y, z, -12, boundary));
    result[1].half_spaces.push_back(half_space(3 * x, (2 + y) * z, -5, 0, boundary));
  }
  for (const std::array<int, 3>& n : {std::array{9, -2, 1},
                                      {-3, 7, 5},
                                      {-4, -8, 3},
                                      {2, 5, -9},
                                      {7, 7, -1},
                                      {-8, 1, -3},
                                      {1, -6, -5},
                                      {5, -3, 8}}) {
    const auto length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    result[2].half_spaces.push_back(half_space(n[0], n[1], n[2], -static_cast<int>(16 * length)));
  }
  return result;
}

/// Whatever the order, at most ten times the work of the same half-spaces clipped to a box; and
/// clipping afterwards gives the same.
void expect_little_more_than_in_a_box(const std::vector<Nef3>& open, const Nef3& box,
                                      MarkFunction f, bool in_pairs) {
  std::vector<Nef3> clipped;
  for (const Nef3& set : open) clipped.push_back(set * box);
  const auto [work, result] = worked([&] { return combined(open, f, in_pairs); });
  const auto [work_in_box, in_box] = worked([&] { return combined(clipped, f, in_pairs); });
  EXPECT_EQ(result * box, in_box);
  EXPECT_LE(work.blocks, 10 * work_in_box.blocks);
  EXPECT_LE(work.bytes, 10 * work_in_box.bytes);
}

TEST(EightHalfSpaces, CostLittleMoreThanInABox) {
  Context context;
  const Nef3 box =
      Nef3::from_mesh(testing::box_mesh({-kClip, -kClip, -kClip}, {kClip, kClip, kClip}),
                      {.rule = WindingRule::Positive}, context);
  Dice dice(8);
  for (const EightHalfSpaces& family : eights()) {
    std::vector<Nef3> open;
    for (const HalfSpace3& h : family.half_spaces) {
      open.push_back(Nef3::half_space(h.plane, h.boundary));
    }
    for (int order = 0; order < 4 && !HasFailure(); ++order) {
      SCOPED_TRACE(std::string(family.name) + ", order " + std::to_string(order));
      expect_little_more_than_in_a_box(open, box, kUnion, order % 2 == 1);
      expect_little_more_than_in_a_box(open, box, kIntersection, order % 2 == 1);
      expect_little_more_than_in_a_box(open, box, kSymmetricDifference, order % 2 == 1);
      for (std::size_t i = open.size() - 1; i > 0; --i) std::swap(open[i], open[dice.below(i + 1)]);
    }
  }
}

}  // namespace
}  // namespace plumb::half_space_hull_test
