// Versions, statuses, errors and contexts.
//
// report() is the only place where exceptions become statuses. It is called in a catch block and
// throws the exception again to learn its type. If there is no memory for an error object, the
// caller gets one that exists from the start and that plumb_error_free() leaves alone.
//
// A plumb_context only holds settings. Each call makes a Context of its own from them (Call), so
// that limits hold for each call, and several calls may share the settings. To cancel is an atomic
// exchange, as long as no stop callback is registered, and the engine registers none; so a signal
// handler may do it.
// Tested by tests/c/interface_test.c and tests/c/refused_memory_test.cpp.
#include <cmath>
#include <exception>
#include <new>
#include <stdexcept>

#include "handles.h"
#include "plumb/base/version.h"
#include "plumb/predicates/environment.h"

namespace plumb::c {
namespace {

/// The error that needs no memory: its texts fit into their strings.
plumb_error& error_without_memory() {
  static plumb_error error{PLUMB_OUT_OF_MEMORY, "out of memory", "out of memory", "", 0, 0};
  return error;
}

plumb_status set_error(plumb_error** error, plumb_status status, const char* message,
                       const char* text, const TextPlace& place) noexcept {
  if (error == nullptr) return status;
  try {
    *error = new plumb_error{status, message, text, place.file, place.line, place.column};
  } catch (...) {
    *error = &error_without_memory();
    return PLUMB_OUT_OF_MEMORY;
  }
  return status;
}

plumb_status set_error(plumb_error** error, plumb_status status, const char* message) noexcept {
  return set_error(error, status, message, message, TextPlace());
}

}  // namespace

plumb_status report(plumb_error** error) noexcept {
  try {
    throw;
  } catch (const Error& e) {
    return set_error(error, static_cast<plumb_status>(e.code()), e.message().c_str(), e.what(),
                     e.place());
  } catch (const std::bad_alloc&) {
    if (error != nullptr) *error = &error_without_memory();
    return PLUMB_OUT_OF_MEMORY;
  } catch (const std::length_error&) {  // A container longer than any memory.
    if (error != nullptr) *error = &error_without_memory();
    return PLUMB_OUT_OF_MEMORY;
  } catch (const std::exception& e) {
    return set_error(error, PLUMB_INTERNAL, e.what());
  } catch (...) {
    return set_error(error, PLUMB_INTERNAL, "an exception of an unknown type");
  }
}

void fail_null(const char* name) {
  throw Error(ErrorCode::BadArgument, std::string(name) + " is a null pointer");
}

void fail_argument(const std::string& message) { throw Error(ErrorCode::BadArgument, message); }

Call::Call(const plumb_context* settings) {
  if (settings == nullptr) return;
  ProgressCallback progress;
  if (settings->progress != nullptr) {
    progress = [call = settings->progress, data = settings->user_data](
                   std::string_view phase, std::uint64_t done, std::uint64_t total) {
      call(std::string(phase).c_str(), done, total, data);
    };
  }
  own_.emplace(settings->limits, settings->stop.get_token(), std::move(progress),
               settings->threads);
  watch_.emplace(*own_);
  // A stop that was requested before the call stops short calls, too.
  if (settings->stop.stop_requested()) throw Error(ErrorCode::Cancelled, "cancelled");
}

}  // namespace plumb::c

using namespace plumb;
using namespace plumb::c;

int plumb_abi_version(void) { return PLUMB_ABI_VERSION; }

const char* plumb_version(void) { return PLUMB_VERSION_STRING; }

const char* plumb_status_name(plumb_status status) {
  switch (status) {
    case PLUMB_OK:
      return "ok";
    case PLUMB_CANNOT_OPEN:
      return "cannot open";
    case PLUMB_CANNOT_WRITE:
      return "cannot write";
    case PLUMB_NOT_TEXT:
      return "not text";
    case PLUMB_SYNTAX:
      return "syntax";
    case PLUMB_NUMBER_OUT_OF_RANGE:
      return "number out of range";
    case PLUMB_COUNT_MISMATCH:
      return "count mismatch";
    case PLUMB_BAD_INDEX:
      return "bad index";
    case PLUMB_DEGENERATE_FACE:
      return "degenerate face";
    case PLUMB_UNKNOWN_FORMAT:
      return "unknown format";
    case PLUMB_USAGE:
      return "usage";
    case PLUMB_CLOSED_PIPE:
      return "closed pipe";
    case PLUMB_BAD_SHAPE:
      return "bad shape";
    case PLUMB_RESOURCE_LIMIT:
      return "resource limit";
    case PLUMB_CANCELLED:
      return "cancelled";
    case PLUMB_NOT_FINITE:
      return "not finite";
    case PLUMB_BAD_ARGUMENT:
      return "bad argument";
    case PLUMB_OUT_OF_MEMORY:
      return "out of memory";
    case PLUMB_INTERNAL:
      return "internal";
    default:
      return "unknown status";
  }
}

