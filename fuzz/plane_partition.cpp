// Convex pieces of any set of the plane, by every method that cuts it: each convex, together the
// set, no point twice.
//
// Input: a program of records of eight bytes (tests/generate/plane_program.h), an expression over
// sets of the plane. The judge is tests/oracle/partition_check.h.
#include "generate/plane_program.h"
#include "oracle/partition_check.h"
#include "plumb/predicates/error.h"
#include "record_target.h"

namespace plumb::testing {
namespace {

constexpr std::size_t kMaxLines = 16;

/// None: the method does not cut this set.
std::optional<PlanePieces> pieces_of(const Nef2& set, const PartitionOptions& options) {
  Context context;
  try {
    return decompose(set, options, context);
  } catch (const Error& e) {
    if (e.code() != ErrorCode::BadArgument) throw;
    return std::nullopt;
  }
}

std::string difference_of(std::span<const std::uint8_t> program) {
  const Nef2 set = to_nef(*set_of_program(program, kMaxLines));
  for (const bool closed : {false, true}) {
    std::size_t optimal = ~std::size_t{0};
    for (const PartitionMethod method : {PartitionMethod::Optimal, PartitionMethod::Best,
                                         PartitionMethod::Cuts, PartitionMethod::Diagonals}) {
      const std::optional<PlanePieces> pieces = pieces_of(set, {method, closed});
      if (!pieces) continue;
      const std::string flaw = flaw_of_partition(set, *pieces, closed);
      if (!flaw.empty()) return flaw + (closed ? ", closed" : "");
      const std::size_t count = pieces->pieces.size();
      if (method == PartitionMethod::Optimal) optimal = count;
      if (method == PartitionMethod::Best && count > optimal) return "the best are not the fewest";
      if (method == PartitionMethod::Diagonals && optimal != ~std::size_t{0} && count < optimal) {
        return "diagonals make fewer pieces than the fewest";
      }
    }
  }
  return "";
}

}  // namespace
}  // namespace plumb::testing

const plumb::fuzz::RecordTarget plumb::fuzz::kTarget{plumb::testing::kProgramRecord, 40,
                                                     plumb::testing::difference_of};
