#include "plumb/predicates/error.h"

#include <atomic>
#include <utility>

namespace plumb {
namespace {

std::string with_place(const std::string& message, const TextPlace& place) {
  if (place.file.empty()) return message;
  if (place.line == 0) return place.file + ": " + message;
  return place.file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column) + ": " +
         message;
}

}  // namespace

Error::Error(ErrorCode code, std::string message, TextPlace place)
    : std::runtime_error(with_place(message, place)),
      code_(code),
      message_(std::move(message)),
      place_(std::move(place)) {}

namespace {
std::atomic<InvariantHandler> invariant_handler = nullptr;
}

InvariantHandler set_invariant_handler(InvariantHandler handler) noexcept {
  return invariant_handler.exchange(handler);
}

namespace detail {

void report_broken_invariant(const char* condition, const char* file, int line) {
  if (const InvariantHandler handler = invariant_handler) handler(condition, file, line);
  throw BrokenInvariant(std::string(condition) + " does not hold (" + file + ":" +
                        std::to_string(line) + ")");
}

}  // namespace detail
}  // namespace plumb
