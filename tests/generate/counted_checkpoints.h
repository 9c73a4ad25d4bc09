// Context::checkpoint() and check_limits(), counted, and the first made to cancel. A program has it
// by linking plumb_counted_checkpoints, whose calls the linker then leads here first; in programs
// whose plumb is a static library.
#pragma once

#include <cstdint>
#include <string_view>
#include <thread>

namespace plumb::testing {

struct CountedCheckpoints {
  std::uint64_t passed = 0;        ///< so far
  std::int64_t left = -1;          ///< those that are passed before one cancels; negative: all
  double longest_gap = 0;          ///< between two since begin(), in seconds of CPU time
  std::string_view before, after;  ///< the phases that these two named

  void begin();
  void end();  ///< The end of what is measured ends a gap, too.
  void pass(std::string_view phase);
  /// Whether the calling thread is between begin() and end().
  bool measures_here() const { return std::this_thread::get_id() == measured_; }

 private:
  std::thread::id measured_;
  double last_ = 0;
  std::string_view last_phase_;
};

/// Of this program; to be used in one thread.
CountedCheckpoints& counted_checkpoints();

}  // namespace plumb::testing
