#include "generate/counted_checkpoints.h"

#include <ctime>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/predicates/error.h"

// The linker's option --wrap gives these names to the function that is called and to the one that
// was meant.
#define PLUMB_CHECKPOINT \
  "_ZN5plumb7Context10checkpointESt17basic_string_viewIcSt11char_traitsIcEEmm"

#define PLUMB_CHECK_LIMITS \
  "_ZNK5plumb7Context12check_limitsESt17basic_string_viewIcSt11char_traitsIcEE"

namespace plumb::testing {
namespace {

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

}  // namespace

CountedCheckpoints& counted_checkpoints() {
  static CountedCheckpoints counted;
  return counted;
}

void CountedCheckpoints::begin() {
  longest_gap = 0;
  before = "the begin";
  after = {};
  last_phase_ = before;
  measured_ = std::this_thread::get_id();
  last_ = cpu_seconds();
}

void CountedCheckpoints::pass(std::string_view phase) {
  ++passed;
  const double now = cpu_seconds();
  if (now - last_ > longest_gap) {
    longest_gap = now - last_;
    before = last_phase_;
    after = phase;
  }
  last_ = now;
  last_phase_ = phase;
}

void CountedCheckpoints::end() {
  pass("the end");
  measured_ = {};
}

void real_checkpoint(Context* context, std::string_view phase, std::uint64_t done,
                     std::uint64_t total) asm("__real_" PLUMB_CHECKPOINT);
void wrapped_checkpoint(Context* context, std::string_view phase, std::uint64_t done,
                        std::uint64_t total) asm("__wrap_" PLUMB_CHECKPOINT);

void wrapped_checkpoint(Context* context, std::string_view phase, std::uint64_t done,
                        std::uint64_t total) {
  CountedCheckpoints& counted = counted_checkpoints();
  counted.pass(phase);
  if (counted.left == 0) throw Error(ErrorCode::Cancelled, "cancelled");
  if (counted.left > 0) --counted.left;
  real_checkpoint(context, phase, done, total);
}

void real_check_limits(const Context* context,
                       std::string_view phase) asm("__real_" PLUMB_CHECK_LIMITS);
void wrapped_check_limits(const Context* context,
                          std::string_view phase) asm("__wrap_" PLUMB_CHECK_LIMITS);

/// Other threads of an operation call it, too.
void wrapped_check_limits(const Context* context, std::string_view phase) {
  CountedCheckpoints& counted = counted_checkpoints();
  if (counted.measures_here()) counted.pass(phase);
  real_check_limits(context, phase);
}

}  // namespace plumb::testing
