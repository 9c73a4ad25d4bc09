// The arrangement of segments, rays, lines and points against brute force: every vertex, edge, face
// and origin.
//
// Input: a program of records of eight bytes (tests/generate/plane_program.h), one for each curve.
#include "generate/plane_program.h"
#include "oracle/arrangement_check.h"
#include "record_target.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMaxCurves = 8;  // the twin is quadratic in their crossings

std::string difference_of(std::span<const std::uint8_t> program) {
  const CurveScene scene = scene_of_program(program, kMaxCurves);
  const std::string wrong = disagreement(scene, program[1]);
  return wrong.empty() ? wrong : wrong + '\n' + to_text(scene);
}

}  // namespace
}  // namespace plumb::testing

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{plumb::testing::kProgramRecord, 40,
                                                     plumb::testing::difference_of};
