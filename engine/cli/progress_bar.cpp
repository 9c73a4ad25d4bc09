#include "progress_bar.h"

#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <optional>
#include <system_error>
#include <utility>

namespace plumb::cli {
namespace {

// With everything else on 79 columns.
constexpr std::string_view kFull = "########################";
constexpr std::string_view kEmpty = "........................";

/// Threads started meanwhile get no signals: those are to interrupt what the first thread waits for.
class BlockedSignals {
 public:
  BlockedSignals() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~BlockedSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

 private:
  sigset_t before_;
};

}  // namespace

ProgressBar::ProgressBar(bool shown) : shown_(shown), terminal_(::isatty(STDERR_FILENO) == 1) {
  if (!shown_ || !terminal_) return;
  const BlockedSignals blocked;
  try {
    drawer_ = std::jthread([this](const std::stop_token& stop) { draw_until(stop); });
  } catch (const std::system_error&) {  // no thread to be had: no bar
  }
}

ProgressBar::~ProgressBar() {
  drawer_ = {};
  clear();
}

double ProgressBar::seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void ProgressBar::expect(ProgressStages stages) {
  const std::lock_guard lock(mutex_);
  estimate_.expect(std::move(stages));
}

void ProgressBar::begin(std::string_view stage) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  is_hidden_ = false;
  estimate_.begin(stage, seconds());
  name_phase(stage);
}

void ProgressBar::operator()(std::string_view phase, std::uint64_t done, std::uint64_t total) {
  const std::lock_guard lock(mutex_);
  estimate_.tell(phase, done, total, seconds());
  name_phase(phase);
}

void ProgressBar::name_phase(std::string_view phase) {
  if (phase == phase_) return;
  phase_ = phase;
  if (!terminal_) std::fprintf(stderr, "%s\n", phase_.c_str());
}

void ProgressBar::draw_until(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kBetween(100);
  std::unique_lock lock(mutex_);
  while (!stopped_.wait_for(lock, stop, kBetween, [&] { return stop.stop_requested(); })) draw();
}

/// Allocates nothing: a thread's own heap would count against --limit-memory.
void ProgressBar::draw() {
  if (is_hidden_ || phase_.empty()) return;
  const double now = seconds();
  const auto [part, left] = estimate_.at(now);
  const int filled = static_cast<int>(part * static_cast<double>(kFull.size()));
  std::fprintf(stderr, "\r\x1b[K%-12.34s [%.*s%.*s] %3.0f%%", phase_.c_str(), filled, kFull.data(),
               static_cast<int>(kEmpty.size()) - filled, kEmpty.data(), std::floor(part * 100));
  draw_time(now, left);
  on_line_ = true;
}

void ProgressBar::draw_time(double now, std::optional<double> left) {
  constexpr double kLongEnough = 1;  // what is said earlier jumps
  if (now < kLongEnough) return;
  std::fprintf(stderr, left ? "  %.0f s left" : "  %.0f s so far", left ? std::ceil(*left) : now);
}

void ProgressBar::print(std::string_view text) {
  const std::lock_guard lock(mutex_);
  wipe();
  std::fprintf(stderr, "%.*s\n", static_cast<int>(text.size()), text.data());
}

void ProgressBar::clear() {
  const std::lock_guard lock(mutex_);
  is_hidden_ = true;
  wipe();
}

void ProgressBar::wipe() {
  if (on_line_) std::fputs("\r\x1b[K", stderr);
  on_line_ = false;
}

}  // namespace plumb::cli
