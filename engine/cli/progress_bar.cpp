#include "progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace plumb::cli {
namespace {

constexpr std::uint64_t kCells = 30;

/// done / total in units of 1 / `parts`; sums do not overflow below 2^64 / 100.
std::uint64_t share(std::uint64_t done, std::uint64_t total, std::uint64_t parts) {
  return total == 0 ? 0 : std::min(done, total) * parts / total;
}

}  // namespace

ProgressBar::ProgressBar(bool shown) : shown_(shown), terminal_(::isatty(STDERR_FILENO) == 1) {}

void ProgressBar::operator()(std::string_view phase, std::uint64_t done, std::uint64_t total) {
  if (!terminal_) {
    if (phase != phase_)
      std::fprintf(stderr, "%.*s\n", static_cast<int>(phase.size()), phase.data());
    phase_ = phase;
    return;
  }
  const auto filled = static_cast<std::size_t>(share(done, total, kCells));
  const std::string bar = std::string(filled, '#') + std::string(kCells - filled, '.');
  std::fprintf(stderr, "\r\x1b[K%-12.*s [%s] %3llu%%", static_cast<int>(phase.size()), phase.data(),
               bar.c_str(), static_cast<unsigned long long>(share(done, total, 100)));
  on_line_ = true;
}

void ProgressBar::clear() {
  if (on_line_) std::fputs("\r\x1b[K", stderr);
  on_line_ = false;
}

}  // namespace plumb::cli
