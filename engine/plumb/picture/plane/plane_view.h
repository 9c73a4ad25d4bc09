// Maps the coordinates of a map or a complex to coordinates of a picture.
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

/// Returns where nearly all of the points lie: a fortieth of them is cut off at each of the four
/// sides.
Rectangle core_of(const std::vector<Point2>& points);

/// Returns the window for a picture of `all`: its core, slightly grown, if that leaves out more
/// than half of `all`, which a few distant things would occupy; else `all`.
Rectangle without_far_parts(const Rectangle& core, const Rectangle& all);

/// A map in plane coordinates (svg_text.h): y upwards, everything used by a cycle within [-1, 1]. A
/// cycle counts as counter-clockwise by its area in doubles, which is good enough for drawing only.
class Plane {
 public:
  explicit Plane(const Map& map);

  const Map& map() const { return map_; }
  Point2 at(std::uint32_t vertex) const { return at(map_.points.approx(vertex)); }
  /// Returns the place of any point; a distant point, or a point that is not finite, is moved to
  /// the border of [-2, 2].
  Point2 at(Point2 p) const;
  /// Returns the box of the vertices in use; (0, 0) alone if there are none.
  const Rectangle& extent() const { return extent_; }

  /// Returns where nearly all corners lie.
  Rectangle core() const;

  /// Returns the places of the corners of a cycle.
  std::vector<Point2> ring(std::size_t cycle) const;

 private:
  void find_scale();
  void find_extent();

  const Map& map_;
  double factor_1_ = 1, factor_2_ = 1;  // One power of two, in two steps, because it may overflow.
  Point2 centre_{};
  Rectangle extent_{};
};

/// A window of the plane, shown in a frame of the picture, equally scaled in x and y.
class View {
 public:
  /// Shows `window` as large as it fits, in the middle of `frame`.
  View(const Rectangle& frame, const Rectangle& window);

  const Rectangle& frame() const { return frame_; }
  /// Returns the part of the plane that the frame shows, slightly grown so that cut edges do not
  /// show.
  const Rectangle& window() const { return window_; }
  double scale() const { return scale_; }
  Point2 place(Point2 p) const {
    return {frame_.centre().x + (p.x - centre_.x) * scale_,
            frame_.centre().y - (p.y - centre_.y) * scale_};
  }

  /// Returns the part of a closed polygon in the window. Cost: O(points).
  std::vector<Point2> clipped(std::vector<Point2> ring) const;
  /// Returns the part of a segment in the window; no value if there is none.
  std::optional<std::pair<Point2, Point2>> clipped(Point2 a, Point2 b) const;

 private:
  Rectangle frame_, window_;
  Point2 centre_;
  double scale_;
};

// The part of the plane that a picture of a complex shows: a box with exact borders, so that
// unbounded cells can be cut off exactly.

class PlaneWindow {
 public:
  /// Surrounds all vertices of the complex and a point of each line without vertices; [-1, 1]^2 if
  /// there is nothing. `margin` is left free on every side, as a part of the longer side.
  PlaneWindow(const PlaneComplex& complex, double margin);

  /// Returns the corners, counter-clockwise from the lower left.
  PointTable2 corners() const;
  /// Returns height / width, between 0.45 and 1.15.
  double aspect() const { return half_height_; }

  /// Returns the window coordinates of a point: the middle is (0, 0), and the left and right
  /// borders are x = -1 and x = 1, equally scaled in y. The error is at most 2^-25 of the width of
  /// the window, for every position of the window.
  Point2 at(const PlanePoints& points, std::uint32_t i) const;
  /// Returns the borders that a point lies on, exactly: 1 left, 2 right, 4 bottom, 8 top.
  unsigned borders(const PlanePoints& points, std::uint32_t i) const;

  /// A round value along an axis, and where it lies in window coordinates.
  struct Tick {
    double at;
    std::string text;
  };
  /// Returns round values; none if a few digits of a double cannot distinguish them.
  std::vector<Tick> ticks(bool is_vertical) const;

 private:
  void surround(const Rational& left, const Rational& bottom, const Rational& right,
                const Rational& top, double margin);

  Rational left_, bottom_, right_, top_;
  Rational centre_x_, centre_y_, half_;  // Half of the width.
  double half_height_ = 1;               // In window coordinates.
  bool is_plain_ = false;                // Whether doubles are accurate enough.
  double plain_x_ = 0, plain_y_ = 0, plain_half_ = 1;
};

/// Returns the part of the set inside the window, which is open. Throws the errors of the Context.
/// Cost: O(n log n).
Nef2 cut_at(const Nef2& set, const PlaneWindow& window, Context& context);

}  // namespace plumb
