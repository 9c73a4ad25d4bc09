// Complexes as lists: the round trip is the identity, and whatever is wrong with a list is refused.
#include "plumb/plane/complex/plane_records.h"

#include <gtest/gtest.h>

#include "generate/plane_program.h"
#include "plumb/plane/plane_audit.h"
#include "plumb/predicates/error.h"

namespace plumb::testing::plane_records_test {
namespace {

PlaneRecords any_records(Dice& dice, ProgramValues values) {
  return to_records(to_nef(*set_of_program(random_program(dice, values, 5), 14)).complex());
}

bool are_equal(const PlaneRecords& a, const PlaneRecords& b) {
  return a.vertices == b.vertices && a.edges == b.edges && a.bottom == b.bottom &&
         a.points.inputs.size() == b.points.inputs.size() &&
         a.points.crossings.size() == b.points.crossings.size();
}

std::optional<PlaneComplex> rebuilt(const PlaneRecords& records) {
  Context context;
  try {
    return from_records(records, context);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::BadArgument) << error.what();
    return std::nullopt;
  }
}

TEST(PlaneRecords, RoundTripIsTheIdentity) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const auto values = static_cast<ProgramValues>(seed % kProgramValues);
    const PlaneRecords records = any_records(dice, values);
    const auto complex = rebuilt(records);
    ASSERT_TRUE(complex.has_value());
    EXPECT_FALSE(audit(*complex, AuditForm::Minimal).has_value());
    EXPECT_TRUE(are_equal(records, to_records(*complex)));
  }
}

// ---------------------------------------------------------------- defects

std::uint32_t any_index(Dice& dice, std::size_t size) {
  switch (dice.below(8)) {
    case 0:
      return PlaneRecords::kUnbounded;
    case 1:
      return static_cast<std::uint32_t>(size);
    default:
      return size == 0 ? 0 : dice.below(size);
  }
}

void damage_vertex(PlaneRecords& records, Dice& dice) {
  if (records.vertices.empty()) return;
  const auto at = records.vertices.begin() + dice.below(records.vertices.size());
  switch (dice.below(4)) {
    case 0:
      at->point = any_index(dice, records.points.size());
      return;
    case 1:
      at->mark = !at->mark;
      return;
    case 2:
      records.vertices.insert(at, *at);
      return;
    default:
      records.vertices.erase(at);
      return;
  }
}

void damage_edge(PlaneRecords& records, Dice& dice) {
  if (records.edges.empty()) return;
  const auto at = records.edges.begin() + dice.below(records.edges.size());
  switch (dice.below(10)) {
    case 0:
      at->from = any_index(dice, records.vertices.size());
      return;
    case 1:
      at->to = any_index(dice, records.vertices.size());
      return;
    case 2:
      at->line.a = any_index(dice, records.points.size());
      return;
    case 3:
      at->line.b = any_index(dice, records.points.inputs.size());
      return;
    case 4:
      at->mark = !at->mark;
      return;
    case 5:
      at->left = !at->left;
      return;
    case 6:
      at->right = !at->right;
      return;
    case 7:
      std::swap(*at, records.edges[dice.below(records.edges.size())]);
      return;
    case 8:
      records.edges.insert(at, *at);
      return;
    default:
      records.edges.erase(at);
      return;
  }
}

void damage(PlaneRecords& records, Dice& dice) {
  switch (dice.below(8)) {
    case 0:
      records.bottom = !records.bottom;
      return;
    case 1:
      if (!records.points.crossings.empty()) {
        Crossing2& c = records.points.crossings[dice.below(records.points.crossings.size())];
        (dice.below(2) == 0 ? c.a : c.d) = any_index(dice, records.points.inputs.size());
      }
      return;
    case 2:
    case 3:
      return damage_vertex(records, dice);
    default:
      return damage_edge(records, dice);
  }
}

// What is not refused is right: it is a minimal complex whose records these are.
TEST(PlaneRecords, DamagedOnesAreRefusedOrRight) {
  std::size_t refused = 0;
  std::size_t taken = 0;
  for (std::uint64_t seed = 0; seed < 6000 && !HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    Dice dice(seed);
    PlaneRecords records = any_records(dice, ProgramValues::Plain);
    for (std::int64_t n = dice.between(1, 2); n > 0; --n) damage(records, dice);
    const auto complex = rebuilt(records);
    if (!complex) {
      ++refused;
      continue;
    }
    ++taken;
    const auto flaw = audit(*complex, AuditForm::Minimal);
    ASSERT_FALSE(flaw.has_value()) << flaw->invariant << " at " << flaw->place;
    const PlaneRecords again = to_records(*complex);
    EXPECT_EQ(again.vertices.size(), records.vertices.size());
    EXPECT_EQ(again.edges.size(), records.edges.size());
    EXPECT_EQ(again.bottom, records.bottom);
    for (std::size_t v = 0; v < again.vertices.size(); ++v) {
      EXPECT_TRUE(exact(again.points, again.vertices[v].point) ==
                  exact(records.points, records.vertices[v].point));
      EXPECT_EQ(again.vertices[v].mark, records.vertices[v].mark);
    }
    for (std::size_t e = 0; e < again.edges.size(); ++e) {
      EXPECT_EQ(again.edges[e].from, records.edges[e].from);
      EXPECT_EQ(again.edges[e].to, records.edges[e].to);
      EXPECT_EQ(again.edges[e].mark, records.edges[e].mark);
      EXPECT_EQ(again.edges[e].left, records.edges[e].left);
      EXPECT_EQ(again.edges[e].right, records.edges[e].right);
    }
  }
  EXPECT_GT(refused, 3000U);
  EXPECT_GT(taken, 100U);
}

}  // namespace
}  // namespace plumb::testing::plane_records_test
