// What polygons, lines and points mean, point by point, by rationals.
#pragma once

#include <vector>

#include "plumb/io/plane_io.h"
#include "plumb/testing/exact.h"

namespace plumb::testing {

enum class ShapePlace {
  Outside,
  Inside,
  OnRing,  ///< on a ring of a polygon: what is right there depends on the other rings
};

/// Shapes with independent coordinates.
class ShapeTwin {
 public:
  explicit ShapeTwin(const PlaneShapes& shapes);

  /// Inside: in a polygon by the even-odd rule of its rings, on a line, or a point.
  ShapePlace place(const ExactPoint& p) const;

 private:
  using Chain = std::vector<ExactPoint>;
  static bool is_on(const Chain& chain, const ExactPoint& p);
  static bool is_odd(const std::vector<Chain>& rings, const ExactPoint& p);

  std::vector<std::vector<Chain>> polygons_;  // rings with their first point again
  std::vector<Chain> lines_;                  // points are lines of one point
};

/// At most `count` points where something may be: corners, middles of edges, and centres of corners
/// that follow each other, which lie on an edge or in a face.
std::vector<ExactPoint> telling_points(const PlaneShapes& shapes, std::size_t count);

}  // namespace plumb::testing
