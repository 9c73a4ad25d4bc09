#include "progress_estimate.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumb::cli {

void ProgressEstimate::expect(std::vector<ProgressStage> stages) {
  stages_ = std::move(stages);
  shares_ = 0;
  for (const ProgressStage& stage : stages_) shares_ += share_of(stage);
}

double ProgressEstimate::share_of(const ProgressStage& stage) const {
  double sum = 0;
  for (const ProgressStep& step : stage.steps) sum += step.share;
  return sum;
}

void ProgressEstimate::enter(std::size_t stage, std::size_t step, double now) {
  for (; stage_ < stage; ++stage_, step_ = 0) {
    for (; step_ < stages_[stage_].steps.size(); ++step_) {
      behind_ += stages_[stage_].steps[step_].share;
    }
  }
  for (; step_ < step; ++step_) behind_ += stages_[stage_].steps[step_].share;
  entered_ = now;
  reported_.reset();
  starts_over_ = false;
}

void ProgressEstimate::begin(std::string_view name, double now) {
  for (std::size_t i = stage_ + (has_begun_ ? 1 : 0); i < stages_.size(); ++i) {
    if (stages_[i].name != name) continue;
    has_begun_ = true;
    return enter(i, 0, now);
  }
}

void ProgressEstimate::tell(std::string_view phase, std::uint64_t done, std::uint64_t total,
                            double now) {
  if (stages_.empty()) return;
  const std::vector<ProgressStep>& steps = stages_[stage_].steps;
  const auto at = std::find_if(steps.begin() + static_cast<std::ptrdiff_t>(step_), steps.end(),
                               [&](const ProgressStep& step) { return step.phase == phase; });
  if (at == steps.end()) return;
  const auto step = static_cast<std::size_t>(at - steps.begin());
  if (step != step_) enter(stage_, step, now);
  if (total == 0) return;
  const double reported = std::min(1.0, static_cast<double>(done) / static_cast<double>(total));
  starts_over_ |= reported_ && reported < *reported_;
  reported_ = reported;
}

double ProgressEstimate::inner_part(double now) const {
  if (reported_ && !starts_over_) return *reported_;
  if (behind_ == 0 || entered_ == 0) return 0;
  const double expected = entered_ / behind_ * stages_[stage_].steps[step_].share;
  return 1 - std::exp(-(now - entered_) / expected);
}

double ProgressEstimate::part(double now) {
  if (stages_.empty()) return 0;
  const double share = stages_[stage_].steps[step_].share;
  part_ = std::max(part_, (behind_ + share * inner_part(now)) / shares_);
  return part_;
}

std::optional<double> ProgressEstimate::seconds_left(double now) {
  constexpr double kEnough = 0.01;
  constexpr double kMemory = 2;  // seconds
  const double part = this->part(now);
  if (part < kEnough) return std::nullopt;
  const double end = now / part;
  if (!end_) end_ = end;
  *end_ += (end - *end_) * (1 - std::exp(-(now - asked_) / kMemory));
  asked_ = now;
  return std::max(0.0, *end_ - now);
}

}  // namespace plumb::cli
