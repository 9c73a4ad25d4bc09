// What operations on large inputs charge to their Context, and what they take: memory_charges [SIZE
// [ROOM]]
//
// Prints the most memory held at a time, numbers of GMP included, what was charged at most, which
// is the least limit under which the operation comes to its end, and the first divided by the
// second. SIZE and ROOM: those of large_operations.h. Exit status 1 when a limit may be passed by
// more than a tenth.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "generate/counted_charges.h"
#include "generate/counted_memory.h"
#include "system/large_operations.h"

namespace plumb::testing {
namespace {

constexpr double kMost = 1.1;
constexpr double kSlack = 1e6;  // bytes that nobody needs to account for
bool is_good = true;

void measure(const std::string& name, const std::function<void(Context&)>& run) {
  CountedMemory& memory = counted_memory();
  CountedCharges& charges = counted_charges();
  const std::int64_t held = memory.peak_bytes = memory.held_bytes;
  charges = {};
  {
    Context context;
    run(context);
  }
  const auto taken = static_cast<double>(memory.peak_bytes - held);
  const auto charged = static_cast<double>(charges.peak_bytes);
  const bool is_bad = taken > kMost * charged + kSlack;
  if (is_bad) is_good = false;
  std::printf("%-36s %8.1f MB taken, %8.1f MB charged, ratio %5.2f%s\n", name.c_str(), taken / 1e6,
              charged / 1e6, charged > 0 ? taken / charged : 0, is_bad ? "  !" : "");
  std::fflush(stdout);
}

}  // namespace
}  // namespace plumb::testing

int main(int argc, char** argv) {
  using namespace plumb::testing;
  count_numbers();
  measure_large_operations(argc > 1 ? std::atof(argv[1]) : 1, argc > 2 ? argv[2] : "", measure);
  return is_good ? 0 : 1;
}
