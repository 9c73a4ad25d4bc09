#include "plumb/base/refused_memory.h"

#include <new>
#include <stdexcept>

#include "plumb/base/error.h"

namespace plumb {
namespace {

/// Made before memory is short. A copy allocates nothing: what() is shared, and the message is so short that a string
/// holds it inside.
const Error& out_of_memory() {
  static const Error error(ErrorCode::ResourceLimit, "out of memory");
  return error;
}

[[maybe_unused]] const Error& kMadeEarly = out_of_memory();

}  // namespace

void rethrow_refused_memory() {
  try {
    throw;
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  throw Error(out_of_memory());
}

}  // namespace plumb
