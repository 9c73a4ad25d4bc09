// Maps coordinates of space to coordinates of a scene, and chooses colours for things of one kind.
#pragma once

#include <cstddef>

#include "plumb/picture/scene.h"
#include "plumb/predicates/rational_point.h"

namespace plumb {

/// The box around points that are added one by one. Numbers are held in quarters, so that no
/// difference overflows.
class SceneFrame {
 public:
  void include(const Point3& p);
  bool is_empty() const { return low_.x > high_.x; }
  /// Leaves `margin` of the longest side free on every side. Required before the following members
  /// are used.
  void close(double margin);

  /// Returns the scene coordinates of a point.
  Point3 at(const Point3& p) const;
  Point3 at(const RationalPoint3& p) const;
  /// Returns a corner of the box in space, clamped to finite numbers.
  Point3 low() const { return corner(-1); }
  Point3 high() const { return corner(1); }
  /// Notes in the scene where its points are in space.
  void describe(Scene& scene) const;

 private:
  Point3 corner(double sign) const;

  static constexpr double kFar = 1e308;
  Point3 low_{kFar, kFar, kFar}, high_{-kFar, -kFar, -kFar};
  Point3 centre_{0, 0, 0}, half_{1, 1, 1};
  double scale_ = .25;  // In quarters, like the others; half_ alone is in scene units.
};

// Colours for things of one kind that must be distinguished.

/// Returns a light colour, far from the others however many there are: hues by the golden section,
/// in three strengths.
Colour distinct_colour(std::size_t i);

}  // namespace plumb
