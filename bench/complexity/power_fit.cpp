#include "power_fit.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace plumb::bench {

// With x, y the centred logarithms: slope = sum xy / sum xx, and its standard error is
// sqrt(residual sum / (n - 2) / sum xx).
PowerFit fit_power(const std::vector<Sample>& samples) {
  const auto n = static_cast<double>(samples.size());
  double mean_x = 0;
  double mean_y = 0;
  for (const Sample& s : samples) {
    mean_x += std::log(s.size) / n;
    mean_y += std::log(s.seconds) / n;
  }
  double xx = 0, xy = 0, yy = 0;
  for (const Sample& s : samples) {
    const double x = std::log(s.size) - mean_x;
    const double y = std::log(s.seconds) - mean_y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  const double slope = xy / xx;
  const double residual = std::max(0.0, yy - slope * xy);
  const boost::math::students_t distribution(n - 2);
  const double t = boost::math::quantile(distribution, 0.975);
  return {slope, t * std::sqrt(residual / (n - 2) / xx)};
}

}  // namespace plumb::bench
