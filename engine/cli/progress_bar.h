// A bar on standard error.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace plumb::cli {

/// Rewrites one line on a terminal; elsewhere prints one line per phase. A ProgressCallback.
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
  bool shown_;
  bool terminal_;
  bool on_line_ = false;
  std::string phase_;
};

}  // namespace plumb::cli
