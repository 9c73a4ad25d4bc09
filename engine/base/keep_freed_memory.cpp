#include "plumb/base/keep_freed_memory.h"

#if defined(__GLIBC__)
#include <malloc.h>

#include <climits>
#endif

namespace plumb {

void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int kMostOfThreshold =
      32 << 20;  // glibc takes no more; larger blocks come and go by themselves
  mallopt(M_MMAP_THRESHOLD, kMostOfThreshold);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
#endif
}

}  // namespace plumb
