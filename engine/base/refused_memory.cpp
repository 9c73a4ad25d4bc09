#include "plumb/base/refused_memory.h"

#include <new>

#include "plumb/base/error.h"

namespace plumb {
namespace {

/// Made before memory is short. A copy allocates nothing: what() is shared, and the message is so short that a string
/// holds it inside.
const Error& out_of_memory() {
  static const Error error(ErrorCode::ResourceLimit, "out of memory");
  return error;
}

[[maybe_unused]] const Error& made_early = out_of_memory();

}  // namespace

void rethrow_refused_memory() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
  }
  throw Error(out_of_memory());
}

bool is_refused_memory(const Error& error) {
  return error.code() == ErrorCode::ResourceLimit && error.message() == out_of_memory().message();
}

}  // namespace plumb
