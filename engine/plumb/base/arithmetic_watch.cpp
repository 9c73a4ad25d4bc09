#include "plumb/base/arithmetic_watch.h"

#include "plumb/predicates/arithmetic/work_meter.h"

namespace plumb {
namespace {

void check(const void* context) {
  static_cast<const Context*>(context)->check_limits("exact arithmetic");
}

}  // namespace

ArithmeticWatch::ArithmeticWatch(const Context& context) {
  const detail::WorkHook before = detail::exchange_work_hook({check, &context});
  check_before_ = before.call;
  context_before_ = before.state;
}

ArithmeticWatch::~ArithmeticWatch() {
  detail::exchange_work_hook({check_before_, context_before_});
}

bool ArithmeticWatch::is_active() {
  const detail::WorkHook hook = detail::exchange_work_hook({});
  detail::exchange_work_hook(hook);
  return hook.call != nullptr;
}

}  // namespace plumb
