// Text and numbers of an SVG file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "plumb/picture/picture.h"

namespace plumb {

/// Ready for XML content and attributes: & < > " ' escaped; control characters and bytes that are
/// not UTF-8 become U+FFFD.
std::string xml_escaped(std::string_view text);

/// A picture coordinate with at most two decimals. Values that are not finite or lie far off the
/// picture are clamped.
std::string svg_number(double value);

/// attr="x" pairs of a rectangle: x, y, width, height.
std::string svg_box(const Rectangle& r);

/// An upper estimate of the width of `text` in a sans-serif font.
double text_width(std::string_view text, double font_size);

/// Breaks text at spaces into lines no wider than `width`; at most `max_lines`, the last of them
/// ending with an ellipsis when something was left out.
std::vector<std::string> wrapped(std::string_view text, double font_size, double width,
                                 std::size_t max_lines);

/// Path data in tenths of a picture unit, relative moves: drawn inside a group scaled by 0.1.
/// Points closer than 0.3 units to the last one written are left out.
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
  long last_x_ = 0, last_y_ = 0;    // the last point written
  long start_x_ = 0, start_y_ = 0;  // of the current subpath: `z` returns there
  std::size_t points_ = 0;
};

}  // namespace plumb
