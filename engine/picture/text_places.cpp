#include "plumb/picture/text_places.h"

#include <algorithm>
#include <cmath>

#include "plumb/base/refused_memory.h"
#include "plumb/picture/stroke_font.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNoGroup = ~std::uint32_t{0};
constexpr float kStep = 1, kSlant = 1.41421356F;

/// How far each sample is from one of another group, nearly: two passes over the neighbours.
class Distances {
 public:
  Distances(const Scene& scene, const Canvas& canvas)
      : width_(canvas.width()), height_(canvas.height()) {
    group_.reserve(canvas.patches().size());
    for (const std::uint32_t patch : canvas.patches()) {
      group_.push_back(patch == Scene::kNoPatch ? kNoGroup : scene.patches[patch].group);
    }
    far_.assign(group_.size(), static_cast<float>(width_ + height_));
    for (std::uint32_t y = 0; y < height_; ++y) {
      for (std::uint32_t x = 0; x < width_; ++x) {
        look(x, y, -1, 0, kStep);
        look(x, y, 0, -1, kStep);
        look(x, y, -1, -1, kSlant);
        look(x, y, 1, -1, kSlant);
      }
    }
    for (std::uint32_t y = height_; y-- > 0;) {
      for (std::uint32_t x = width_; x-- > 0;) {
        look(x, y, 1, 0, kStep);
        look(x, y, 0, 1, kStep);
        look(x, y, 1, 1, kSlant);
        look(x, y, -1, 1, kSlant);
      }
    }
  }

  std::uint32_t group(std::size_t sample) const { return group_[sample]; }
  float far(std::size_t sample) const { return far_[sample]; }
  std::size_t size() const { return group_.size(); }

 private:
  void look(std::uint32_t x, std::uint32_t y, int dx, int dy, float step) {
    const std::size_t at = std::size_t{y} * width_ + x;
    const std::int64_t i = std::int64_t{x} + dx, j = std::int64_t{y} + dy;
    const bool is_outside = i < 0 || j < 0 || i >= width_ || j >= height_;
    const std::size_t other = is_outside ? 0 : static_cast<std::size_t>(j * width_ + i);
    const bool is_edge = is_outside || group_[other] != group_[at];
    far_[at] = std::min(far_[at], is_edge ? step : far_[other] + step);
  }

  std::uint32_t width_, height_;
  std::vector<std::uint32_t> group_;
  std::vector<float> far_;
};

}  // namespace

std::vector<PlacedText> place_texts(const Scene& scene, const Canvas& canvas, double least,
                                    double most) try {
  const Distances distances(scene, canvas);
  std::vector<std::size_t> best(scene.groups.size(), distances.size());
  for (std::size_t s = 0; s < distances.size(); ++s) {
    const std::uint32_t g = distances.group(s);
    if (g >= best.size()) continue;
    if (best[g] == distances.size() || distances.far(s) > distances.far(best[g])) best[g] = s;
  }
  std::vector<PlacedText> texts;
  for (std::size_t g = 0; g < best.size(); ++g) {
    const std::string& text = scene.groups[g].text;
    if (best[g] == distances.size() || text.empty()) continue;
    const double half = std::hypot(stroked_width(text), 1) / 2;
    const double height = std::min(most, distances.far(best[g]) / half);
    if (height < least / 2) continue;
    const std::size_t x = best[g] % canvas.width(), y = best[g] / canvas.width();
    texts.push_back({{static_cast<double>(x) + .5, static_cast<double>(y) + .5},
                     std::max(height, least),
                     text});
  }
  return texts;
} catch (...) {
  rethrow_refused_memory();
}

}  // namespace plumb
