// A bar on standard error.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace plumb::cli {

/// Rewrites one line on a terminal: phase, bar, percentage, and how long the phase will take still, once it has run
/// long enough to tell. Elsewhere prints one line per phase. A ProgressCallback.
class ProgressBar {
 public:
  explicit ProgressBar(bool shown);
  ~ProgressBar() { clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  bool is_shown() const { return shown_; }
  void operator()(std::string_view phase, std::uint64_t done, std::uint64_t total);
  /// Wipes the line, so that something else can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  struct Phase {
    Clock::time_point start;
    std::uint64_t done = 0;
    bool is_repeated = false;  ///< a part of something longer: its end says nothing
  };

  /// "12 s left", or how long all has taken when that is what one can say.
  std::string time_text(const Phase& phase, std::uint64_t total) const;

  bool shown_;
  bool terminal_;
  bool on_line_ = false;
  std::string phase_;
  std::map<std::string, Phase, std::less<>> phases_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace plumb::cli
