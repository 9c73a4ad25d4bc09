// Independent jobs on several threads, with the result of one thread.
//
// Every job has a Context of its own, which shares limits, time, charged memory and the stop of the
// given one. Jobs are begun in order. If one fails, those after it are stopped or not begun, those
// before it are finished, and the error of the first one that failed is thrown, which is the error
// that a loop would have thrown.
//
// The jobs have to make results deterministic: each writes to places of its own, and a caller that
// needs one sequence joins the parts in the order of the jobs. Memory is the exception: jobs at the
// same time charge it together, so a limit may be reached with several threads where it is not with
// one.
#pragma once

#include <cstddef>
#include <functional>

#include "plumb/base/context.h"

namespace plumb {

/// Calls job(i, context of the job) for i = 0 ... jobs - 1, at most context.threads() at a time,
/// the caller's thread among them; with one thread this is a loop. Progress is reported from the
/// caller's thread alone. If there are fewer jobs than threads, the jobs may use the threads that
/// are left. Cost: about 30 microseconds a thread.
void run_jobs(Context& context, std::size_t jobs,
              const std::function<void(std::size_t, Context&)>& job);

}  // namespace plumb
