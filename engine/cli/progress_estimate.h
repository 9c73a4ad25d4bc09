// How far a command has come, and how long it will take still: of the whole command, not of a phase.
//
// A command announces its stages, each a few steps: phases that operations report, and what share of the time they take as
// a rule (progress_stages.h). Of these
//
//   part    shares of the steps behind, and of the present step as much as its phase reports; of a step that reports nothing, or
//           starts over again, as much as its time makes likely: it comes nearer to the end of the step, never there.
//           It never falls
//   left    what the rest takes at the pace so far. The time of the end that follows from it is smoothed, so that a
//           step of unusual length moves it little by little
//
// Phases that are no step of the present stage are passed over.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
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

/// Times are seconds since the command began.
class ProgressEstimate {
 public:
  void expect(std::vector<ProgressStage> stages);
  /// The next stage of this name begins. Others are passed over; without one nothing happens.
  void begin(std::string_view stage, double now);
  /// What a ProgressCallback is told.
  void tell(std::string_view phase, std::uint64_t done, std::uint64_t total, double now);

  /// 0 to 1.
  double part(double now);
  /// None as long as too little is done to tell.
  std::optional<double> seconds_left(double now);

 private:
  void enter(std::size_t stage, std::size_t step, double now);
  double share_of(const ProgressStage& stage) const;
  double inner_part(double now) const;

  std::vector<ProgressStage> stages_;
  double shares_ = 0;  ///< of all stages
  bool has_begun_ = false;
  std::size_t stage_ = 0;
  std::size_t step_ = 0;
  double behind_ = 0;   ///< shares of the steps before
  double entered_ = 0;  ///< when the present step began
  std::optional<double> reported_;
  bool starts_over_ = false;
  double part_ = 0;
  std::optional<double> end_;
  double asked_ = 0;  ///< when the end was last estimated
};

}  // namespace plumb::cli
