// From the coordinates of a map to those of a picture.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "plumb/picture/picture.h"
#include "plumb/plane/map.h"

namespace plumb {

/// Where nearly all of the points lie: the fortieth part of them at each of the four sides is cut
/// off.
Rectangle core_of(const std::vector<Point2>& points);

/// The window for a picture of `all`: its core, a little grown, where that leaves out more than
/// half of it, which few things far off would take up; else `all`.
Rectangle without_far_parts(const Rectangle& core, const Rectangle& all);

/// A map in plane coordinates (picture.h): y upwards, everything used by a cycle within [-1, 1].
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

}  // namespace plumb
