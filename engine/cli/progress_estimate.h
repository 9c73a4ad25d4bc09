// How far a command has come, and how long it will take still: of the whole command, not of a phase.
//
// A command announces its stages, each a few steps: phases that operations report, and what share of the time they take as
// a rule (progress_stages.h). Of these
//
//   pace    seconds for each share: of the steps that have been, and of the present one as far as its phase reports
//   left    of the present step what its own reports say; without any what is left of its share at that pace, and not less than a
//           quarter of what it has taken, so that a step beyond its share keeps the command from its end. Of steps to
//           come their shares at that pace
//   end     the time that follows from it, smoothed, so that a step of unusual length moves it little by little
//   part    of the time up to the end that is over. It never falls
//
// Phases that are no step of the present stage are part of its present step, which takes as long as they say.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
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

}  // namespace plumb::cli
