// Convex pieces of any set: each convex, together the set, no point twice; open and closed.
//
// Input: a program of records of eight bytes (tests/generate/space_program.h), an expression over
// sets of space. The judge is tests/oracle/pieces_check.h.
#include "generate/space_program.h"
#include "oracle/nef3_check.h"
#include "oracle/pieces_check.h"
#include "record_target.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMaxPlanes = 12;  // the judge takes half a minute for some sets of 14

std::string difference_of(std::span<const std::uint8_t> program) {
  const Nef3 set = to_nef(*space_set_of_program(program, kMaxPlanes));
  for (const bool closed : {false, true}) {
    for (const DecomposeMethod method :
         {DecomposeMethod::Cuts, DecomposeMethod::Walls, DecomposeMethod::Best}) {
      Context context;
      const std::string flaw =
          flaw_of_pieces(set, decompose(set, {method, closed}, context), closed);
      if (!flaw.empty()) return flaw + (closed ? ", closed" : "");
    }
  }
  return "";
}

}  // namespace
}  // namespace plumb::testing

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{plumb::testing::kProgramRecord, 24,
                                                     plumb::testing::difference_of};
