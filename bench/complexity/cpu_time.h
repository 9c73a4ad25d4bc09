// CPU time of this process.
#pragma once

#include <malloc.h>

#include <algorithm>
#include <ctime>

namespace plumb::bench {

/// Memory that is freed stays with the process. Otherwise every run of a large size, and of no
/// small one, waits for the kernel to clear pages: system time, which cpu_seconds() cannot tell
/// from user time.
inline void keep_freed_memory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
}

/// User and system time together. (The kernel measures only their sum; it divides it in two by
/// sampling, which is far off for single calls of some milliseconds.)
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

/// Seconds of one run: `once()` works and says how long it took. Other programs disturb caches:
/// short runs are batched to 40 ms or more, and the least of three batches counts.
template <class Once>
double least_seconds(Once once) {
  double least = 1e300;
  for (int batch = 0; batch < 3; ++batch) {
    double sum = 0;
    int runs = 0;
    for (; sum < 0.04; ++runs) sum += once();
    least = std::min(least, sum / runs);
    if (sum > 4) break;
  }
  return least;
}

}  // namespace plumb::bench
