// A software rasteriser: colour, depth and the patch seen, at every sample.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Rows from the top, three bytes a pixel.
struct Image {
  std::uint32_t width = 0;        ///< in pixels
  std::uint32_t height = 0;       ///< in pixels
  std::vector<std::uint8_t> rgb;  ///< 3 width height bytes
};

/// A place in samples: x to the right, y downwards, z towards the viewer. A sample lies at (i + 1/2, j + 1/2).
struct Spot {
  /// Downwards.
  double x = 0, y = 0, z = 0;  ///< to the right
};

/// Samples with depth and colour: a software rasteriser.
class Canvas {
 public:
  /// Paper everywhere, infinitely far away.
  Canvas(std::uint32_t width, std::uint32_t height, Colour paper);

  std::uint32_t width() const { return width_; }    ///< In samples.
  std::uint32_t height() const { return height_; }  ///< In samples.

  /// Calls visit(sample, spot) for the samples in the triangle, whichever way round it is. Two triangles with a
  /// common side share no sample and leave none out, but where rounding moves the side.
  template <class Visit>
  void for_triangle(Spot a, Spot b, Spot c, const Visit& visit) const;

  /// Of what is seen at a sample.
  double depth(std::size_t sample) const { return depth_[sample]; }
  /// Seen if nothing nearer is there already.
  void put(std::size_t sample, double depth, std::uint32_t patch, Colour colour) {
    if (depth <= depth_[sample]) return;
    depth_[sample] = static_cast<float>(depth);
    patch_[sample] = patch;
    colour_[sample] = colour;
  }
  /// Mixes a colour in: `part` of it.
  void blend(std::size_t sample, Colour colour, double part);

  /// A line over what is not nearer than it; its own patches never hide it. `part_at(spot)` is how strongly it
  /// covers. Lines are laid over all else by finish().
  template <class PartAt>
  void line(Spot a, Spot b, double width, const std::array<std::uint32_t, 2>& patches,
            Colour colour, const PartAt& part_at);
  /// A disc, or a ring around white.
  void dot(Spot at, double radius, Colour colour, bool is_hollow, double part);

  /// A line over everything, with round ends.
  void stroke(Point2 a, Point2 b, double width, Colour colour);
  /// The patch seen at each sample; Scene::kNoPatch.
  const std::vector<std::uint32_t>& patches() const { return patch_; }

  /// The mean of each `samples` x `samples` block.
  Image finish(std::uint32_t samples);

 private:
  struct Ink {
    Colour colour{};
    std::uint8_t part = 0;  // 255: covers
  };

  bool is_seen(Spot at, const std::array<std::uint32_t, 2>& patches) const;
  void stamp(Spot at, double radius, Colour colour, double part);

  std::uint32_t width_, height_;
  std::vector<float> depth_;
  std::vector<std::uint32_t> patch_;
  std::vector<Colour> colour_;
  std::vector<Ink> ink_;
};

template <class Visit>
void Canvas::for_triangle(Spot a, Spot b, Spot c, const Visit& visit) const {
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (area == 0 || !std::isfinite(area)) return;
  const double low = std::min({a.y, b.y, c.y}), high = std::max({a.y, b.y, c.y});
  const auto first =
      static_cast<std::uint32_t>(std::clamp(std::ceil(low - .5), 0., static_cast<double>(height_)));
  const auto last = static_cast<std::uint32_t>(
      std::clamp(std::ceil(high - .5), 0., static_cast<double>(height_)));
  const double dz_x = ((b.z - a.z) * (c.y - a.y) - (c.z - a.z) * (b.y - a.y)) / area;
  const double dz_y = ((c.z - a.z) * (b.x - a.x) - (b.z - a.z) * (c.x - a.x)) / area;
  for (std::uint32_t j = first; j < last; ++j) {
    const double y = j + .5;
    double left = width_, right = 0;
    const auto cross = [&](const Spot& p, const Spot& q) {
      if ((p.y <= y) == (q.y <= y)) return;
      const double x = p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y));
      left = std::min(left, x);
      right = std::max(right, x);
    };
    cross(a, b);
    cross(b, c);
    cross(c, a);
    const double end = std::min(std::ceil(right - .5), static_cast<double>(width_));
    for (double i = std::max(std::ceil(left - .5), 0.); i < end; ++i) {
      const Spot spot{i + .5, y, a.z + dz_x * (i + .5 - a.x) + dz_y * (y - a.y)};
      visit(std::size_t{j} * width_ + static_cast<std::size_t>(i), spot);
    }
  }
}

template <class PartAt>
void Canvas::line(Spot a, Spot b, double width, const std::array<std::uint32_t, 2>& patches,
                  Colour colour, const PartAt& part_at) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (!(length < 1e7)) return;
  const auto steps = static_cast<std::uint32_t>(std::ceil(length * 1.25)) + 1;
  for (std::uint32_t i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const Spot p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
    if (is_seen(p, patches)) stamp(p, width / 2, colour, part_at(p));
  }
}

}  // namespace plumb
#pragma GCC visibility pop
