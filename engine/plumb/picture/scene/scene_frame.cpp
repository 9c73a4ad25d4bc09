#include "plumb/picture/scene/scene_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

// For coordinates divided by 4. Smaller objects are drawn as points.
constexpr double kLeastScale = 1e-290;
// A part of the coordinates. Doubles do not distinguish points that are nearer.
constexpr double kLeastPart = 1e-9;
// A part of the longest side. A window has at least this extent in every direction.
constexpr double kThinnest = 0.02;

Point3 quartered(const Point3& p) { return {p.x / 4, p.y / 4, p.z / 4}; }
double largest(const Point3& p) {
  return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
}

}  // namespace

void SceneFrame::include(const Point3& p) {
  const Point3 q = quartered(p);
  low_ = {std::min(low_.x, q.x), std::min(low_.y, q.y), std::min(low_.z, q.z)};
  high_ = {std::max(high_.x, q.x), std::max(high_.y, q.y), std::max(high_.z, q.z)};
}

void SceneFrame::close(double margin) {
  if (is_empty()) include({0, 0, 0});
  centre_ = {(low_.x + high_.x) / 2, (low_.y + high_.y) / 2, (low_.z + high_.z) / 2};
  const Point3 reach{high_.x - centre_.x, high_.y - centre_.y, high_.z - centre_.z};
  double longest = largest(reach);
  if (longest == 0) longest = std::max(.25, kLeastPart * largest(centre_));
  longest = std::max(longest, kLeastScale);
  scale_ = longest * (1 + 2 * margin);
  const auto half = [&](double r) {
    return std::max(r + 2 * margin * longest, kThinnest * longest) / scale_;
  };
  half_ = {half(reach.x), half(reach.y), half(reach.z)};
}

Point3 SceneFrame::at(const Point3& p) const {
  const Point3 q = quartered(p);
  return {(q.x - centre_.x) / scale_, (q.y - centre_.y) / scale_, (q.z - centre_.z) / scale_};
}

Point3 SceneFrame::at(const RationalPoint3& p) const {
  const Rational scale = exact_rational(scale_);
  const auto along = [&scale](const Rational& x, double centre) {
    return clamped_to_finite(nearest_double(Rational((x / 4 - exact_rational(centre)) / scale)));
  };
  return {along(p.x, centre_.x), along(p.y, centre_.y), along(p.z, centre_.z)};
}

Point3 SceneFrame::corner(double sign) const {
  const auto along = [&](double centre, double half) {
    return clamped_to_finite(4 * (centre + sign * half * scale_));
  };
  return {along(centre_.x, half_.x), along(centre_.y, half_.y), along(centre_.z, half_.z)};
}

void SceneFrame::describe(Scene& scene) const {
  scene.half = half_;
  scene.quarter_centre = centre_;
  scene.quarter_scale = scale_;
}

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
