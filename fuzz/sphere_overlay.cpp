// Programs over sets of the sphere against their brute-force twin: every set made item by item, the
// last one in everything that can be asked of it.
//
// Input: a program of records of eight bytes (tests/generate/sphere_program.h). The mutator works on
// records; every input is a program.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "generate/sphere_program.h"
#include "oracle_reached.h"
#include "record_mutator.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMaxCircles = 8;  // the twin is quadratic in their crossings
constexpr std::size_t kMaxBytes = 40 * kSphereRecord;

void run(std::span<const std::uint8_t> program) {
  if (program.size() < 2 * kSphereRecord || program.size() > kMaxBytes) return;
  fuzz::oracle_reached();
  const std::string wrong = disagreement_on_sphere(program, kMaxCircles);
  if (wrong.empty()) return;
  std::fprintf(stderr, "NefSphere and its twin disagree: %s\n", wrong.c_str());
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
  return plumb::fuzz::RecordMutator(plumb::testing::kSphereRecord, seed)
      .mutate(data, size, max_size);
}