// --- errors -------------------------------------------------------------------------------------

plumb_status plumb_error_status(const plumb_error* error) {
  return error != nullptr ? error->status : PLUMB_OK;
}
const char* plumb_error_message(const plumb_error* error) {
  return error != nullptr ? error->message.c_str() : nullptr;
}
const char* plumb_error_text(const plumb_error* error) {
  return error != nullptr ? error->text.c_str() : nullptr;
}
const char* plumb_error_file(const plumb_error* error) {
  return error != nullptr ? error->file.c_str() : nullptr;
}
std::size_t plumb_error_line(const plumb_error* error) {
  return error != nullptr ? error->line : 0;
}
std::size_t plumb_error_column(const plumb_error* error) {
  return error != nullptr ? error->column : 0;
}
void plumb_error_free(plumb_error* error) {
  if (error != &error_without_memory()) delete error;
}

// --- contexts -----------------------------------------------------------------------------------

plumb_status plumb_context_new(plumb_context** out, plumb_error** error) {
  return make(out, error, [] { return plumb_context(); });
}

void plumb_context_free(plumb_context* context) { delete context; }

plumb_status plumb_context_set_memory_limit(plumb_context* context, std::uint64_t bytes,
                                            plumb_error** error) {
  return guarded(error, [&] { need(context, "context").limits.max_memory_bytes = bytes; });
}

plumb_status plumb_context_set_time_limit(plumb_context* context, double seconds,
                                          plumb_error** error) {
  return guarded(error, [&] {
    need(context, "context");
    if (!std::isfinite(seconds)) throw Error(ErrorCode::NotFinite, "seconds is not finite");
    if (seconds < 0) fail_argument("seconds is negative");
    context->limits.max_seconds = seconds;
  });
}

plumb_status plumb_context_set_number_limits(plumb_context* context, std::uint32_t digits,
                                             std::uint32_t exponent, plumb_error** error) {
  return guarded(error, [&] {
    need(context, "context").limits.max_number_digits = digits;
    context->limits.max_decimal_exponent = exponent;
  });
}

plumb_status plumb_context_set_threads(plumb_context* context, std::uint32_t threads,
                                       plumb_error** error) {
  return guarded(error, [&] {
    need(context, "context");
    constexpr std::uint32_t kMost = 1024;  // More would only exhaust the process.
    if (threads == 0 || threads > kMost) fail_argument("threads must be from 1 to 1024");
    context->threads = threads;
  });
}

plumb_status plumb_context_set_progress(plumb_context* context, plumb_progress progress,
                                        void* user_data, plumb_error** error) {
  return guarded(error, [&] {
    need(context, "context").progress = progress;
    context->user_data = user_data;
  });
}

void plumb_context_cancel(plumb_context* context) {
  if (context != nullptr) context->stop.request_stop();
}

bool plumb_context_is_cancelled(const plumb_context* context) {
  return context != nullptr && context->stop.stop_requested();
}

plumb_status plumb_context_reset(plumb_context* context, plumb_error** error) {
  return guarded(error, [&] { need(context, "context").stop = std::stop_source(); });
}

// --- the environment ----------------------------------------------------------------------------

plumb_status plumb_self_test(bool* is_ok, plumb_notes** notes, plumb_error** error) {
  if (notes != nullptr) *notes = nullptr;
  return guarded(error, [&] {
    need(is_ok, "is_ok");
    const SelfTestReport report = self_test();
    if (notes != nullptr) {
      plumb_notes told;
      add_notes(told, report.notes);
      add_warnings(told, report.failures);
      *notes = new plumb_notes(std::move(told));
    }
    *is_ok = report.ok;
  });
}
