// Expressions over sets of space against their brute-force twin: every node of the tree element by
// element, the whole set in everything that can be asked of it.
//
// Input: a program of records of eight bytes (tests/generate/space_program.h). The mutator works on
// records; every input is an expression.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "generate/space_program.h"
#include "oracle/nef3_check.h"
#include "oracle_reached.h"
#include "record_mutator.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMaxPlanes = 12;  // the twin is cubic in their number
constexpr std::size_t kMaxBytes = 24 * kProgramRecord;

void run(std::span<const std::uint8_t> program) {
  if (program.size() < 2 * kProgramRecord || program.size() > kMaxBytes) return;
  const SpaceSetPointer set = space_set_of_program(program, kMaxPlanes);
  fuzz::oracle_reached();
  const std::string wrong = disagreement(*set);
  if (wrong.empty()) return;
  std::fprintf(stderr, "Nef3 and its twin disagree: %s\n", wrong.c_str());
  std::abort();
}

}  // namespace
}  // namespace plumb::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::testing::run({data, size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  return plumb::fuzz::RecordMutator(plumb::testing::kProgramRecord, seed)
      .mutate(data, size, max_size);
}
