// CPU time of this process.
#pragma once

#include <ctime>

namespace plumb::bench {

/// User and system time together. (The kernel measures only their sum; it divides it in two by sampling,
/// which is far off for single calls of some milliseconds.)
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

}  // namespace plumb::bench
