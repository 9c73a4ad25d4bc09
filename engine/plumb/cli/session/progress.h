// How far a command has come and how long it still takes, for the whole command and not for a
// phase; the stages of all commands; and the bar that shows it.
//
// A command announces its stages, each with a few steps: phases that operations report, and the
// share of the time that they usually take. From these follow:
//
//   pace    seconds for each share: of the completed steps, and of the current one as far as its
//           phase reports
//   left    For the current step what its own reports say; without any, what is left of its share
//           at that pace, and at least a quarter of what it has taken, so that a step beyond its
//           share keeps the command from its end. For later steps their shares at that pace
//   end     the time that follows from it, smoothed, so that a step of unusual length moves it
//           little by little
//   part    the part of the time up to the end that is over. It never falls
//
// Phases that are no step of the current stage belong to its current step, which takes as long as
// they say.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace plumb::cli {

/// A phase of a stage.
struct ProgressStep {
  std::string_view phase;  ///< Name as reported; empty if nothing is reported.
  double share;            ///< Share of the time, compared with other steps.
};

/// A part of a command, with its steps.
struct ProgressStage {
  std::string_view name;
  std::vector<ProgressStep> steps;  ///< At least one.
};

using ProgressStages = std::vector<ProgressStage>;

/// An estimate of progress. Times are seconds since the command began.
class ProgressEstimate {
 public:
  /// Sets the stages. It may be called again if the number of steps becomes known later.
  void expect(ProgressStages stages);
  /// Begins the next stage of this name and skips others; does nothing if there is none.
  void begin(std::string_view stage, double now);
  /// Takes the arguments of a ProgressCallback.
  void tell(std::string_view phase, std::uint64_t done, std::uint64_t total, double now);

  /// The content of the bar.
  struct View {
    double part = 0;             ///< From 0 to 1.
    std::optional<double> left;  ///< Seconds; no value as long as too little is done.
  };
  /// Returns the view at a time.
  View at(double now);

 private:
  /// The reports of one phase.
  struct Report {
    double since = 0;
    std::optional<double> done = std::nullopt;  ///< From 0 to 1.
    /// Whether it ended and began again: its reports do not cover the whole.
    bool starts_over = false;

    void note(std::uint64_t done, std::uint64_t total);
    bool is_known() const { return done && *done > 0 && !starts_over; }
    /// Returns the seconds left of a phase that is expected to take so long.
    double left(double expected, double now) const;
  };

  bool has_begun() const { return next_ > 0; }
  const ProgressStep& step() const { return stages_[next_ - 1].steps[step_]; }
  void enter(std::size_t stage, std::size_t step, double now);
  double share_to_come() const;
  std::optional<double> left(double now) const;

  ProgressStages stages_;
  std::size_t next_ = 0;     ///< The stage after the current one.
  std::size_t step_ = 0;     ///< The current step of the current stage.
  bool is_in_step_ = false;  ///< Whether a step has been entered, not only its stage.
  double been_ = 0;          ///< Shares of the completed steps.
  Report report_;            ///< Report of the current step.
  std::string other_phase_;
  std::optional<Report> other_;  ///< Report of the last phase that was no step.
  double part_ = 0;
  std::optional<double> end_;
  double asked_ = 0;  ///< When the end was last estimated.
};

// What commands go through: stages, their steps, and how long each usually takes.
//
// Shares come from one run each, with inputs large enough to take seconds; only their ratios count.
// For a command that does other things, with other inputs, the time left is corrected on the way.

ProgressStage reading_map();
ProgressStage checking_map();
ProgressStage overlaying_maps();
ProgressStage repairing_layer();
ProgressStage auditing_map();
ProgressStage drawing_map();

ProgressStage reading_plane();
ProgressStage combining_plane();
ProgressStage measuring_plane();
ProgressStage locating_plane();
ProgressStage auditing_plane();
ProgressStage drawing_plane();
ProgressStages writing_plane_text();
ProgressStages writing_nef2();
ProgressStages writing_plane_picture();

ProgressStage reading_solid();
ProgressStage combining_solids();
ProgressStage intersecting_half_spaces();
ProgressStage numbering_solid();  ///< Canonical numbering.
ProgressStage measuring_solid();
ProgressStage locating_solid();
ProgressStage auditing_solid();
ProgressStage drawing_solid();
ProgressStage mending_mesh();
ProgressStages writing_mesh();
ProgressStages writing_nef();

ProgressStage checking_convexity();
ProgressStage cutting_solid();
ProgressStage writing_pieces();
ProgressStage drawing_pieces();
ProgressStage adding_solids();  ///< Minkowski sums.

ProgressStages stages_of_surfaces();
ProgressStages stages_of_demo();

ProgressStage writing();  ///< An answer, or another step that is short compared with the rest.

// A bar on standard error.

/// On a terminal one line, rewritten ten times a second by a thread of its own, so that it advances
/// even where an operation reports nothing: phase, bar and percentage of the whole command, and
/// after a second the time left. Elsewhere it prints one line per phase.
class ProgressBar {
 public:
  explicit ProgressBar(bool shown);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  bool is_shown() const { return shown_; }
  /// Sets the steps that the command will take (ProgressEstimate).
  void expect(ProgressStages stages);
  /// Begins the next stage of this name and shows the line again.
  void begin(std::string_view stage);
  /// A ProgressCallback.
  void operator()(std::string_view phase, std::uint64_t done, std::uint64_t total);
  /// Prints a line of text where the bar is. Requires no line break in it.
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
  std::mutex mutex_;  ///< Guards all members below.
  bool is_hidden_ = false;
  bool on_line_ = false;
  std::string phase_;
  ProgressEstimate estimate_;
  std::condition_variable_any stopped_;
  std::jthread drawer_;  ///< Only on a terminal.
};

/// Returns the text that wipes the line of a bar, for signal handlers that end the process. Returns
/// an empty text if no bar is on the terminal. No bar is drawn afterwards. Async-signal-safe.
std::string_view wiping_text();

}  // namespace plumb::cli
