// What every reader is told besides the text.
#pragma once

#include <string>

#pragma GCC visibility push(default)
namespace plumb {

/// How a text is read.
struct ReadOptions {
  std::string name = "input";   ///< the file in messages
  bool exact_decimals = false;  ///< numbers with a point or exponent exactly as written
};

}  // namespace plumb
#pragma GCC visibility pop
