// Random expressions against the twin, and the laws of sets.
#include <gtest/gtest.h>

#include <algorithm>

#include "generate/plane_program.h"
#include "generate/test_share.h"
#include "oracle/nef2_check.h"
#include "oracle/program_property.h"
#include "oracle/set_laws.h"
#include "plumb/plane/complex/plane_records.h"

namespace plumb::testing::nef2_property_test {
namespace {

constexpr std::size_t kMaxLines = 16;

// ---------------------------------------------------------------- the twin

class RandomSets : public ::testing::TestWithParam<int> {
 protected:
  static ProgramValues values() { return static_cast<ProgramValues>(GetParam()); }
  // Long numbers make the twin slow.
  static std::uint64_t rounds(std::uint64_t plain) {
    switch (values()) {
      case ProgramValues::Plain:
      case ProgramValues::Thirds:
        return share_of(plain);
      case ProgramValues::Large:
      case ProgramValues::Small:
      case ProgramValues::Uneven:
        return share_of(plain / 24);
      default:
        return share_of(plain / 4);
    }
  }
  static PlaneSetPointer any_set(Dice& dice, std::size_t records, std::size_t max_lines) {
    return set_of_program(random_program(dice, values(), records), max_lines);
  }
};

TEST_P(RandomSets, AreThoseOfTheTwin) {
  for (std::uint64_t seed = 0; seed < rounds(48) && !HasFailure(); ++seed) {
    Dice dice(seed * kProgramValues + static_cast<std::uint64_t>(GetParam()));
    const auto set = any_set(dice, 2 + seed % 9, kMaxLines);
    EXPECT_EQ(disagreement(*set), "") << "seed " << seed;
  }
}

TEST_P(RandomSets, ObeyTheLaws) {
  for (std::uint64_t seed = 0; seed < rounds(200) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto one = any_set(dice, 5, kMaxLines);
    const auto two = any_set(dice, 4, kMaxLines);
    const auto three = any_set(dice, 3, kMaxLines);
    SCOPED_TRACE(to_text(*one) + "\n" + to_text(*two) + "\n" + to_text(*three));
    const Nef2 a = to_nef(*one);
    const Nef2 b = to_nef(*two);
    const Nef2 c = to_nef(*three);
    expect_laws(a, b, c, Nef2::whole());
    EXPECT_TRUE((a + !a).is_whole());
  }
}

TEST_P(RandomSets, HaveAreasThatAddUp) {
  for (std::uint64_t seed = 0; seed < rounds(200) && !HasFailure(); ++seed) {
    Dice dice(seed + 1000);
    const Nef2 a = to_nef(*any_set(dice, 5, kMaxLines));
    const Nef2 b = to_nef(*any_set(dice, 5, kMaxLines));
    if (!a.area() || !b.area()) continue;
    EXPECT_EQ(*(a + b).area() + *(a * b).area(), *a.area() + *b.area());
    EXPECT_EQ(*(a ^ b).area(), *(a - b).area() + *(b - a).area());
    EXPECT_EQ(*a.boundary().area(), 0);
  }
}

// ---------------------------------------------------------------- structure

void expect_same_structure(const PlaneComplex& a, const PlaneComplex& b) {
  ASSERT_EQ(a.vertex_count(), b.vertex_count());
  ASSERT_EQ(a.edge_count(), b.edge_count());
  ASSERT_EQ(a.face_count(), b.face_count());
  ASSERT_EQ(a.dcel.halfedge_count(), b.dcel.halfedge_count());
  ASSERT_EQ(a.dcel.loop_count(), b.dcel.loop_count());
  EXPECT_TRUE(a.marks == b.marks);
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    ASSERT_TRUE(exact(a.points, a.vertex_point[v]) == exact(b.points, b.vertex_point[v]));
    ASSERT_EQ(a.dcel.halfedge(VertexId(v)), b.dcel.halfedge(VertexId(v)));
  }
  for (std::size_t i = 0; i < a.dcel.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    ASSERT_EQ(a.dcel.origin(h), b.dcel.origin(h));
    ASSERT_EQ(a.dcel.next(h), b.dcel.next(h));
    ASSERT_EQ(a.dcel.loop(h), b.dcel.loop(h));
    ASSERT_EQ(a.dcel.face(h), b.dcel.face(h));
  }
}

// One set made in several ways has one structure.
TEST_P(RandomSets, HaveOneStructureHoweverTheyAreMade) {
  for (std::uint64_t seed = 0; seed < rounds(120) && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed + 5000);
    const Nef2 a = to_nef(*any_set(dice, 5, kMaxLines));
    const Nef2 b = to_nef(*any_set(dice, 5, kMaxLines));
    const Nef2 junk = to_nef(*any_set(dice, 3, kMaxLines));
    expect_same_structure((a + b).complex(), (b + a).complex());
    expect_same_structure((a * b).complex(), (!(!b + !a)).complex());
    expect_same_structure(
        a.complex(),
        (((a ^ junk) - b) ^ (a * b) ^ (junk - b) ^ (junk * a * b) ^ (junk * a * b)).complex());
    expect_same_structure(a.complex(), ((a ^ junk) ^ junk).complex());
  }
}

