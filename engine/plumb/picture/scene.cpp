#include "plumb/picture/scene.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

constexpr double kFullUntil = 0.6;  // A part of the distance to the sides.

constexpr std::array<PaintStyle, kPaints> kStyles{{
    {{0xa9, 0xc8, 0xe6}, "facet", "part of the set"},
    {{0xf2, 0xae, 0x62}, "open facet", "not part of the set"},
    {{0x8c, 0xcf, 0x9d}, "sheet", "part of the set, without thickness"},
    {{0xcf, 0xe2, 0xf3}, "fading", "goes on to infinity"},
    {{0x12, 0x38, 0x5c}, "edge", "part of the set"},
    {{0xc4, 0x4e, 0x00}, "open edge", "not part of the set"},
    {{0x0f, 0x7a, 0x36}, "line", "part of the set, no facet beside it"},
    {{0x0f, 0x7a, 0x36}, "point", "part of the set"},
    {{0xc4, 0x4e, 0x00}, "hollow", "a point that is not"},
    {{0xc0, 0x1c, 0x28}, "defect", "plumb map check describes it"},
    {{0xd5, 0xe5, 0xf3}, "", ""},
    {{0xf6, 0xe3, 0xc5}, "", ""},
    {{0xd9, 0xec, 0xd2}, "", ""},
    {{0xf3, 0xd9, 0xdc}, "", ""},
    {{0xe4, 0xdc, 0xf0}, "", ""},
    {{0xe9, 0xe6, 0xd3}, "", ""},
    {{0xdf, 0xe3, 0xe8}, "", ""},
    {{0x6f, 0x7a, 0x86}, "side", "of a triangle"},
    {{0x1d, 0x27, 0x33}, "control point", "of a polygon"},
    {{0xd0, 0x1c, 0x28}, "crossing", "of polygons"},
    {{0x1f, 0x4f, 0xb4}, "", ""},
    {{0xc4, 0x4e, 0x00}, "", ""},
    {{0x0f, 0x7a, 0x36}, "", ""},
    {{0xa1, 0x1c, 0x7c}, "", ""},
    {{0x00, 0x7c, 0x8c}, "", ""},
    {{0x6b, 0x4b, 0x1c}, "", ""},
}};

}  // namespace

const PaintStyle& style_of(Paint paint) { return kStyles[static_cast<std::size_t>(paint)]; }

std::string hex(Colour colour) {
  static constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t part : colour) text += {kDigits[part >> 4U], kDigits[part & 15U]};
  return text;
}

std::array<bool, kPaints> Scene::paints(std::uint8_t layers_seen) const {
  std::array<bool, kPaints> occurs{};
  const auto see = [&occurs](Paint paint) { occurs[static_cast<std::size_t>(paint)] = true; };
  for (const Patch& p : patches) see(p.paint);
  for (const Line& l : lines) {
    if ((l.layers & layers_seen) != 0) see(l.paint);
  }
  for (const Dot& d : dots) {
    if ((d.layers & layers_seen) != 0) see(d.paint);
  }
  return occurs;
}

std::array<bool, kPaints> Scene::legend(std::uint8_t layers_seen) const {
  std::array<bool, kPaints> explained = paints(layers_seen);
  explained[static_cast<std::size_t>(Paint::Cut)] = fades;
  const bool is_tinted = tinted() != nullptr;
  for (std::size_t i = 0; i < kPaints; ++i) {
    const auto paint = static_cast<Paint>(i);
    const bool is_of_patches = !is_line(paint) && !is_dot(paint);
    if (style_of(paint).name.empty() || (is_tinted && is_of_patches)) explained[i] = false;
  }
  return explained;
}

const Scene::Layer* Scene::tinted() const {
  for (std::size_t i = layers.size(); i-- > 0;) {
    if (is_shown(i) && !layers[i].tints.empty()) return &layers[i];
  }
  return nullptr;
}

Colour Scene::colour_of(const Patch& patch) const {
  const Layer* const layer = tinted();
  return layer == nullptr ? style_of(patch.paint).colour : layer->tints[patch.group];
}

bool Scene::shows_text() const {
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (is_shown(i) && layers[i].has_text) return true;
  }
  return false;
}

double Scene::strength(const Point3& p) const {
  if (!fades) return 1;
  const double side = std::max(
      {std::fabs(p.x) / half.x, std::fabs(p.y) / half.y, is_flat ? 0 : std::fabs(p.z) / half.z});
  return std::clamp((1 - side) / (1 - kFullUntil), 0.0, 1.0);
}

}  // namespace plumb
