// check_map against its brute-force twin: verdict, counts, every defect, regions.
//
// Input: a program of records of four bytes (tests/generate/map_program.h); the last byte of the
// first chooses the options. The mutator works on records, so every input is a map.
#include <cstdio>
#include <cstdlib>
#include <span>

#include "plane/checked.h"
#include "plumb/testing/map_program.h"
#include "plumb/testing/oracle_reached.h"
#include "plumb/testing/record_mutator.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMaxCorners = 48;  // the twin is quadratic

OracleOptions options_of(std::uint8_t byte) { return {kOuterRules[byte % 3], byte / 3 % 4 == 0}; }

void run(std::span<const std::uint8_t> program) {
  if (program.size() < kMapRecord) return;
  const TestMap map = map_of_program(program, kMaxCorners);
  if (map.corner_count() > 2 * kMaxCorners) return;
  const OracleOptions options = options_of(program[3]);
  if (refusal(map, options).empty()) fuzz::oracle_reached();
  const std::string wrong = disagreement(map, options);
  if (wrong.empty()) return;
  std::fprintf(stderr, "check_map and its twin disagree: %s\n", wrong.c_str());
  std::abort();
}

}  // namespace
}  // namespace plumb::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  plumb::fuzz::begin_input();
  plumb::testing::run({data, size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  return plumb::fuzz::RecordMutator(plumb::testing::kMapRecord, seed).mutate(data, size, max_size);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* first, std::size_t first_size,
                                                 const std::uint8_t* second,
                                                 std::size_t second_size, std::uint8_t* out,
                                                 std::size_t max_size, unsigned seed) {
  return plumb::fuzz::RecordMutator(plumb::testing::kMapRecord, seed)
      .cross({first, first_size}, {second, second_size}, out, max_size);
}