// ---------------------------------------------------------------- more operations

AffineMap2 any_map(Dice& dice) {
  const auto number = [&] {
    const Rational numerator = dice.between(-3, 3);
    return Rational(numerator / dice.between(1, 3));
  };
  AffineMap2 map;
  do {
    map = {number(), number(), number(), number(), number(), number()};
  } while (map.xx * map.yy == map.xy * map.yx);
  return map;
}

TEST_P(RandomSets, AreCarriedByAffineMaps) {
  if (values() == ProgramValues::Large || values() == ProgramValues::Small) GTEST_SKIP();
  for (std::uint64_t seed = 0; seed < rounds(80) && !HasFailure(); ++seed) {
    Dice dice(seed + 7000);
    const auto set = any_set(dice, 5, 12);
    const AffineMap2 map = any_map(dice);
    const auto image = transformed(set, map);
    const LineCells cells = cells_of(*image);
    EXPECT_EQ(difference(cells, {to_nef(*set).transformed(map), marks_of(*image, cells)}), "")
        << "seed " << seed << ": " << to_text(*set) << "\nby " << map.xx << ' ' << map.xy << ' '
        << map.x0 << ' ' << map.yx << ' ' << map.yy << ' ' << map.y0;
  }
}

bool accepts(std::uint32_t id, std::uint64_t seed) { return (id * 2654435761U + seed) % 3 != 0; }

PlaneSelector selector(std::uint64_t seed) {
  return {[=](VertexId v) { return accepts(v.value(), seed); },
          [=](EdgeId e) { return accepts(e.value(), seed + 1); }, nullptr};
}

// The marks of those cells that lie in an accepted element.
CellMarks selected(const LineCells& cells, const TwoSets& sets, std::uint64_t seed) {
  const PlaneGraph graph = minimal_graph(cells, sets.twin);
  const GraphMatch found = match(sets.engine.complex(), graph, cells);
  CellMarks marks = sets.twin;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const auto [dimension, index] = graph.element_of[c];
    if (dimension == 0) marks[c] = marks[c] && accepts(found.vertex[index].value(), seed);
    if (dimension == 1) marks[c] = marks[c] && accepts(found.edge[index].value(), seed + 1);
  }
  return marks;
}

