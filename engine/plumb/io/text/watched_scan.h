// Searches of texts that a hostile file may make long: one number of a hundred million digits, or
// as many blanks.
#pragma once

#include <algorithm>
#include <cstddef>

#include "plumb/base/context.h"

namespace plumb {

/// Returns the first character of [first, last) for which `ends` holds; `last` if there is none.
/// Checks the limits of the context after each megabyte.
template <class Ends>
const char* find_watched(const char* first, const char* last, const Context& context, Ends ends) {
  constexpr std::ptrdiff_t kBytesPerCheckpoint = std::ptrdiff_t{1} << 20;
  while (last - first > kBytesPerCheckpoint) {
    const char* const stop = first + kBytesPerCheckpoint;
    const char* const found = std::find_if(first, stop, ends);
    if (found != stop) return found;
    context.check_limits("read");
    first = stop;
  }
  return std::find_if(first, last, ends);
}

}  // namespace plumb
