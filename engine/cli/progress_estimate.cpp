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
  starts_over |= done && now_done < *done / 2;  // less is what there is to do growing
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

double ProgressEstimate::Report::left(double expected, double now) const {
  constexpr double kTrusted = .05;  // done, from where on its own pace is all that counts
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
  if (shares <= 0) shares = step().share / 2;  // as good a guess as any
  const double pace = (counts_step ? now : report_.since) / shares;
  const double of_step = report_.left(pace * step().share, now);
  return std::max(of_step, other_ ? other_->left(0, now) : 0) + pace * share_to_come();
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
