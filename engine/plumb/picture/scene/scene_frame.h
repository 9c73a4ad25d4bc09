// From coordinates to those of a scene.
#pragma once

#include <cstddef>

#include "plumb/picture/scene.h"
#include "plumb/predicates/rational_point.h"

namespace plumb {

/// The box around points that are added one by one. In quarters of their coordinates, so that no
/// difference overflows.
class SceneFrame {
 public:
  void include(const Point3& p);
  bool is_empty() const { return low_.x > high_.x; }
  /// Leaves `margin` of the longest side free on every side. Before the first use of the next
  /// members.
  void close(double margin);

  Point3 at(const Point3& p) const;
  Point3 at(const RationalPoint3& p) const;
  /// The corners of the box, as they are in space; clamped to the finite.
  Point3 low() const { return corner(-1); }
  Point3 high() const { return corner(1); }
  /// Says in the scene where its points are.
  void describe(Scene& scene) const;

 private:
  Point3 corner(double sign) const;

  static constexpr double kFar = 1e308;
  Point3 low_{kFar, kFar, kFar}, high_{-kFar, -kFar, -kFar};
  Point3 centre_{0, 0, 0}, half_{1, 1, 1};
  double scale_ = .25;  // in quarters, as the others; half_ alone is in scene units
};

// Colours for things of one kind that have to be told apart.

/// Light colours, far apart however many: hues by the golden section, in three strengths.
Colour distinct_colour(std::size_t i);

}  // namespace plumb
