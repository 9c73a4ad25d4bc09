// What is charged to Contexts, counted. A program has it by linking plumb_counted_charges, whose
// calls the linker then leads here first; in programs whose plumb is a static library.
#pragma once

#include <cstdint>

namespace plumb::testing {

struct CountedCharges {
  std::int64_t held_bytes = 0;  ///< charged and not given back
  std::int64_t peak_bytes = 0;  ///< the most since this was set to held_bytes
};

/// Of this program; to be used in one thread.
CountedCharges& counted_charges();

}  // namespace plumb::testing
