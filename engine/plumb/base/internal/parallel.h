// Runs independent jobs on several threads. The result is the same as on one thread.
//
// Every job has a Context of its own. This context shares the limits, the start time, the charged
// memory and the stop request of the caller's context. Jobs begin in the order of their indices. If
// a job fails, the jobs with greater indices are stopped or not begun, and the jobs with smaller
// indices are finished. Then the error of the failed job with the least index is thrown. A loop
// over the jobs would have thrown the same error.
//
// The jobs are responsible for deterministic results. Each job writes to memory of its own. A
// caller that needs one sequence joins the parts in the order of the jobs. Only the memory limit
// can make a difference: jobs that run at the same time charge their memory together. Therefore
// several threads may exceed a limit that one thread would not exceed.
#pragma once

#include <cstddef>
#include <functional>

#include "plumb/base/context.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Calls job(i, context of the job) for i = 0 ... jobs - 1. At most context.threads() jobs run at
/// the same time, each on a thread of its own. One of these threads is the caller's thread. With
/// one thread, the function is a loop over the jobs. Only jobs on the caller's thread report
/// progress. If there are fewer jobs than threads, the jobs may use the remaining threads. Cost:
/// about 30 microseconds per thread.
void run_jobs(Context& context, std::size_t jobs,
              const std::function<void(std::size_t, Context&)>& job);

}  // namespace plumb
#pragma GCC visibility pop
