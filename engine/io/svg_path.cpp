#include "plumb/io/svg_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plumb/base/degrees.h"
#include "plumb/base/error.h"

namespace plumb {
namespace {

constexpr double kPi = std::numbers::pi;

bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
bool is_letter(char c) { return is_lower(c) || (c >= 'A' && c <= 'Z'); }
char upper(char c) { return is_lower(c) ? static_cast<char>(c - 'a' + 'A') : c; }

Point2 reflected(Point2 p, Point2 about) { return {2 * about.x - p.x, 2 * about.y - p.y}; }

class PathReader {
 public:
  PathReader(SvgValue& text, SvgOutline& outline) : text_(text), outline_(outline) {}

  void read() {
    for (char command = 0; !text_.at_end();) {
      outline_.step();
      const char next = text_.peek();
      if (is_letter(next)) {
        command = next;
        place_ = text_.position();
        if (is_first_ && upper(command) != 'M') text_.fail_expected("a path to begin with M");
        text_.skip();
      } else if (command == 0 || upper(command) == 'Z') {
        text_.fail_expected("a command of paths");
      } else if (upper(command) == 'M') {
        command = command == 'M' ? 'L' : 'l';  // more pairs of numbers are lines
      }
      run(command);
    }
    outline_.close_ring();
  }

 private:
  void run(char command);
  void arc(bool is_relative);

  Point2 point(bool is_relative) {
    const double x = text_.number();
    const double y = text_.number();
    return is_relative ? Point2{at_.x + x, at_.y + y} : Point2{x, y};
  }
  double coordinate(bool is_relative, double origin) {
    return text_.number() + (is_relative ? origin : 0);
  }
  /// After Z a subpath begins where the last one did.
  void open() {
    if (is_open_) return;
    outline_.move_to(text_.cursor(), start_);
    is_open_ = true;
  }
  void line(Point2 to) {
    open();
    outline_.line_to(text_.cursor(), to);
    end_at(to, to, to);
  }
  void cubic(Point2 c1, Point2 c2, Point2 to) {
    open();
    outline_.cubic_to(text_.cursor(), c1, c2, to);
    end_at(to, c2, to);
  }
  void quadratic(Point2 c, Point2 to) {
    open();
    outline_.quadratic_to(text_.cursor(), c, to);
    end_at(to, to, c);
  }
  void end_at(Point2 to, Point2 cubic, Point2 quadratic) {
    at_ = to;
    cubic_ = cubic;
    quadratic_ = quadratic;
  }

  SvgValue& text_;
  SvgOutline& outline_;
  bool is_first_ = true, is_open_ = false;
  const char* place_ = nullptr;
  Point2 start_, at_;
  Point2 cubic_, quadratic_;  // the last control point, if the last command had one
};

void PathReader::run(char command) {
  const bool is_relative = is_lower(command);
  switch (upper(command)) {
    case 'M':
      start_ = point(is_relative);
      is_first_ = false;
      is_open_ = false;
      end_at(start_, start_, start_);
      break;
    case 'Z':
      outline_.close_ring();
      is_open_ = false;
      end_at(start_, start_, start_);
      break;
    case 'L':
      return line(point(is_relative));
    case 'H':
      return line({coordinate(is_relative, at_.x), at_.y});
    case 'V':
      return line({at_.x, coordinate(is_relative, at_.y)});
    case 'C':
    case 'S': {
      const Point2 c1 = upper(command) == 'C' ? point(is_relative) : reflected(cubic_, at_);
      const Point2 c2 = point(is_relative);
      return cubic(c1, c2, point(is_relative));
    }
    case 'Q':
    case 'T': {
      const Point2 c = upper(command) == 'Q' ? point(is_relative) : reflected(quadratic_, at_);
      return quadratic(c, point(is_relative));
    }
    case 'A':
      return arc(is_relative);
    default:
      text_.fail(ErrorCode::Syntax, quoted({&command, 1}) + " is no command of paths", place_);
  }
}

/// From the ends to the centre: SVG 1.1, appendix F.6.5. Radii that do not reach are enlarged.
void PathReader::arc(bool is_relative) {
  double rx = std::fabs(text_.number());
  double ry = std::fabs(text_.number());
  const double turn = text_.number();
  const bool is_large = text_.flag();
  const bool is_clockwise = text_.flag();
  const Point2 to = point(is_relative);
  if (to == at_) return end_at(to, to, to);
  if (rx == 0 || ry == 0) return line(to);
  open();
  const Point2 axis = unit_vector(turn);
  const Point2 half{(at_.x - to.x) / 2, (at_.y - to.y) / 2};
  // In units of the radii, along them.
  Point2 p{(axis.x * half.x + axis.y * half.y) / rx, (axis.x * half.y - axis.y * half.x) / ry};
  const double reach = std::hypot(p.x, p.y);
  if (!std::isfinite(reach)) {
    text_.fail(ErrorCode::NumberOutOfRange, "an arc beyond the largest double", place_);
  }
  if (reach == 0) return line(to);  // as good as straight
  double off = 0;
  if (reach >= 1) {
    rx *= reach;
    ry *= reach;
    p = {p.x / reach, p.y / reach};
  } else {
    off = std::sqrt((1 - reach) * (1 + reach)) / reach * (is_large == is_clockwise ? -1 : 1);
  }
  const Point2 c{off * p.y, -off * p.x};
  const Point2 u{axis.x * rx, axis.y * rx}, v{-axis.y * ry, axis.x * ry};
  const Point2 centre{(at_.x + to.x) / 2 + c.x * u.x + c.y * v.x,
                      (at_.y + to.y) / 2 + c.x * u.y + c.y * v.y};
  const double from = std::atan2(p.y - c.y, p.x - c.x);
  double end = std::atan2(-p.y - c.y, -p.x - c.x);
  // At least half a turn if it is large, at most that if not: rounding decides neither nothing nor a whole turn.
  const double least = is_large ? kPi / 2 : -kPi / 2;
  if (is_clockwise && end - from < least) end += 2 * kPi;
  if (!is_clockwise && from - end < least) end -= 2 * kPi;
  outline_.arc_to(text_.cursor(), centre, u, v, from, end, to);
  end_at(to, to, to);
}

}  // namespace

void read_svg_path(SvgValue& text, SvgOutline& outline) { PathReader(text, outline).read(); }

void add_svg_ellipse(const TextCursor& at, Point2 centre, double rx, double ry,
                     SvgOutline& outline) {
  const Point2 start{centre.x + rx, centre.y};
  outline.move_to(at, start);
  outline.arc_to(at, centre, {rx, 0}, {0, ry}, 0, 2 * kPi, start);
}

}  // namespace plumb
