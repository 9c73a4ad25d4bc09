// A software rasteriser. It stores a grid of samples. Each sample has a colour, a depth, and the
// patch that is visible at the sample. A patch is a flat part of a scene (scene.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "plumb/picture/scene.h"

#pragma GCC visibility push(default)
namespace plumb {

/// An image with three bytes for each pixel. The rows are stored from top to bottom.
struct Image {
  std::uint32_t width = 0;        ///< Width in pixels.
  std::uint32_t height = 0;       ///< Height in pixels.
  std::vector<std::uint8_t> rgb;  ///< Red, green, blue: 3 * width * height bytes.
};

/// A point of the canvas, in units of samples. The x-axis points to the right, the y-axis points
/// downwards, and the z-axis points towards the viewer. The middle of sample (i, j) has x = i + 1/2
/// and y = j + 1/2.
struct Spot {
  double x = 0, y = 0, z = 0;  ///< Coordinates.
};

/// A grid of samples. Each sample has a depth, a colour, and the patch that is visible at the
/// sample.
class Canvas {
 public:
  /// Makes a canvas whose samples all have the colour `paper` and are infinitely far away.
  Canvas(std::uint32_t width, std::uint32_t height, Colour paper);

  std::uint32_t width() const { return width_; }    ///< Width in samples.
  std::uint32_t height() const { return height_; }  ///< Height in samples.

  /// Calls visit(sample, spot) for each sample whose middle `spot` lies in the triangle a b c. The
  /// triangle may have either orientation. Let two triangles lie on different sides of a common
  /// edge. Each sample beside this edge is visited for exactly one of the two triangles, except
  /// where rounding moves the edge. Cost: O(rows + samples visited).
  template <class Visit>
  void for_triangle(Spot a, Spot b, Spot c, const Visit& visit) const;

  /// Returns the depth of the nearest patch drawn at a sample.
  double depth(std::size_t sample) const { return depth_[sample]; }
  /// Draws a patch at a sample. Does nothing if an earlier patch at this sample is nearer or has
  /// the same depth.
  void put(std::size_t sample, double depth, std::uint32_t patch, Colour colour) {
    if (depth <= depth_[sample]) return;
    depth_[sample] = static_cast<float>(depth);
    patch_[sample] = patch;
    colour_[sample] = colour;
  }
  /// Mixes `colour` into the colour of a sample. `part` is the weight of `colour`, from 0 to 1.
  void blend(std::size_t sample, Colour colour, double part);

  /// Draws a line from a to b. The line is hidden where a patch is nearer to the viewer. The two
  /// patches listed in `patches` never hide the line. At each spot, the colour of the line is mixed
  /// into the colour of the patches. The weight of the line is `part_at(spot)`, from 0 to 1. The
  /// canvas stores the line; finish() draws all lines over the patches.
  template <class PartAt>
  void line(Spot a, Spot b, double width, const std::array<std::uint32_t, 2>& patches,
            Colour colour, const PartAt& part_at);
  /// Draws a dot. The dot is a disc, or a ring around a white disc if `is_hollow` is true. The dot
  /// is hidden if a patch is nearer to the viewer. `part` is the weight of `colour`, from 0 to 1.
  void dot(Spot at, double radius, Colour colour, bool is_hollow, double part);

  /// Draws a line with round ends. No patch hides the line.
  void stroke(Point2 a, Point2 b, double width, Colour colour);
  /// For each sample, returns the patch that is visible at the sample, or Scene::kNoPatch if no
  /// patch is visible.
  const std::vector<std::uint32_t>& patches() const { return patch_; }

  /// Draws the lines and dots over the patches, and returns the image. The colour of a pixel is the
  /// mean colour of a square block of `samples` times `samples` samples.
  Image finish(std::uint32_t samples);

 private:
  struct Ink {
    Colour colour{};
    std::uint8_t part = 0;  // Weight; 255 covers completely.
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
