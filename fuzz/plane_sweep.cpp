// The arrangement of segments, rays, lines and points against brute force: every vertex, edge, face
// and origin.
//
// Input: a program of records of eight bytes (tests/generate/plane_program.h), one for each curve.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "generate/plane_program.h"
#include "oracle/arrangement_check.h"
#include "oracle_reached.h"
#include "record_mutator.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMaxCurves = 8;  // the twin is quadratic in their crossings
constexpr std::size_t kMaxBytes = 40 * kProgramRecord;

void run(std::span<const std::uint8_t> program) {
  if (program.size() < 2 * kProgramRecord || program.size() > kMaxBytes) return;
  const CurveScene scene = scene_of_program(program, kMaxCurves);
  fuzz::oracle_reached();
  const std::string wrong = disagreement(scene, program[1]);
  if (wrong.empty()) return;
  std::fprintf(stderr, "the arrangement and its twin disagree: %s\n%s", wrong.c_str(),
               to_text(scene).c_str());
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
