// Programs over sets of the sphere against their brute-force twin: every set made item by item, the
// last one in everything that can be asked of it.
//
// Input: a program of records of eight bytes (tests/generate/sphere_program.h). The mutator works
// on records; every input is a program.
#include "generate/sphere_program.h"
#include "record_target.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMaxCircles = 8;  // the twin is quadratic in their crossings

std::string difference_of(std::span<const std::uint8_t> program) {
  return disagreement_on_sphere(program, kMaxCircles);
}

}  // namespace
}  // namespace plumb::testing

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{plumb::testing::kSphereRecord, 40,
                                                     plumb::testing::difference_of};
