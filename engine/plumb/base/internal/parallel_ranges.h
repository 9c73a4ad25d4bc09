// Divides a range of items among threads (parallel.h).
#pragma once

#include <algorithm>
#include <cstddef>

#include "plumb/base/context.h"
#include "plumb/base/internal/parallel.h"

namespace plumb {

/// Returns into how many ranges run_ranges() divides `count` items: one with one thread or if there
/// are fewer than 2 * `least` items; else at most four for each thread, so that uneven ranges
/// balance, of at least `least` items.
inline std::size_t count_ranges(const Context& context, std::size_t count, std::size_t least) {
  constexpr std::size_t kRangesAThread = 4;
  if (context.threads() == 1) return 1;
  return std::clamp<std::size_t>(count / std::max<std::size_t>(least, 1), 1,
                                 kRangesAThread * context.threads());
}

/// Calls work(range, begin, end, context) for consecutive ranges that together are 0 ... count - 1,
/// each as a job. `least` is the number of items that are worth a job. Which items make a range
/// depends on the number of threads; the caller's result must not. Throws what run_jobs() throws.
template <class Work>
void run_ranges(Context& context, std::size_t count, std::size_t least, const Work& work) {
  const std::size_t ranges = count_ranges(context, count, least);
  const std::size_t longer = count % ranges, length = count / ranges;
  run_jobs(context, ranges, [&](std::size_t i, Context& own) {
    const std::size_t begin = i * length + std::min(i, longer);
    work(i, begin, begin + length + (i < longer ? 1 : 0), own);
  });
}

}  // namespace plumb
