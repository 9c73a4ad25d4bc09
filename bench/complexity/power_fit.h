// Growth as a power: least squares on logarithms.
#pragma once

#include <cstddef>
#include <vector>

namespace plumb::bench {

struct Sample {
  double size;
  double seconds;
};

/// seconds ~ size^slope; the true slope lies within slope +- half_width with 95% confidence, if the
/// deviations are independent and normal.
struct PowerFit {
  double slope;
  double half_width;
};

/// Requires at least 3 samples of different sizes.
PowerFit fit_power(const std::vector<Sample>& samples);

}  // namespace plumb::bench
