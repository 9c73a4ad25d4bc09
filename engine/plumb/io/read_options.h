// Options that are common to all readers.
#pragma once

#include <string>

#pragma GCC visibility push(default)
namespace plumb {

/// Options of reading a text.
struct ReadOptions {
  std::string name = "input";  ///< The name of the file in messages.
  /// Whether a number with a decimal point or an exponent is read exactly. Otherwise such a number
  /// is rounded to the nearest double.
  bool exact_decimals = false;
};

}  // namespace plumb
#pragma GCC visibility pop
