// Independent jobs on several threads, with the result of one thread.
//
// Every job has a Context of its own, which shares limits, time, charged memory and the stop of the
// one given. Jobs are begun in order. When one fails, those after it are stopped or not begun,
// those before it are finished, and the error of the first that failed is thrown: that which a loop
// would have thrown.
//
// Deterministic results are up to the jobs: each writes what is its own, and whoever needs one
// sequence puts the parts together in the order of the jobs. Memory is the exception: jobs at the
// same time charge it together, so that a limit may be met with more threads where it is not with
// one.
#pragma once

#include <cstddef>
#include <functional>

#include "plumb/base/context.h"

namespace plumb {

/// job(i, context of the job) for i = 0 ... jobs - 1, at most context.threads() at a time, the
/// caller's thread among them; with one thread a loop. Progress is reported from the caller's
/// thread alone. The threads that are left over, jobs being few, are the jobs' own. Cost: ~30
/// microseconds a thread.
void run_jobs(Context& context, std::size_t jobs,
              const std::function<void(std::size_t, Context&)>& job);

}  // namespace plumb
