// Progress of commands: the estimate, the stages of all commands with their shares, and the bar.
//
// The estimate multiplies the sum of the remaining shares by the pace so far. As a step advances,
// its own reports replace its share. The estimated end is smoothed over a couple of seconds, and
// the displayed part never decreases. Shares were measured on inputs of the sizes noted below. The
// bar is drawn by its own thread. This thread blocks signals, so that they interrupt the first
// thread when it waits. It allocates nothing, because a heap of its own would count against
// --limit-memory.
// Tested by tests/cli/program_test.cpp.
#include "plumb/cli/session/progress.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <optional>
#include <system_error>
#include <utility>

#include "plumb/cli/session/process.h"

namespace plumb::cli {

void ProgressEstimate::expect(ProgressStages stages) {
  stages_ = std::move(stages);
  next_ = 0;
  is_in_step_ = false;
}

void ProgressEstimate::Report::note(std::uint64_t so_far, std::uint64_t total) {
  if (total == 0) return;
  const double now_done = std::min(1.0, static_cast<double>(so_far) / static_cast<double>(total));
  // If less than half of the former part is done, more work was found, or the phase began again.
  starts_over |= done && now_done < *done / 2;
  done = now_done;
}

/// Enters a step. The step before counts as completed if it was reported, or if it never reports.
void ProgressEstimate::enter(std::size_t stage, std::size_t step, double now) {
  if (is_in_step_) been_ += this->step().share;
  next_ = stage + 1;
  step_ = step;
  is_in_step_ = this->step().phase.empty();
  report_ = {.since = now};
  other_.reset();
  other_phase_.clear();
}

void ProgressEstimate::begin(std::string_view name, double now) {
  for (std::size_t i = next_; i < stages_.size(); ++i) {
    if (stages_[i].name == name) return enter(i, 0, now);
  }
}

void ProgressEstimate::tell(std::string_view phase, std::uint64_t done, std::uint64_t total,
                            double now) {
  if (!has_begun()) return;
  const std::vector<ProgressStep>& steps = stages_[next_ - 1].steps;
  const auto at = std::find_if(steps.begin() + static_cast<std::ptrdiff_t>(step_), steps.end(),
                               [&](const ProgressStep& step) { return step.phase == phase; });
  if (at != steps.end()) {
    const auto step = static_cast<std::size_t>(at - steps.begin());
    if (step != step_) enter(next_ - 1, step, now);
    is_in_step_ = true;
    return report_.note(done, total);
  }
  if (!other_ || other_phase_ != phase) {
    other_phase_ = phase;
    other_ = Report{.since = now};
  }
  other_->note(done, total);
}

double ProgressEstimate::share_to_come() const {
  double sum = 0;
  for (std::size_t i = next_ - 1, first = step_ + 1; i < stages_.size(); ++i, first = 0) {
    for (std::size_t k = first; k < stages_[i].steps.size(); ++k) sum += stages_[i].steps[k].share;
  }
  return sum;
}

double ProgressEstimate::Report::left(double expected, double now) const {
  constexpr double kTrusted = .05;  // From this part on, only the pace of the phase counts.
  const double taken = now - since, by_share = std::max(expected - taken, taken / 4);
  if (!is_known()) return by_share;
  const double trust = std::min(1.0, *done / kTrusted);
  return trust * taken * (1 - *done) / *done + (1 - trust) * by_share;
}

std::optional<double> ProgressEstimate::left(double now) const {
  if (!has_begun()) return std::nullopt;
  const bool is_known = report_.is_known();
  double shares = been_ + (is_known ? *report_.done * step().share : 0);
  const bool counts_step = is_known || shares <= 0;
  // This value is a guess, because nothing is known yet.
  if (shares <= 0) shares = step().share / 2;
  const double pace = (counts_step ? now : report_.since) / shares;
  const double of_step = report_.left(pace * step().share, now);
  return std::max(of_step, other_ ? other_->left(0, now) : 0) + pace * share_to_come();
}

ProgressEstimate::View ProgressEstimate::at(double now) {
  constexpr double kMemory = 2;    // In seconds.
  constexpr double kEarlier = .2;  // A part of the elapsed time. It applies if it is shorter.
  const std::optional<double> left = this->left(now);
  if (!left) return {part_, std::nullopt};
  const double end = now + *left, memory = std::min(kMemory, kEarlier * now);
  if (!end_) end_ = end;
  *end_ += (end - *end_) * (1 - std::exp(-(now - asked_) / memory));
  *end_ = std::max(*end_, now + *left / 2);
  asked_ = now;
  part_ = std::max(part_, now / *end_);
  return {part_, *end_ - now};
}

ProgressStage writing() { return {"write", {{"", .5}}}; }

// Measured on maps of 1,440,000 squares; overlays on maps of 90,000.
ProgressStage reading_map() { return {"read", {{"load", .2}, {"read", .5}}}; }
ProgressStage checking_map() {
  return {"check", {{"match edges", 1.3}, {"sweep", 1}, {"faces", .3}}};
}
ProgressStage overlaying_maps() {
  return {"overlay", {{"sweep", 12}, {"areas of regions", 22}, {"areas of cells", 115}}};
}
ProgressStage repairing_layer() {
  return {"repair", {{"sweep", 4}, {"cells of the layer", 1}, {"areas", 1}, {"polygons", 1}}};
}
ProgressStage auditing_map() { return {"audit", {{"", 1.9}}}; }
ProgressStage drawing_map() { return {"draw", {{"", 2}}}; }

// Measured on stars of 1,500,000 corners.
ProgressStage reading_plane() { return {"read", {{"load", .2}, {"read", 1}, {"sweep", 2.3}}}; }
ProgressStage combining_plane() { return {"combine", {{"sweep", 1.7}}}; }
ProgressStage measuring_plane() { return {"measure", {{"area", 2.7}}}; }
ProgressStage locating_plane() { return {"locate", {{"", 5.7}}}; }
ProgressStage auditing_plane() { return {"audit", {{"read", 1}, {"sweep", 2.3}, {"audit", 2.4}}}; }
ProgressStage drawing_plane() { return {"draw", {{"", 60}}}; }
ProgressStages writing_plane_text() {
  return {{"result", {{"", .4}, {"round", .7}, {"sweep", .8}, {"parts", .4}, {"shapes", 1.8}}},
          {"write", {{"", .2}}}};
}
ProgressStages writing_nef2() { return {{"write", {{"", 1.6}}}}; }
ProgressStages writing_plane_picture() { return {{"write", {{"", 60}}}}; }

// Measured on spheres of 480,000 triangles.
ProgressStage reading_solid() {
  return {"read",
          {{"load", .1},
           {"read", 1.1},
           {"reading faces", 1.5},
           {"planes of faces", .4},
           {"linking facets", .5},
           {"components", .3},
           {"crossings of the mesh with itself", 1.7},
           {"volumes", .2}}};
}
ProgressStage combining_solids() {
  return {"combine",
          {{"", .9},
           {"box trees", .4},
           {"contacts", .3},
           {"vertices that stay", .6},
           {"assemble", .4},
           {"volumes", .1}}};
}
ProgressStage intersecting_half_spaces() {
  return {"combine", {{"planes", 3}, {"half-spaces", 19}}};
}
ProgressStage numbering_solid() {
  return {"number",
          {{"order of vertices", 1.3},
           {"order of edges", .2},
           {"order of facets", .2},
           {"order of uses", .2},
           {"order of volumes", .2},
           {"names of planes", 15},
           {"names of points", 1.3}}};
}
ProgressStage measuring_solid() { return {"measure", {{"", .3}, {"measures", 22}}}; }
ProgressStage mending_mesh() {
  return {"mend", {{"load", .1}, {"read", 1.1}, {"weld", .3}, {"orientation", 1}, {"", 1}}};
}
ProgressStage locating_solid() { return {"locate", {{"", .5}}}; }
ProgressStage auditing_solid() {
  return {"audit",
          {{"read", 1.1},
           {"reading faces", 1.5},
           {"planes of faces", .4},
           {"linking facets", .5},
           {"components", .3},
           {"crossings of the mesh with itself", 1.7},
           {"audit", 7}}};
}
ProgressStage drawing_solid() { return {"draw", {{"", .5}, {"facets", 5}}}; }
ProgressStages writing_mesh() {
  return {{"result", {{"faces of the mesh", .6}, {"crossings of the mesh with itself", .5}}},
          {"write", {{"", 1}}}};
}
ProgressStages writing_nef() { return {{"write", {{"", 10}}}}; }

// Measured on the same spheres, not convex; pieces and sums on solids of some thousand triangles,
// whose reading takes no time in comparison.
ProgressStage checking_convexity() {
  return {"convexity",
          {{"convexity", .3},
           {"reading faces", 1.5},
           {"planes of faces", .4},
           {"linking facets", .5},
           {"components", .3},
           {"crossings of the mesh with itself", 1.7},
           {"faces", 26}}};
}
ProgressStage cutting_solid() { return {"cut", {{"cutting", 1000}, {"merging", 20}}}; }
ProgressStage writing_pieces() { return {"pieces", {{"pieces", 1500}}}; }
ProgressStage drawing_pieces() { return {"draw", {{"", 100}}}; }
ProgressStage adding_solids() {
  return {"combine", {{"", 20}, {"sums of parts", 400}, {"box trees", 1200}}};
}

ProgressStages stages_of_surfaces() {
  return {{"read", {{"load", .1}, {"read", .2}, {"trace", 2.3}}},
          {"divide", {{"slice", .2}, {"labels", .1}}},
          {"result", {{"triangulate", 1.5}}},
          {"write", {{"", 1}}}};
}

ProgressStages stages_of_demo() {
  ProgressStages stages;
  for (const double seconds : {.6, .5, .5, 1.6, 7., .1, 3.5, 8.}) {
    stages.push_back({"chapter", {{"", seconds}}});
  }
  stages.push_back({"write", {{"", 1.9}}});
  return stages;
}

namespace {

// With the rest of the line, the bar fills 79 columns.
constexpr std::string_view kFull = "########################";
constexpr std::string_view kEmpty = "........................";

}  // namespace

ProgressBar::ProgressBar(bool shown) : shown_(shown), terminal_(::isatty(STDERR_FILENO) == 1) {
  if (!shown_ || !terminal_) return;
  const process::BlockedSignals blocked;
  try {
    drawer_ = std::jthread([this](const std::stop_token& stop) { draw_until(stop); });
  } catch (const std::system_error&) {  // No thread is available, so there is no bar.
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

namespace {

/// Whether the line of a bar is on the terminal, or is about to be written. Signal handlers read
/// this variable.
std::atomic<bool> is_bar_drawn = false;
/// Whether a signal handler has removed the bar for good.
std::atomic<bool> is_bar_over = false;
static_assert(std::atomic<bool>::is_always_lock_free);

}  // namespace

void ProgressBar::draw_until(const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kBetween(100);
  std::unique_lock lock(mutex_);
  while (!stopped_.wait_for(lock, stop, kBetween, [&] { return stop.stop_requested(); })) draw();
}

/// Draws the bar. Allocates no memory, because the heap of this thread would count against
/// --limit-memory.
void ProgressBar::draw() {
  if (is_hidden_ || phase_.empty() || is_bar_over) return;
  const double now = seconds();
  const auto [part, left] = estimate_.at(now);
  const int filled = static_cast<int>(part * static_cast<double>(kFull.size()));
  is_bar_drawn = true;
  std::fprintf(stderr, "\r\x1b[K%-12.34s [%.*s%.*s] %3.0f%%", phase_.c_str(), filled, kFull.data(),
               static_cast<int>(kEmpty.size()) - filled, kEmpty.data(), std::floor(part * 100));
  draw_time(now, left);
  on_line_ = true;
}

void ProgressBar::draw_time(double now, std::optional<double> left) {
  constexpr double kLongEnough = 1;  // Earlier estimates vary too much.
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
  is_bar_drawn = false;
}

std::string_view wiping_text() {
  is_bar_over = true;
  return is_bar_drawn ? "\r\x1b[K" : "";
}

}  // namespace plumb::cli
