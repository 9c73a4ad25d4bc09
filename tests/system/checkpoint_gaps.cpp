// How long operations on large inputs go without a checkpoint: checkpoint_gaps [SIZE [ROOM]]
//
// Prints the longest time between two, in seconds of CPU time, and between which phases. SIZE and
// ROOM: those of large_operations.h and large_models.h. Exit status 1 when a stop may have to wait
// longer than kLongest.
#include <cstdio>
#include <cstdlib>

#include "generate/counted_checkpoints.h"
#include "system/large_models.h"
#include "system/large_operations.h"

namespace plumb::testing {
namespace {

constexpr double kLongest = 0.1;
bool is_good = true;

void measure(const std::string& name, const std::function<void(Context&)>& run) {
  CountedCheckpoints& counted = counted_checkpoints();
  const std::uint64_t before = counted.passed;
  Context context;
  counted.begin();
  run(context);
  counted.end();
  if (counted.longest_gap > kLongest) is_good = false;
  std::printf("%-28s %9llu checkpoints, longest gap %.3f s: %.*s ... %.*s\n", name.c_str(),
              static_cast<unsigned long long>(counted.passed - before), counted.longest_gap,
              static_cast<int>(counted.before.size()), counted.before.data(),
              static_cast<int>(counted.after.size()), counted.after.data());
  std::fflush(stdout);
}

}  // namespace
}  // namespace plumb::testing

int main(int argc, char** argv) {
  using namespace plumb::testing;
  const double size = argc > 1 ? std::atof(argv[1]) : 1;
  const char* const room = argc > 2 ? argv[2] : "";
  measure_large_operations(size, room, measure);
  measure_large_models(size, room, measure);
  return is_good ? 0 : 1;
}
