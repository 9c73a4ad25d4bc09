// User CPU time of this process.
#pragma once

#include <sys/resource.h>

namespace plumb::bench {

inline double user_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) +
         static_cast<double>(usage.ru_utime.tv_usec) * 1e-6;
}

}  // namespace plumb::bench
