// Pictures of results. Nothing here decides anything: drawing may round, the engine never does.
//
// Notation:
//   plane coordinates    the map's coordinates, centred and scaled by a power of two to lie
//                        in [-1, 1]: 1e300 and 5e-324 are ordinary afterwards (Plane)
//   picture units        SVG user units, y downwards; text, marks and strokes have sizes in these, so
//                        that they are legible whatever the size of the map
//   view                 a window of the plane shown in a frame of the picture (View)
//
// Flow of write_map_svg (map_svg.h):
//  1. Plane, View          where vertices come to lie
//  2. colour_cycles        soft colours, neighbours differ
//  3. paint_cycles         largest first; a clockwise cycle paints background: holes come out right
//                          for valid and defective maps alike
//  4. choose_insets        where defects are too small to be seen, zoomed views of them
//  5. MarkPainter          per view: defect edges, a symbol at each defect, numbered labels
//  6. layout               title, insets, map, legend, list of the first defects, notes
//
// Everything is bounded: points and polygons per view, marks, labels, insets, lines of text. What a
// bound left out is said in the notes of the picture.
#pragma once

#include <algorithm>

#include "plumb/predicates/point.h"

namespace plumb {

/// An axis-parallel rectangle, of the plane or of the picture.
struct Rectangle {
  double left = 0, top = 0, right = 0, bottom = 0;

  static Rectangle around(Point2 c, double half_width, double half_height) {
    return {c.x - half_width, c.y - half_height, c.x + half_width, c.y + half_height};
  }
  double width() const { return right - left; }
  double height() const { return bottom - top; }
  Point2 centre() const { return {left + width() / 2, top + height() / 2}; }
  bool contains(Point2 p) const {
    return left <= p.x && p.x <= right && top <= p.y && p.y <= bottom;
  }
  bool overlaps(const Rectangle& o) const {
    return left < o.right && o.left < right && top < o.bottom && o.top < bottom;
  }
  bool contains(const Rectangle& o) const {
    return left <= o.left && o.right <= right && top <= o.top && o.bottom <= bottom;
  }
  Rectangle grown(double by) const { return {left - by, top - by, right + by, bottom + by}; }
  Rectangle within(const Rectangle& o) const {
    return {std::max(left, o.left), std::max(top, o.top), std::min(right, o.right),
            std::min(bottom, o.bottom)};
  }
  void include(Point2 p) {
    left = std::min(left, p.x);
    top = std::min(top, p.y);
    right = std::max(right, p.x);
    bottom = std::max(bottom, p.y);
  }
};

}  // namespace plumb
