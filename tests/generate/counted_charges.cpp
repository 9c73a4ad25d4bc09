#include "generate/counted_charges.h"

#include <algorithm>
#include <string_view>

#include "plumb/base/context.h"

// As in counted_checkpoints.cpp.
#define PLUMB_CHARGE "_ZN5plumb7Context13charge_memoryEmSt17basic_string_viewIcSt11char_traitsIcEE"
#define PLUMB_RELEASE "_ZN5plumb7Context14release_memoryEm"

namespace plumb::testing {

CountedCharges& counted_charges() {
  static CountedCharges counted;
  return counted;
}

void real_charge(Context* context, std::uint64_t bytes,
                 std::string_view what) asm("__real_" PLUMB_CHARGE);
void wrapped_charge(Context* context, std::uint64_t bytes,
                    std::string_view what) asm("__wrap_" PLUMB_CHARGE);
void real_release(Context* context, std::uint64_t bytes) asm("__real_" PLUMB_RELEASE);
void wrapped_release(Context* context, std::uint64_t bytes) asm("__wrap_" PLUMB_RELEASE);

void wrapped_charge(Context* context, std::uint64_t bytes, std::string_view what) {
  real_charge(context, bytes, what);
  CountedCharges& counted = counted_charges();
  counted.held_bytes += static_cast<std::int64_t>(bytes);
  counted.peak_bytes = std::max(counted.peak_bytes, counted.held_bytes);
}

void wrapped_release(Context* context, std::uint64_t bytes) {
  counted_charges().held_bytes -= static_cast<std::int64_t>(bytes);
  real_release(context, bytes);
}

}  // namespace plumb::testing
