// How public functions report memory that the system refuses: as Error{ResourceLimit}, like memory that Limits refuse.
//
// A public function of the engine that allocates ends with
//
//   } catch (...) {
//     rethrow_refused_memory();
//   }
//
// unless all that allocates in it is such functions. Interior functions let std::bad_alloc pass, and so do containers that
// grow. std::bad_alloc of what a caller handed in (a callback, a stream) is reported like the engine's own.
#pragma once

#include "plumb/base/error.h"

namespace plumb {

/// In a handler: throws on what is being handled; std::bad_alloc as Error{ResourceLimit}, "out of memory". Allocates
/// nothing itself.
[[noreturn]] void rethrow_refused_memory();

/// Does the system refuse memory, rather than Limits?
bool is_refused_memory(const Error& error);

}  // namespace plumb
