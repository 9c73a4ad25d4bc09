// Options that are common to all readers, and to all writers.
#pragma once

#include <cstdint>
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

/// How a writer rounds coordinates that its format cannot hold.
enum class OutputRounding : std::uint8_t {
  Valid,    ///< To numbers with which the written mesh or polygons are valid.
  Nearest,  ///< To the nearest numbers, even if faces or edges then cross.
};

}  // namespace plumb
#pragma GCC visibility pop
