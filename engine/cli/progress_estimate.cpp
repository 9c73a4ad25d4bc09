#include "progress_estimate.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace plumb::cli {

void ProgressEstimate::expect(ProgressStages stages) {
  stages_ = std::move(stages);
  next_ = 0;
  is_in_step_ = false;
}

void ProgressEstimate::Report::note(std::uint64_t so_far, std::uint64_t total) {
  if (total == 0) return;
  const double now_done = std::min(1.0, static_cast<double>(so_far) / static_cast<double>(total));
  starts_over |= done && now_done < *done;
  done = now_done;
}

/// The step before has been if it was told of or is one of which nothing is.
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

double ProgressEstimate::left_of_step(double pace, double now) const {
  constexpr double kTrusted = .05;  // done, from where on its own pace is all that counts
  const double taken = now - report_.since;
  double left = std::max(pace * step().share - taken, taken / 4);
  if (report_.is_known()) {
    const double trust = std::min(1.0, *report_.done / kTrusted);
    left = trust * report_.left(now) + (1 - trust) * left;
  }
  if (!other_) return left;
  return std::max(left, other_->is_known() ? other_->left(now) : (now - other_->since) / 4);
}

std::optional<double> ProgressEstimate::left(double now) const {
  if (!has_begun()) return std::nullopt;
  const bool is_known = report_.is_known();
  const double shares = been_ + (is_known ? *report_.done * step().share : 0);
  if (shares <= 0) return std::nullopt;
  const double pace = (is_known ? now : report_.since) / shares;
  return left_of_step(pace, now) + pace * share_to_come();
}

ProgressEstimate::View ProgressEstimate::at(double now) {
  constexpr double kMemory = 2;    // seconds
  constexpr double kEarlier = .2;  // of the time so far, if that is less
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

}  // namespace plumb::cli
