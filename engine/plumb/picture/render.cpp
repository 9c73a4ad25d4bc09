// Rendering of scenes to images, and the placement of text in them.
//
// A z-buffer renderer with four samples per pixel and an orthogonal camera. Triangles are filled
// with one colour per patch, lit from above on the left; lines are drawn if a sample nearby shows
// that they are not hidden (Canvas::is_seen), so rounding never breaks a line on its own facet.
// Widths adapt to the number of lines, which cover a bounded part of the image.
//
// A text of a group is placed where the group's visible area is widest: a distance transform in two
// passes over the samples (a chamfer distance: G. Borgefors, Distance transformations in digital
// images, Computer Vision, Graphics, and Image Processing 34, 1986) finds the sample farthest from
// every other group.
// Tested by tests/picture/space_scene_test.cpp and tests/picture/surface_scene_test.cpp.
#include "plumb/picture/render.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plumb/picture/scene/stroke_font.h"
#include "plumb/predicates/arithmetic/vectors.h"

namespace plumb {
namespace {

constexpr std::uint32_t kNoGroup = ~std::uint32_t{0};
constexpr float kStep = 1, kSlant = 1.41421356F;

/// Computes the approximate distance of each sample from the nearest sample of another group, in
/// two passes over the neighbours.
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
                                    double most) {
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
}

namespace {

constexpr Colour kPaper{255, 255, 255};
constexpr Colour kInk{0x12, 0x1a, 0x24};
constexpr std::uint32_t kSamples = 2;  // The number of samples along each side of a pixel.
constexpr double kMargin = 0.06;       // The margin on every side, as a part of the picture.
constexpr double kLineWidth = 2;       // In pixels.
constexpr double kFreeLineWidth = 3.2;
constexpr double kDotRadius = 5;
// A part of the picture. If lines would cover more, they are drawn thinner.
constexpr double kInkedPart = 0.12;
constexpr double kVeil = 0.35;
constexpr double kHatch = 9;  // In pixels, from line to line.
constexpr double kHatchWidth = 3;
constexpr double kHatchShade = .8;
constexpr std::size_t kManyDots = 300;
constexpr double kLeastText = 11;  // In pixels.

Point3 unit(const Point3& p) {
  const double length = std::sqrt(dot(p, p));
  return {p.x / length, p.y / length, p.z / length};
}

/// Returns the axes of a view from the right, the front and above. The axis z points up.
std::array<Point3, 3> axes_of(bool is_flat) {
  if (is_flat) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const Point3 viewer = unit({0.55, -0.9, 0.62});
  const Point3 right = unit({-viewer.y, viewer.x, 0});
  return {{right,
           {viewer.y * right.z - viewer.z * right.y, viewer.z * right.x - viewer.x * right.z,
            viewer.x * right.y - viewer.y * right.x},
           viewer}};
}

Colour scaled(Colour colour, double by) {
  for (std::uint8_t& part : colour) {
    part = static_cast<std::uint8_t>(std::lround(std::clamp(part * by, 0., 255.)));
  }
  return colour;
}

Colour mixed(Colour under, Colour over, double part) {
  for (std::size_t i = 0; i < 3; ++i) {
    under[i] = static_cast<std::uint8_t>(std::lround(under[i] + (over[i] - under[i]) * part));
  }
  return under;
}

class Renderer {
 public:
  Renderer(const Scene& scene, const RenderOptions& options)
      : scene_(scene),
        canvas_(kSamples * options.width, kSamples * options.height, kPaper),
        camera_(scene, canvas_.width(), canvas_.height()),
        text_height_(options.text_height) {
    for (const Point3& p : scene.points) spots_.push_back(camera_.place(p));
  }

  Image run() {
    draw();
    for (const PlacedText& text : texts()) write(text);
    return canvas_.finish(kSamples);
  }
  Rendering run_without_text() {
    draw();
    std::vector<PlacedText> placed = texts();
    for (PlacedText& text : placed) {
      text = {
          {text.middle.x / kSamples, text.middle.y / kSamples}, text.height / kSamples, text.text};
    }
    return {canvas_.finish(kSamples), std::move(placed)};
  }

