// Pictures of results, and the text and numbers of SVG files. Pictures decide nothing: drawing may
// round, the engine never does.
//
// Notation:
//   plane coordinates    the map's coordinates, centred and scaled by a power of two to lie in [-1,
//   1]: 1e300 and 5e-324 are ordinary afterwards (Plane)
//   picture units        SVG user units, y downwards; text, marks and strokes have sizes in these,
//   so that they are legible whatever the size of the map
//   view                 a window of the plane shown in a frame of the picture (View)
//
// Main flow of write_map_svg() (map_svg.h):
//  1. Plane, View          find where vertices lie
//  2. colour_cycles        gives soft colours, different for neighbours
//  3. Painter              paints the largest cycle first; a clockwise cycle paints background, so
//                          holes come out right for valid and defective maps alike
//  4. choose_insets        chooses close-ups where defects are too small to be seen
//  5. MapMarks             draws, per view, defect edges, a symbol at each defect, and numbered
//                          labels
//  6. layout               arranges title, close-ups, map, legend, the list of the first defects,
//                          and notes
//
// Everything is bounded: points and polygons per view, marks, labels, close-ups, lines of text.
// What a bound left out is stated in the notes of the picture.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

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

// Text and numbers of an SVG file.

/// Returns text for XML content and attributes: & < > " ' escaped; control characters and bytes
/// that are not UTF-8 become U+FFFD.
std::string xml_escaped(std::string_view text);

/// Returns a picture coordinate with at most two decimals. Values that are not finite or lie far
/// off the picture are clamped.
std::string svg_number(double value);

/// Returns the attributes x, y, width and height of a rectangle.
std::string svg_box(const Rectangle& r);

/// Returns an upper estimate of the width of `text` in a sans-serif font.
double text_width(std::string_view text, double font_size);

/// Returns text broken at spaces into lines no wider than `width`; at most `max_lines`, the last of
/// them ending with an ellipsis if something was left out.
std::vector<std::string> wrapped(std::string_view text, double font_size, double width,
                                 std::size_t max_lines);

/// Path data in tenths of a picture unit, with relative moves: to be drawn inside a group scaled by
/// 0.1. Points closer than 0.3 units to the last one written are left out.
class PathData {
 public:
  void move_to(Point2 p);
  void line_to(Point2 p);
  void close();
  bool empty() const { return data_.empty(); }
  std::size_t points() const { return points_; }
  const std::string& data() const { return data_; }

 private:
  void write(char command, Point2 p);

  std::string data_;
  long last_x_ = 0, last_y_ = 0;    // The last point written.
  long start_x_ = 0, start_y_ = 0;  // Start of the current subpath, to which `z` returns.
  std::size_t points_ = 0;
};

// Bytes inside text files (RFC 4648).

/// Returns the base64 text of some bytes.
std::string base64(std::string_view bytes);

}  // namespace plumb
