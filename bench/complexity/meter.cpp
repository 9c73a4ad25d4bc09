#include "meter.h"

#include <linux/perf_event.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "cpu_time.h"
#include "generate/counted_memory.h"

namespace plumb::bench {
namespace {

void add_calls(Cost& sum, const RungCounts& before, const RungCounts& after) {
  for (std::size_t p = 0; p < kPredicates; ++p) {
    for (std::size_t r = 0; r < kRungs; ++r) {
      const std::uint64_t calls = after[p][r] - before[p][r];
      sum.rungs[p][r] += calls;
      sum.predicates += static_cast<double>(calls);
    }
  }
}

}  // namespace

Meter::Meter() {
  perf_event_attr attributes{};
  attributes.size = sizeof(attributes);
  attributes.type = PERF_TYPE_HARDWARE;
  attributes.config = PERF_COUNT_HW_INSTRUCTIONS;
  attributes.exclude_kernel = 1;
  attributes.exclude_hv = 1;
  counter_ = static_cast<int>(syscall(SYS_perf_event_open, &attributes, 0, -1, -1, 0));
  if (counter_ >= 0 &&
      instructions_now() == 0) {  // it is there and counts nothing: some virtual machines
    close(counter_);
    counter_ = -1;
  }
}

Meter::~Meter() {
  if (counter_ >= 0) close(counter_);
}

std::uint64_t Meter::instructions_now() const {
  std::uint64_t count = 0;
  if (counter_ < 0 || read(counter_, &count, sizeof(count)) != sizeof(count)) return 0;
  return count;
}

void Meter::start() {
  begin_.allocations = static_cast<double>(testing::counted_memory().allocations);
  begin_.bytes = static_cast<double>(testing::counted_memory().bytes);
  begin_.rungs = rung_counts();
  begin_.seconds = cpu_seconds();
  begin_.instructions = static_cast<double>(instructions_now());
}

void Meter::stop() {
  const auto instructions = static_cast<double>(instructions_now());
  const double seconds = cpu_seconds();
  sum_.instructions += instructions - begin_.instructions;
  sum_.seconds += seconds - begin_.seconds;
  sum_.allocations +=
      static_cast<double>(testing::counted_memory().allocations) - begin_.allocations;
  sum_.bytes += static_cast<double>(testing::counted_memory().bytes) - begin_.bytes;
  add_calls(sum_, begin_.rungs, rung_counts());
}

Cost Meter::take() {
  const Cost cost = sum_;
  sum_ = {};
  return cost;
}

}  // namespace plumb::bench
