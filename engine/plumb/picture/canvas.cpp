#include "plumb/picture/canvas.h"

#include <array>
#include <limits>

namespace plumb {
namespace {

// The unit is a sample. A surface that is nearer only by this much does not hide a line.
constexpr double kNearer = 1.5;
constexpr Colour kWhite{255, 255, 255};

std::uint8_t mixed(std::uint8_t under, std::uint8_t over, double part) {
  return static_cast<std::uint8_t>(std::lround(under + (over - under) * part));
}

}  // namespace

Canvas::Canvas(std::uint32_t width, std::uint32_t height, Colour paper)
    : width_(width),
      height_(height),
      depth_(std::size_t{width} * height, -std::numeric_limits<float>::infinity()),
      patch_(depth_.size(), Scene::kNoPatch),
      colour_(depth_.size(), paper),
      ink_(depth_.size()) {}

void Canvas::blend(std::size_t sample, Colour colour, double part) {
  for (std::size_t i = 0; i < 3; ++i)
    colour_[sample][i] = mixed(colour_[sample][i], colour[i], part);
}

/// Whether a line is visible at a sample, decided by the samples around it. Beside a silhouette,
/// and on its own facets, a line is visible whatever the rounding.
bool Canvas::is_seen(Spot at, const std::array<std::uint32_t, 2>& patches) const {
  if (!(at.x >= 0 && at.y >= 0 && at.x < width_ && at.y < height_)) return false;
  const auto x = static_cast<std::uint32_t>(at.x), y = static_cast<std::uint32_t>(at.y);
  for (std::uint32_t j = y == 0 ? 0 : y - 1; j <= std::min(y + 1, height_ - 1); ++j) {
    for (std::uint32_t i = x == 0 ? 0 : x - 1; i <= std::min(x + 1, width_ - 1); ++i) {
      const std::size_t sample = std::size_t{j} * width_ + i;
      if (at.z + kNearer >= depth_[sample]) return true;
      const std::uint32_t patch = patch_[sample];
      if (patch != Scene::kNoPatch && (patch == patches[0] || patch == patches[1])) return true;
    }
  }
  return false;
}

void Canvas::stamp(Spot at, double radius, Colour colour, double part) {
  const double r = std::max(radius, .5);
  const auto range = [r](double centre, std::uint32_t size) {
    const auto pixel = [size](double c) {
      return static_cast<std::uint32_t>(std::clamp(c, 0., static_cast<double>(size)));
    };
    return std::array{pixel(std::ceil(centre - r - .5)), pixel(std::floor(centre + r + .5))};
  };
  const auto [top, bottom] = range(at.y, height_);
  const auto [left, right] = range(at.x, width_);
  for (std::uint32_t j = top; j < bottom; ++j) {
    for (std::uint32_t i = left; i < right; ++i) {
      if (std::hypot(i + .5 - at.x, j + .5 - at.y) > r) continue;
      Ink& ink = ink_[std::size_t{j} * width_ + i];
      const auto strength = static_cast<std::uint8_t>(std::lround(255 * part));
      if (strength >= ink.part) ink = {colour, strength};
    }
  }
}

void Canvas::dot(Spot at, double radius, Colour colour, bool is_hollow, double part) {
  if (!is_seen(at, {Scene::kNoPatch, Scene::kNoPatch})) return;
  stamp(at, radius, colour, part);
  if (is_hollow) stamp(at, radius * .6, kWhite, part);
}

void Canvas::stroke(Point2 a, Point2 b, double width, Colour colour) {
  const auto steps = static_cast<std::uint32_t>(std::ceil(std::hypot(b.x - a.x, b.y - a.y))) + 1;
  for (std::uint32_t i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    stamp({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0}, width / 2, colour, 1);
  }
}

Image Canvas::finish(std::uint32_t samples) {
  for (std::size_t s = 0; s < ink_.size(); ++s) {
    if (ink_[s].part != 0) blend(s, ink_[s].colour, ink_[s].part / 255.);
  }
  Image image{width_ / samples, height_ / samples, {}};
  image.rgb.reserve(std::size_t{3} * image.width * image.height);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      std::array<std::uint32_t, 3> sum{};
      for (std::uint32_t k = 0; k < samples * samples; ++k) {
        const std::size_t row = std::size_t{y} * samples + k / samples;
        const Colour& c = colour_[row * width_ + std::size_t{x} * samples + k % samples];
        for (std::size_t i = 0; i < 3; ++i) sum[i] += c[i];
      }
      for (const std::uint32_t part : sum) {
        image.rgb.push_back(static_cast<std::uint8_t>(part / samples / samples));
      }
    }
  }
  return image;
}

}  // namespace plumb
