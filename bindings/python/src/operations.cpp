// How an operation runs under Python: its limits, its signals and its progress.
//
// Python's handlers of signals run on the main thread only, and only with the GIL. The callback of
// the context is called at most 20 times a second on the thread of the operation, so that Ctrl-C
// takes effect within a twentieth of a second after the next checkpoint. Operations on other
// threads without a callback never ask for the GIL. tests/test_threads.py and
// tests/test_signals.py test it.
#include "binding.h"

namespace plumb::python {
namespace {

bool is_main_thread() {
  static const auto main_ident = nb::cast<unsigned long>(
      nb::module_::import_("threading").attr("main_thread")().attr("ident"));
  return PyThread_get_thread_ident() == main_ident;
}

}  // namespace

Limits CallLimits::limits() const {
  Limits limits;
  if (timeout) {
    if (!(*timeout > 0)) throw Error(ErrorCode::BadArgument, "timeout must be positive");
    limits.max_seconds = *timeout;
  }
  if (memory_limit) limits.max_memory_bytes = *memory_limit;
  return limits;
}

ProgressCallback Watcher::callback() {
  if (progress_.is_none() && !is_main_thread()) return {};
  return [this](std::string_view phase, std::uint64_t done, std::uint64_t total) {
    look(phase, done, total);
  };
}

void Watcher::look(std::string_view phase, std::uint64_t done, std::uint64_t total) {
  const nb::gil_scoped_acquire gil;
  if (problem_) return;
  try {
    if (PyErr_CheckSignals() != 0) throw nb::python_error();
    if (!progress_.is_none()) progress_(nb::str(phase.data(), phase.size()), done, total);
  } catch (...) {
    problem_ = std::current_exception();
    stop_.request_stop();
  }
}

}  // namespace plumb::python
