// Counts what a piece of work costs: time, and work that is the same on a busy machine.
#pragma once

#include <cstddef>
#include <cstdint>

#include "plumb/predicates/input/rung_counters.h"

namespace plumb::bench {

struct Cost {
  double seconds = 0;       ///< CPU time of this process, user and system
  double instructions = 0;  ///< retired in user mode; 0 where the system does not count them
  double allocations = 0;   ///< calls of operator new
  double bytes = 0;         ///< what they asked for
  double predicates = 0;    ///< calls of predicates; 0 where the build does not count them
  RungCounts rungs{};       ///< the same by predicate and by the rung that decided
};

/// One work may be started and stopped several times, to leave out what does not belong to it. It
/// has to run on the thread that starts and stops: calls of predicates on other threads are not
/// seen.
class Meter {
 public:
  Meter();
  ~Meter();
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;

  void start();
  void stop();
  /// Between start() and stop() since the last call.
  Cost take();

  bool counts_instructions() const { return counter_ >= 0; }

 private:
  std::uint64_t instructions_now() const;

  int counter_ = -1;  ///< of the kernel
  Cost begin_;        ///< without `predicates`, which are the sum of `rungs`
  Cost sum_;
};

}  // namespace plumb::bench
