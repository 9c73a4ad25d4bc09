// From the coordinates of a map to those of a picture.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plumb/picture/svg/svg_text.h"
#include "plumb/plane/map.h"
#include "plumb/plane/nef2.h"
#include "plumb/plane/plane_complex.h"

namespace plumb {

/// Where nearly all of the points lie: the fortieth part of them at each of the four sides is cut
/// off.
Rectangle core_of(const std::vector<Point2>& points);

/// The window for a picture of `all`: its core, a little grown, where that leaves out more than
/// half of it, which few things far off would take up; else `all`.
Rectangle without_far_parts(const Rectangle& core, const Rectangle& all);

/// A map in plane coordinates (svg_text.h): y upwards, everything used by a cycle within [-1, 1].
/// A cycle counts as counter-clockwise by its area in doubles, which is only good for drawing.
class Plane {
 public:
  explicit Plane(const Map& map);

  const Map& map() const { return map_; }
  Point2 at(std::uint32_t vertex) const { return at(map_.points.approx(vertex)); }
  /// Any point; far or non-finite ones are moved to the border of [-2, 2].
  Point2 at(Point2 p) const;
  /// What the vertices in use span; (0, 0) alone if there are none.
  const Rectangle& extent() const { return extent_; }

  /// Where nearly all corners lie.
  Rectangle core() const;

  std::vector<Point2> ring(std::size_t cycle) const;

 private:
  void find_scale();
  void find_extent();

  const Map& map_;
  double factor_1_ = 1, factor_2_ = 1;  // one power of two, in two steps: it may overflow
  Point2 centre_{};
  Rectangle extent_{};
};

/// A window of the plane, shown in a frame of the picture, equally scaled in x and y.
class View {
 public:
  /// Shows `window` as large as it fits, in the middle of `frame`.
  View(const Rectangle& frame, const Rectangle& window);

  const Rectangle& frame() const { return frame_; }
  /// The part of the plane that the frame shows, grown a little so that cut edges do not show.
  const Rectangle& window() const { return window_; }
  double scale() const { return scale_; }
  Point2 place(Point2 p) const {
    return {frame_.centre().x + (p.x - centre_.x) * scale_,
            frame_.centre().y - (p.y - centre_.y) * scale_};
  }

  /// The part of a closed polygon in the window. O(points).
  std::vector<Point2> clipped(std::vector<Point2> ring) const;
  std::optional<std::pair<Point2, Point2>> clipped(Point2 a, Point2 b) const;

 private:
  Rectangle frame_, window_;
  Point2 centre_;
  double scale_;
};

// The part of the plane that a picture of a complex shows: a box with exact borders, so that what
// goes on to infinity can be cut off exactly.

class PlaneWindow {
 public:
  /// Around all vertices of the complex and a point of each line without vertices; [-1, 1]^2 when
  /// there is nothing. `margin` is left free on every side, as a part of the longer side.
  PlaneWindow(const PlaneComplex& complex, double margin);

  /// The corners, counter-clockwise from the lower left.
  PointTable2 corners() const;
  /// height / width, between 0.45 and 1.15.
  double aspect() const { return half_height_; }

  /// Window coordinates of a point: the middle is (0, 0), the left and right borders are x = -1 and
  /// x = 1, equally scaled in y. Good to 2^-25 of the window's width wherever the window lies.
  Point2 at(const PlanePoints& points, std::uint32_t i) const;
  /// The borders that a point lies on, exactly: 1 left, 2 right, 4 bottom, 8 top.
  unsigned borders(const PlanePoints& points, std::uint32_t i) const;

  /// Round values along an axis and where they lie in window coordinates.
  struct Tick {
    double at;
    std::string text;
  };
  /// None where doubles cannot tell them apart in a few digits.
  std::vector<Tick> ticks(bool is_vertical) const;

 private:
  void surround(const Rational& left, const Rational& bottom, const Rational& right,
                const Rational& top, double margin);

  Rational left_, bottom_, right_, top_;
  Rational centre_x_, centre_y_, half_;  // half the width
  double half_height_ = 1;               // window coordinates
  bool is_plain_ = false;                // doubles are good enough
  double plain_x_ = 0, plain_y_ = 0, plain_half_ = 1;
};

/// The part of the set inside the window, which is open. O(n log n).
Nef2 cut_at(const Nef2& set, const PlaneWindow& window);

}  // namespace plumb
