// Options common to all readers.
#pragma once

#include <string>

#pragma GCC visibility push(default)
namespace plumb {

/// Options that say how a text is read.
struct ReadOptions {
  std::string name = "input";  ///< The name of the file in messages.
  /// Whether numbers with a point or an exponent have exactly the value written. Otherwise each is
  /// rounded to the nearest double.
  bool exact_decimals = false;
};

}  // namespace plumb
#pragma GCC visibility pop
