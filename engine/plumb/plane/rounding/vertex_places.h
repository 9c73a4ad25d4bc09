// Where vertices go: to the nearest doubles, to a coarser local grid, or to the centres of hot
// pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/plane_complex.h"
#include "plumb/plane/rounding/labelled_edges.h"
#include "plumb/predicates/rational_point.h"

namespace plumb {

/// Returns the distance from |value| to the next greater double, or to the next lesser one if
/// |value| is the greatest double. Requires a finite value.
double ulp_of(double value);

/// Returns the greatest magnitude of a coordinate, and 0 if there are no points.
double largest_coordinate(std::span<const Point2> points);

/// Returns, for each vertex, the nearest doubles. Throws Error{NumberOutOfRange} if a coordinate
/// lies beyond the largest double.
std::vector<VertexPlace> nearest_places(const PlaneComplex& complex, Context& context);

/// Returns the places of the vertices of an arrangement of doubles. A vertex that is a point of the
/// input stays. A crossing goes to the nearest doubles if `level` is 0. Otherwise it goes to the
/// nearest point whose coordinates are multiples of local_step(nearest doubles, level).
std::vector<VertexPlace> places_of_crossings(const PlaneComplex& complex, int level,
                                             Context& context);

/// Returns 2^(level - 1) ulp of the greater coordinate of a point. Requires level > 0. The result
/// may be infinite.
double local_step(Point2 p, int level);

/// Whether a segment meets the closed square with the given centre and half of a side.
bool meets_square(Point2 from, Point2 to, Point2 centre, double half);

/// The pixels of a grid that contain vertices of a complex. The pixel with the centre c contains
/// the points p with c - step / 2 <= p < c + step / 2, for each coordinate. Centres are multiples
/// of the step, rounded to the nearest doubles when a vertex is placed there.
class HotPixels {
 public:
  /// Finds the pixels of all vertices. Requires step > 0. Throws Error{NumberOutOfRange} if a
  /// centre lies beyond the largest double.
  HotPixels(const PlaneComplex& complex, const Rational& step, Context& context);

  /// Returns the place to which a point goes.
  Point2 place_of(const RationalPoint2& p) const { return place_of_centre(centre_of(p)); }
  /// Returns the places of all hot pixels. Entry i is the place of pixel i.
  const std::vector<Point2>& places() const { return places_; }
  /// Returns the pixel of vertex v.
  std::uint32_t pixel_of(VertexId v) const { return pixel_of_[v]; }
  /// Returns a bound for the distance by which a point moves (maximum norm).
  double move() const { return move_; }
  /// Appends the hot pixels that the edge from v to w meets, in the order from v to w. The first is
  /// the pixel of v, and the last is the pixel of w. Cost: O(log n) for each column of hot pixels
  /// between v and w, and an exact test for each pixel that the edge nearly meets.
  void route(VertexId v, VertexId w, std::vector<std::uint32_t>& pixels) const;

 private:
  /// A part of an edge, by its parameter from 0 to 1.
  struct Passage {
    Rational enters;
    Rational leaves;
    std::uint32_t pixel;
  };

  RationalPoint2 centre_of(const RationalPoint2& p) const;
  static Point2 place_of_centre(const RationalPoint2& centre);
  void group_by_place();
  void visit_column(std::size_t column, VertexId v, VertexId w,
                    std::vector<Passage>& passages) const;
  bool passes(VertexId v, VertexId w, std::uint32_t pixel, Passage& passage) const;

  Rational step_;
  Rational half_;
  double step_above_;  // Step, rounded up.
  double move_;
  std::vector<RationalPoint2> vertices_;
  std::vector<RationalPoint2> centres_;  // Of the pixels, sorted by place.
  std::vector<Point2> places_;
  IdVector<VertexId, std::uint32_t> pixel_of_;
  std::vector<std::uint32_t> column_begin_;  // The first pixel of each abscissa, and the end.
};

}  // namespace plumb
