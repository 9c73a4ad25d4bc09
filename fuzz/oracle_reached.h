// How a fuzz target says that an input got past the parsing and was really judged by its oracle.
// A target whose inputs all bounce off the parser finds nothing: replay fails on that.
#pragma once

#include <cstdint>

namespace plumb::fuzz {

/// Inputs of this process that were compared with the oracle.
inline std::uint64_t oracle_reached_count = 0;

/// Call once per input, where the comparison with the oracle begins.
inline void oracle_reached() { ++oracle_reached_count; }

}  // namespace plumb::fuzz
