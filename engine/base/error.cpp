#include "plumb/base/error.h"

#include <cstdio>
#include <cstdlib>
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

namespace detail {

void report_broken_invariant(const char* condition, const char* file, int line) {
  std::fprintf(stderr,
               "plumb: internal error: %s does not hold (%s:%d).\n"
               "This is a bug in plumb. Please report it with the input and the command line.\n",
               condition, file, line);
  std::abort();
}

}  // namespace detail
}  // namespace plumb
