// How public functions report memory that the system refuses: as Error{ResourceLimit}, like memory that Limits refuse.
//
// A public function of the engine that allocates ends with
//
//   } catch (...) {
//     rethrow_refused_memory();
//   }
//
// unless all that allocates in it is such functions. Interior functions let std::bad_alloc pass.
#pragma once

namespace plumb {

/// In a handler: throws on what is being handled; std::bad_alloc and std::length_error as
/// Error{ResourceLimit}, "out of memory". Allocates nothing itself.
[[noreturn]] void rethrow_refused_memory();

}  // namespace plumb
