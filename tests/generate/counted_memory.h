// operator new and delete that count, and that can be made to fail. A program has them by linking
// plumb_counted_memory; it may use them in one thread.
#pragma once

#include <cstdint>
#include <utility>

namespace plumb::testing {

struct CountedMemory {
  std::uint64_t allocations = 0;  ///< so far, those that failed included
  std::uint64_t bytes = 0;        ///< what they asked for
  std::int64_t held = 0;          ///< blocks not given back
  std::int64_t held_bytes = 0;    ///< what they take
  std::int64_t peak_bytes = 0;    ///< the most since this was set to held_bytes
  std::int64_t left = -1;         ///< allocations that succeed; negative: all
};

/// Of this program.
CountedMemory& counted_memory();

/// From now on numbers of GMP and MPFR are counted, too; they never fail. To be called before there
/// are any.
void count_numbers();

/// make(), without refusals: what is the caller's own.
template <class Make>
auto unrefused(Make make) {
  struct Restore {
    std::int64_t left = std::exchange(counted_memory().left, -1);
    ~Restore() { counted_memory().left = left; }
  } restore;
  return make();
}

/// A copy for a parameter that is taken by value.
template <class T>
T own_copy(const T& of) {
  return unrefused([&of] { return T(of); });
}

}  // namespace plumb::testing
