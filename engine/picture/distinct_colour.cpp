#include "plumb/picture/distinct_colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumb {

Colour distinct_colour(std::size_t i) {
  constexpr double kGolden = 0.61803398875;
  const double hue = std::fmod(.58 + static_cast<double>(i) * kGolden, 1.);
  const double strength = std::array{.36, .24, .42}[i % 3], light = std::array{.97, .98, .9}[i % 3];
  Colour colour{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double wave = std::fabs(std::fmod(hue * 6 + std::array{0., 4., 2.}[k], 6.) - 3) - 1;
    const double part = light * (1 - strength * (1 - std::clamp(wave, 0., 1.)));
    colour[k] = static_cast<std::uint8_t>(std::lround(255 * part));
  }
  return colour;
}

}  // namespace plumb
