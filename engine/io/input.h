// Whole input files in memory.
#pragma once

#include <string>

#include "plumb/base/context.h"

namespace plumb {

/// The bytes of the file `path`, or of standard input when `path` is "-". The memory is charged
/// to `context` before it is allocated and stays charged; release it with the string.
/// Errors: CannotOpen with the system's reason ("FILE: reason"), ResourceLimit.
std::string read_input(const std::string& path, Context& context);

/// What `path` is called in messages: itself, or "stdin" for "-".
std::string input_name(const std::string& path);

}  // namespace plumb
