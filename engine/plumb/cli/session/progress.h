// How far a command has come, and how long it will take still: of the whole command, not of a
// phase.
//
// A command announces its stages, each a few steps: phases that operations report, and what share
// of the time they take as a rule (progress.h). Of these
//
//   pace    seconds for each share: of the steps that have been, and of the present one as far as
//           its phase reports
//   left    of the present step what its own reports say; without any what is left of its share at
//           that pace, and not less than a quarter of what it has taken, so that a step beyond its
//           share keeps the command from its end. Of steps to come their shares at that pace
//   end     the time that follows from it, smoothed, so that a step of unusual length moves it
//           little by little
//   part    of the time up to the end that is over. It never falls
//
// Phases that are no step of the present stage are part of its present step, which takes as long as
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

struct ProgressStep {
  std::string_view phase;  ///< as reported; empty: nothing is
  double share;            ///< of the time, compared with other steps
};

struct ProgressStage {
  std::string_view name;
  std::vector<ProgressStep> steps;  ///< at least one
};

using ProgressStages = std::vector<ProgressStage>;

/// Times are seconds since the command began.
class ProgressEstimate {
 public:
  /// Again where it turns out meanwhile what there is to do.
  void expect(ProgressStages stages);
  /// The next stage of this name begins. Others are passed over; without one nothing happens.
  void begin(std::string_view stage, double now);
  /// What a ProgressCallback is told.
  void tell(std::string_view phase, std::uint64_t done, std::uint64_t total, double now);

  struct View {
    double part = 0;             ///< 0 to 1
    std::optional<double> left;  ///< seconds; none as long as too little is done to tell
  };
  View at(double now);

 private:
  /// What one phase has reported.
  struct Report {
    double since = 0;
    std::optional<double> done = std::nullopt;  ///< 0 to 1
    bool starts_over = false;  ///< ends and begins again: what it says is not of the whole

    void note(std::uint64_t done, std::uint64_t total);
    bool is_known() const { return done && *done > 0 && !starts_over; }
    /// Of a phase that is expected to take so long.
    double left(double expected, double now) const;
  };

  bool has_begun() const { return next_ > 0; }
  const ProgressStep& step() const { return stages_[next_ - 1].steps[step_]; }
  void enter(std::size_t stage, std::size_t step, double now);
  double share_to_come() const;
  std::optional<double> left(double now) const;

  ProgressStages stages_;
  std::size_t next_ = 0;     ///< the stage after the present one
  std::size_t step_ = 0;     ///< the present one, of the present stage
  bool is_in_step_ = false;  ///< not only in its stage
  double been_ = 0;          ///< shares of the steps that have been
  Report report_;            ///< of the present step
  std::string other_phase_;
  std::optional<Report> other_;  ///< of the last phase that was no step
  double part_ = 0;
  std::optional<double> end_;
  double asked_ = 0;  ///< when the end was last estimated
};

// What commands go through, for the progress bar: stages, their steps, and how long each takes as a
// rule.
//
// Shares are of one run each, of inputs large enough to take seconds; only what they are to each
// other counts. A command that does other things than most, with other inputs, has its time left
// corrected on the way, no more.

ProgressStage reading_map();
ProgressStage checking_map();
ProgressStage overlaying_maps();
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
ProgressStage numbering_solid();  ///< canonically
ProgressStage measuring_solid();
ProgressStage locating_solid();
ProgressStage auditing_solid();
ProgressStage drawing_solid();
ProgressStages writing_mesh();
ProgressStages writing_nef();

ProgressStage checking_convexity();
ProgressStage cutting_solid();
ProgressStage writing_pieces();
ProgressStage drawing_pieces();
ProgressStage adding_solids();  ///< Minkowski sums

ProgressStages stages_of_surfaces();
ProgressStages stages_of_demo();

ProgressStage writing();  ///< an answer, or what is short beside the rest

// A bar on standard error.

/// On a terminal one line, written anew ten times a second by a thread of its own, so that it goes
/// on where an operation says nothing: phase, bar and percentage of the whole command, and after a
/// second the time left. Elsewhere prints one line per phase.
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
