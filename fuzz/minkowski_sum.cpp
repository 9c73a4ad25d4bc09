// Minkowski sums of any two bounded sets, place by place, and what an erosion undoes.
//
// Input: a program of records of eight bytes (tests/generate/space_program.h). The first half is
// one expression over sets of space, the rest the other one; what is unbounded is cut to a box. The
// judge is tests/oracle/minkowski_check.h.
#include "generate/space_program.h"
#include "oracle/minkowski_check.h"
#include "oracle/nef3_check.h"
#include "plumb/convex/minkowski.h"
#include "record_target.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMaxPlanes = 9;
// Parts of operands multiply, and every marked item is a part where one is neither open nor are
// both closed.
constexpr std::size_t kMostVertices = 10;  // of an operand
constexpr std::size_t kMostMixed = 20;     // product of both
constexpr std::size_t kMostEroded = 12;    // vertices of a sum
constexpr std::size_t kSamples = 8;

Nef3 box(const Rational& size) {
  Context context;
  std::vector<HalfSpace3> sides;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int sign : {-1, 1}) {
      std::array<Rational, 3> n;
      n[axis] = sign;
      sides.push_back(
          {{n[0], n[1], n[2], sign < 0 ? Rational(0) : Rational(-size)}, Boundary::Closed});
    }
  }
  return Nef3::intersection(sides, context);
}

/// The expression of so many records that there is not too much of it; in a box if it is unbounded.
Nef3 bounded(std::span<const std::uint8_t> program) {
  for (; program.size() >= 2 * kProgramRecord;
       program = program.first(program.size() - kProgramRecord)) {
    Nef3 set = to_nef(*space_set_of_program(program, kMaxPlanes));
    if (!set.is_bounded()) set *= box(3);
    if (set.counts().vertices <= kMostVertices) return set;
  }
  return Nef3::empty();
}

std::string difference_of(std::span<const std::uint8_t> program) {
  const std::size_t half = program.size() / kProgramRecord / 2 * kProgramRecord;
  Nef3 a = bounded(program.first(half)), b = bounded(program.subspan(half));
  const bool has_few_parts = (a.is_closed() && b.is_closed()) || a.is_open() || b.is_open();
  if (!has_few_parts && a.counts().vertices * b.counts().vertices > kMostMixed) {
    a = a.closure();
    b = b.closure();
  }
  Context context;
  const Nef3 both = minkowski_sum(a, b, context);
  if (a.is_empty() || b.is_empty()) return both.is_empty() ? "" : "a sum with nothing";
  Dice dice(program[1]);
  const std::string wrong = wrong_place(both, a, b, dice, kSamples);
  if (!wrong.empty()) return "the sum at " + wrong;
  if (both.is_closed() != (a.is_closed() && b.is_closed()) && (a.is_closed() || a.is_open()) &&
      (b.is_closed() || b.is_open())) {
    return "a sum of closed and open sets";
  }
  if (both.is_closed() && both.counts().vertices <= kMostEroded &&
      !a.is_subset_of(minkowski_erosion(both, b, context))) {
    return "an erosion of the sum";
  }
  return "";
}

}  // namespace
}  // namespace plumb::testing

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{plumb::testing::kProgramRecord, 16,
                                                     plumb::testing::difference_of};
