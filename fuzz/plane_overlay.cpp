// Expressions over sets of the plane against their brute-force twin: every node of the tree element
// by element, the whole set in everything that can be asked of it.
//
// Input: a program of records of eight bytes (tests/generate/plane_program.h). The mutator works on
// records; every input is an expression.
#include "generate/plane_program.h"
#include "oracle/nef2_check.h"
#include "record_target.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMaxLines = 12;  // the twin is quadratic in their crossings

std::string difference_of(std::span<const std::uint8_t> program) {
  return disagreement(*set_of_program(program, kMaxLines));
}

}  // namespace
}  // namespace plumb::testing

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{plumb::testing::kProgramRecord, 40,
                                                     plumb::testing::difference_of};
