// What the process promises its surroundings: signals, memory, exit status.
#pragma once

#include <cstdint>
#include <stop_token>

namespace plumb::cli {

/// Call once, before anything else.
///   SIGINT, SIGTERM   the first requests a stop of the returned token; the second ends the process
///                     with 4 at once, temporary files removed. Also where they were ignored: a
///                     shell ignores SIGINT for what it starts in the background
///   SIGPIPE, SIGXFSZ  ignored: a failed write says so (closed pipe, file too large)
///   SIGABRT           a broken invariant, reported already: temporary files removed, exit 70
///   malloc            keeps what is freed
///   GMP               throws std::bad_alloc when memory runs out, instead of aborting
std::stop_token prepare_process();

/// Has a signal asked for a stop? For work that has no Context.
bool is_stop_requested();

/// A safety net under the accounts of Context: the address space may grow by `bytes` and a little
/// more; allocations beyond throw std::bad_alloc.
void limit_address_space(std::uint64_t bytes);

}  // namespace plumb::cli
