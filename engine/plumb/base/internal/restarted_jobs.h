// Runs independent jobs on several threads (parallel.h) that need no more memory than one thread.
//
// Jobs that run at the same time charge and take their memory together. If a job meets a limit that
// way, it is run again when no other job runs. So the jobs succeed if a loop over them would have,
// except that GMP ends the process when the system refuses it memory.
#pragma once

#include <cstddef>
#include <functional>

#include "plumb/base/context.h"

namespace plumb {

/// Does what run_jobs() does. A job that fails with Error{ResourceLimit} or std::bad_alloc is run
/// again, after all other jobs, with all threads of the context. Requires that a job that has
/// failed can be run again: it uses up nothing, and overwrites what it has written.
void run_restarted_jobs(Context& context, std::size_t jobs,
                        const std::function<void(std::size_t, Context&)>& job);

}  // namespace plumb
