// Expressions over sets of space against their brute-force twin: every node of the tree element by
// element, the whole set in everything that can be asked of it.
//
// Input: a program of records of eight bytes (tests/generate/space_program.h). The mutator works on
// records; every input is an expression.
#include "generate/space_program.h"
#include "oracle/nef3_check.h"
#include "record_target.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMaxPlanes = 9;  // the twin is cubic in their number

std::string difference_of(std::span<const std::uint8_t> program) {
  return disagreement(*space_set_of_program(program, kMaxPlanes));
}

}  // namespace
}  // namespace plumb::testing

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{plumb::testing::kProgramRecord, 24,
                                                     plumb::testing::difference_of};