TEST_P(RandomSets, CombineSelectively) {
  for (std::uint64_t seed = 0; seed < rounds(60) && !HasFailure(); ++seed) {
    Dice dice(seed + 9000);
    const auto one = any_set(dice, 4, 8);
    const auto two = any_set(dice, 4, 8);
    const LineCells cells = cells_of(*apply(SetOperator::Union, one, two));
    const TwoSets a{to_nef(*one), marks_of(*one, cells)};
    const TwoSets b{to_nef(*two), marks_of(*two, cells)};
    const CellMarks in_a = selected(cells, a, seed);
    const CellMarks in_b = selected(cells, b, seed + 5);
    Context context;
    EXPECT_EQ(difference(cells, {boolean_op(a.engine, selector(seed), b.engine, selector(seed + 5),
                                            kUnion, context),
                                 apply(SetOperator::Union, cells, in_a, in_b)}),
              "")
        << "seed " << seed << ": " << to_text(*one) << "\n"
        << to_text(*two);
    EXPECT_EQ(difference(cells, {boolean_op(a.engine, {}, b.engine, selector(seed + 5),
                                            kSymmetricDifference, context),
                                 apply(SetOperator::SymmetricDifference, cells, a.twin, in_b)}),
              "");
  }
}

TEST_P(RandomSets, TakeAnyMarks) {
  for (std::uint64_t seed = 0; seed < rounds(80) && !HasFailure(); ++seed) {
    Dice dice(seed + 11000);
    const auto set = any_set(dice, 5, 10);
    const LineCells cells = cells_of(*set);
    const Nef2 engine = to_nef(*set);
    const PlaneGraph graph = minimal_graph(cells, marks_of(*set, cells));
    const GraphMatch found = match(engine.complex(), graph, cells);
    ASSERT_EQ(found.difference, "");
    PlaneMarks marks = engine.complex().marks;
    for (std::vector<std::uint8_t>* some : std::initializer_list<std::vector<std::uint8_t>*>{
             &marks.vertex, &marks.edge, &marks.face}) {
      for (std::uint8_t& mark : *some) mark = static_cast<std::uint8_t>(dice.below(2));
    }
    CellMarks expected(cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto [dimension, index] = graph.element_of[c];
      expected[c] = (dimension == 0   ? marks.vertex[found.vertex[index].value()]
                     : dimension == 1 ? marks.edge[found.edge[index].value()]
                                      : marks.face[found.face[index].value()]) != 0;
    }
    EXPECT_EQ(difference(cells, {engine.with_marks(marks), expected}), "") << "seed " << seed;
    PlaneComplex complex = engine.complex();
    complex.marks = marks;
    EXPECT_EQ(difference(cells, {Nef2::from_complex(complex), expected}), "") << "seed " << seed;
  }
}

std::string name_of_values(const ::testing::TestParamInfo<int>& tested) {
  static constexpr const char* kNames[] = {"Plain", "Tenths", "Thirds", "Far",
                                           "Large", "Small",  "Uneven", "Long"};
  return kNames[tested.param];
}

INSTANTIATE_TEST_SUITE_P(Nef2, RandomSets, ::testing::Range(0, kProgramValues), name_of_values);

TEST(Nef2Programs, OfAnyBytesAreThoseOfTheTwin) {
  for (std::uint64_t seed = 0; seed < 20 && !HasFailure(); ++seed) {
    Dice dice(seed);
    EXPECT_EQ(disagreement(*set_of_program(wild_program(dice, 2 + seed % 8), 10)), "")
        << "seed " << seed;
  }
}

// ---------------------------------------------------------------- any program, shrunk when it
// fails

TEST(Nef2, OfAnyProgramIsTheTwins) {
  expect_no_flaw_of_programs("programs agree", 8, [](std::span<const std::uint8_t> program) {
    return disagreement(*set_of_program(program, kMaxLines));
  });
}

TEST(Nef2, OfAnyProgramsObeyTheLaws) {
  expect_programs_obey_the_laws(Nef2::whole(), [](std::span<const std::uint8_t> program) {
    return to_nef(*set_of_program(program, kMaxLines));
  });
}

}  // namespace
}  // namespace plumb::testing::nef2_property_test
