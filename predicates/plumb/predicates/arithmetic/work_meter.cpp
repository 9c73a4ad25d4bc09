#include "plumb/predicates/arithmetic/work_meter.h"

#include <algorithm>
#include <utility>

namespace plumb::detail {
namespace {

// The unit is the product of two limbs. The slowest operations are greatest common divisors of
// numbers of some hundred limbs. They take about 1 nanosecond for each unit.
constexpr std::uint64_t kProductsBetweenCalls = 2'000'000;
// The cost of the smallest operation.
constexpr std::uint64_t kLeastProducts = 64;
// The square of a greater number of limbs would exceed every bound.
constexpr std::uint64_t kMostLimbs = std::uint64_t{1} << 20;

struct Meter {
  WorkHook hook;
  std::uint64_t products = 0;
};

thread_local Meter meter;

}  // namespace

WorkHook exchange_work_hook(WorkHook hook) noexcept {
  meter.products = 0;
  return std::exchange(meter.hook, hook);
}

void count_work(std::uint64_t limbs) {
  if (meter.hook.call == nullptr) return;
  const std::uint64_t counted = std::min(limbs, kMostLimbs);
  meter.products += counted * counted + kLeastProducts;
  if (meter.products < kProductsBetweenCalls) return;
  meter.products = 0;
  meter.hook.call(meter.hook.state);
}

}  // namespace plumb::detail
