// How a fuzz target says that an input got past the parsing and was really judged by its oracle.
// A target whose inputs all bounce off the parser finds nothing: replay fails on that, and fuzz/run
// prints the share.
#pragma once

#include <cstdint>
#include <cstdio>

namespace plumb::fuzz {

/// Inputs of this process, and those of them that were compared with the oracle. Told on stderr
/// when the process ends of itself.
struct OracleShare {
  std::uint64_t inputs = 0;
  std::uint64_t reached = 0;
  bool counts = false;  ///< the present input is not among those reached yet

  ~OracleShare() {
    if (inputs == 0) return;
    std::fprintf(stderr, "stat::oracle_reached: %llu of %llu inputs, %.1f%%\n",
                 static_cast<unsigned long long>(reached), static_cast<unsigned long long>(inputs),
                 100.0 * static_cast<double>(reached) / static_cast<double>(inputs));
  }
};
inline OracleShare oracle_share;

/// Call first of all with every input.
inline void begin_input() {
  ++oracle_share.inputs;
  oracle_share.counts = true;
}

/// Call where the comparison with the oracle begins; an input counts once.
inline void oracle_reached() {
  oracle_share.reached += oracle_share.counts ? 1 : 0;
  oracle_share.counts = false;
}

}  // namespace plumb::fuzz