 private:
  void draw() {
    for (const Scene::Patch& patch : scene_.patches) colours_.push_back(lit(patch));
    for (const Scene::Triangle& t : scene_.triangles) fill(t);
    for (const Scene::Triangle& t : scene_.triangles) veil(t);
    draw_lines();
    draw_dots();
  }

  std::vector<PlacedText> texts() const {
    if (!scene_.shows_text()) return {};
    return place_texts(scene_, canvas_, kSamples * kLeastText, kSamples * text_height_);
  }
  /// Writes dark letters with a light rim, which are legible on any background.
  void write(const PlacedText& text) {
    const std::vector<TextStroke> strokes = strokes_of(text.text);
    const auto place = [&text](Point2 p) {
      return Point2{text.middle.x + text.height * p.x, text.middle.y + text.height * p.y};
    };
    for (const auto& [width, colour] : {std::pair(.34, kPaper), std::pair(.13, kInk)}) {
      for (const auto& [a, b] : strokes) {
        canvas_.stroke(place(a), place(b), width * text.height, colour);
      }
    }
  }

  template <class Visit>
  void for_samples(const Scene::Triangle& t, const Visit& visit) const {
    canvas_.for_triangle(spots_[t.corners[0]], spots_[t.corners[1]], spots_[t.corners[2]], visit);
  }
  double strength(const Spot& spot) const {
    return scene_.fades ? scene_.strength(camera_.point_at(spot)) : 1;
  }

  /// Returns the colour of a patch that is lit from above on the left. The lit side is the one that
  /// the viewer sees.
  Colour lit(const Scene::Patch& patch) const {
    const Colour colour = scene_.colour_of(patch);
    if (scene_.is_flat) return colour;
    Point3 n = patch.normal;
    if (dot(n, camera_.viewer()) < 0) n = {-n.x, -n.y, -n.z};
    const Point3 v = camera_.viewer(), u = camera_.up(), r = camera_.right();
    const Point3 light =
        unit({v.x + .9 * u.x - .5 * r.x, v.y + .9 * u.y - .5 * r.y, v.z + .9 * u.z - .5 * r.z});
    return scaled(colour, .74 + .36 * std::max(dot(n, light), 0.));
  }

  void fill(const Scene::Triangle& t) {
    const Scene::Patch& patch = scene_.patches[t.patch];
    if (patch.paint == Paint::Cut) return;
    const Colour plain = colours_[t.patch], dark = scaled(plain, kHatchShade);
    for_samples(t, [&](std::size_t sample, const Spot& spot) {
      const Colour colour = patch.is_hatched && is_on_hatch(spot) ? dark : plain;
      canvas_.put(sample, spot.z, t.patch,
                  scene_.fades ? mixed(kPaper, colour, strength(spot)) : colour);
    });
  }

  /// Whether a spot is on a hatch line. The lines are slanted in the picture and do not depend on
  /// the object.
  static bool is_on_hatch(const Spot& spot) {
    const double at = (spot.x + spot.y) / (kSamples * kHatch);
    return (at - std::floor(at)) * kHatch < kHatchWidth;
  }

  /// Veils the sides of the window where it cuts a volume and the viewer looks through the cut.
  void veil(const Scene::Triangle& t) {
    const Scene::Patch& patch = scene_.patches[t.patch];
    if (patch.paint != Paint::Cut || dot(patch.normal, camera_.viewer()) <= 0) return;
    const Colour colour = colours_[t.patch];
    for_samples(t, [&](std::size_t sample, const Spot& spot) {
      if (spot.z > canvas_.depth(sample)) canvas_.blend(sample, colour, kVeil);
    });
  }

