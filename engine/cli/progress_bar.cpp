#include "progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plumb::cli {
namespace {

constexpr std::uint64_t kCells = 24;  // with everything else on 79 columns

/// done / total in units of 1 / `parts`; sums do not overflow below 2^64 / 100.
std::uint64_t share(std::uint64_t done, std::uint64_t total, std::uint64_t parts) {
  return total == 0 ? 0 : std::min(done, total) * parts / total;
}

}  // namespace

ProgressBar::ProgressBar(bool shown) : shown_(shown), terminal_(::isatty(STDERR_FILENO) == 1) {}

std::string ProgressBar::time_text(const Phase& phase, std::uint64_t total) const {
  constexpr double kLongEnough = 1;  // what is said earlier jumps
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const double all = seconds_since(start_), here = seconds_since(phase.start);
  if (all < kLongEnough) return {};
  const double part = total == 0 ? 0 : static_cast<double>(phase.done) / static_cast<double>(total);
  const bool is_known = here >= kLongEnough && !phase.is_repeated && part > 0.01 && part <= 1;
  char text[48];
  std::snprintf(text, sizeof text, is_known ? "  %.0f s left" : "  %.0f s so far",
                is_known ? std::ceil(here * (1 - part) / part) : all);
  return text;
}

void ProgressBar::operator()(std::string_view name, std::uint64_t done, std::uint64_t total) {
  if (!terminal_) {
    if (name != phase_) {
      std::fprintf(stderr, "%.*s\n", static_cast<int>(name.size()), name.data());
    }
    phase_ = name;
    return;
  }
  const auto found = phases_.try_emplace(std::string(name), Phase{Clock::now()}).first;
  Phase& phase = found->second;
  phase.is_repeated |= done < phase.done;
  phase.done = done;
  const auto filled = static_cast<std::size_t>(share(done, total, kCells));
  const std::string bar = std::string(filled, '#') + std::string(kCells - filled, '.');
  std::fprintf(stderr, "\r\x1b[K%-12.34s [%s] %3llu%%%s", found->first.c_str(), bar.c_str(),
               static_cast<unsigned long long>(share(done, total, 100)),
               time_text(phase, total).c_str());
  on_line_ = true;
}

void ProgressBar::clear() {
  if (on_line_) std::fputs("\r\x1b[K", stderr);
  on_line_ = false;
}

}  // namespace plumb::cli
