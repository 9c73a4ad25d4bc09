// A bar on standard error.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "progress_estimate.h"

namespace plumb::cli {

/// On a terminal one line, written anew ten times a second by a thread of its own, so that it goes on where an operation
/// says nothing: phase, bar and percentage of the whole command, and after a second the time left. Elsewhere prints one
/// line per phase.
class ProgressBar {
 public:
  explicit ProgressBar(bool shown);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  bool is_shown() const { return shown_; }
  /// What the command will do. See ProgressEstimate.
  void expect(ProgressStages stages);
  /// The next stage of this name. Shows the line again.
  void begin(std::string_view stage);
  /// A ProgressCallback.
  void operator()(std::string_view phase, std::uint64_t done, std::uint64_t total);
  /// A line of text where the bar is. Requires no line break in it.
  void print(std::string_view text);
  /// Wipes the line until the next stage begins, so that something else can be printed.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;

  double seconds() const;
  void name_phase(std::string_view phase);
  void draw_until(const std::stop_token& stop);
  void draw();
  void wipe();
  void draw_time(double now, std::optional<double> left);

  bool shown_;
  bool terminal_;
  Clock::time_point start_ = Clock::now();
  std::mutex mutex_;  ///< of all below
  bool is_hidden_ = false;
  bool on_line_ = false;
  std::string phase_;
  ProgressEstimate estimate_;
  std::condition_variable_any stopped_;
  std::jthread drawer_;  ///< only on a terminal
};

}  // namespace plumb::cli