  /// Draws lines. They cover a small part of the picture. If there are many lines, they become
  /// thin, and then pale.
  void draw_lines() {
    double length = 1;
    for (const Scene::Line& l : scene_.lines) {
      if (!scene_.is_shown(l) || is_curve(l.paint)) continue;
      const Spot &a = spots_[l.ends[0]], &b = spots_[l.ends[1]];
      length += std::hypot(a.x - b.x, a.y - b.y);
    }
    const double room = kInkedPart * canvas_.width() * canvas_.height() / length / kSamples;
    const double width = std::min(kLineWidth, std::max(room, .5));
    const double part = std::min(1., std::max(room / .5, .15));
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < scene_.lines.size(); ++i) {
      if (scene_.is_shown(scene_.lines[i])) order.push_back(i);
    }
    const auto rank = [this](std::uint32_t i) {
      const Paint paint = scene_.lines[i].paint;
      return paint == Paint::Wire ? 0 : static_cast<int>(paint);
    };
    std::ranges::stable_sort(order, {}, rank);
    for (const std::uint32_t i : order) {
      const Scene::Line& l = scene_.lines[i];
      const bool is_plain =
          l.paint == Paint::Edge || l.paint == Paint::OpenEdge || l.paint == Paint::Wire;
      const double own = is_curve(l.paint) ? kFreeLineWidth
                         : is_plain        ? width
                                           : std::min(kFreeLineWidth, 1.6 * width);
      canvas_.line(
          spots_[l.ends[0]], spots_[l.ends[1]], kSamples * own, l.patches, style_of(l.paint).colour,
          [&](const Spot& spot) { return (is_curve(l.paint) ? 1 : part) * strength(spot); });
    }
  }

  void draw_dots() {
    const double radius = kSamples * (scene_.dots.size() > kManyDots ? kDotRadius / 2 : kDotRadius);
    for (const Scene::Dot& d : scene_.dots) {
      if (!scene_.is_shown(d)) continue;
      const Spot& spot = spots_[d.at];
      canvas_.dot(spot, radius, style_of(d.paint).colour, d.paint == Paint::OpenPoint,
                  strength(spot));
    }
  }

  const Scene& scene_;
  Canvas canvas_;
  Camera camera_;
  double text_height_;
  std::vector<Spot> spots_;
  std::vector<Colour> colours_;  // The lit colour of each patch.
};

}  // namespace

Camera::Camera(const Scene& scene, double width, double height) : axes_(axes_of(scene.is_flat)) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<double, 2> low{kFar, kFar}, high{-kFar, -kFar};
  const auto see = [&](const Point3& p) {
    for (std::size_t i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], dot(axes_[i], p));
      high[i] = std::max(high[i], dot(axes_[i], p));
    }
  };
  for (const Point3& p : scene.points) see(p);
  if (scene.points.empty() || scene.fades) {
    for (const double x : {-1, 1}) {
      for (const double y : {-1, 1}) {
        for (const double z : {-1, 1}) see({x * scene.half.x, y * scene.half.y, z * scene.half.z});
      }
    }
  }
  constexpr double kLeast = 1e-3;
  const double x = std::max(high[0] - low[0], kLeast), y = std::max(high[1] - low[1], kLeast);
  scale_ = (1 - 2 * kMargin) * std::min(width / x, height / y);
  middle_ = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, 0};
  shift_ = {width / 2, height / 2, 0};
}

Spot Camera::place(const Point3& p) const {
  return {shift_.x + scale_ * (dot(axes_[0], p) - middle_.x),
          shift_.y - scale_ * (dot(axes_[1], p) - middle_.y), scale_ * dot(axes_[2], p)};
}

Point3 Camera::point_at(const Spot& spot) const {
  const double x = middle_.x + (spot.x - shift_.x) / scale_;
  const double y = middle_.y - (spot.y - shift_.y) / scale_;
  const double z = spot.z / scale_;
  const auto along = [&](double Point3::*c) {
    return x * (axes_[0].*c) + y * (axes_[1].*c) + z * (axes_[2].*c);
  };
  return {along(&Point3::x), along(&Point3::y), along(&Point3::z)};
}

Image rendered(const Scene& scene, const RenderOptions& options) {
  return Renderer(scene, options).run();
}

Rendering rendered_without_text(const Scene& scene, const RenderOptions& options) {
  return Renderer(scene, options).run_without_text();
}

}  // namespace plumb
