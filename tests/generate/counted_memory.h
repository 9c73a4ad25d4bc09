// operator new and delete that count, and that can be made to fail. A program has them by linking
// plumb_counted_memory; it may use them in one thread.
#pragma once

#include <cstdint>

namespace plumb::testing {

struct CountedMemory {
  std::uint64_t allocations = 0;  ///< so far, those that failed included
  std::uint64_t bytes = 0;        ///< what they asked for
  std::int64_t held = 0;          ///< blocks not given back
  std::int64_t left = -1;         ///< allocations that succeed; negative: all
};

/// Of this program.
CountedMemory& counted_memory();

}  // namespace plumb::testing
