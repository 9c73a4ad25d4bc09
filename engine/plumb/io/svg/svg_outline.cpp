// Flattening of SVG outlines, and the reading of path data.
//
// A curve over parameters 0 to 1 with second derivative at most M is at most M / (8 n^2) away from
// n equal chords, so n = ceil(sqrt(M / (8 tolerance))) chords suffice. M comes from control points:
// for a Bezier curve of degree d it is d (d - 1) times the largest second difference, because the
// second derivative is a Bezier curve over those; for an elliptic arc, M is the largest distance
// from the centre times the square of the angle. A rational curve is halved until its control
// points are within the tolerance of the chord. The map of the element is applied before
// flattening, so the tolerance is measured in the drawing.
//
// PathReader turns commands into calls of the outline. Elliptic arcs are converted from end points
// to centre as in SVG 1.1, appendix F.6.5. Radii that are too small are enlarged.
// Tested by tests/io/svg_reader_test.cpp.
#include "plumb/io/svg/svg_outline.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "plumb/base/internal/degrees.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/arithmetic/elementary.h"
#include "plumb/predicates/error.h"

namespace plumb {
namespace {

constexpr std::uint64_t kPointBytes = 2 * (sizeof(Point2) + sizeof(std::size_t));
constexpr std::uint64_t kRingBytes = 5 * sizeof(std::uint32_t);
constexpr std::size_t kPointsOfAnyText = std::size_t{1} << 20U;
constexpr std::size_t kBytesPerPoint = 7;  // So many bytes of the text allow one more point.
// This is the greatest number of points that a surface can hold.
constexpr std::size_t kMostPoints = std::size_t{1} << 30U;
constexpr std::size_t kPointsPerCheckpoint = 4096;

Point2 mixed(Point2 a, double s, Point2 b, double t) {
  return {s * a.x + t * b.x, s * a.y + t * b.y};
}

/// Returns the length of the second difference a - 2 b + c of three control points: how much a
/// curve bends at the middle one.
double bend_at(Point2 a, Point2 b, Point2 c) {
  return std::hypot(a.x - 2 * b.x + c.x, a.y - 2 * b.y + c.y);
}

Point2 on_cubic(const std::array<Point2, 4>& p, double t) {
  const double s = 1 - t;
  const Point2 begin = mixed(p[0], s * s * s, p[1], 3 * s * s * t);
  const Point2 end = mixed(p[2], 3 * s * t * t, p[3], t * t * t);
  return {begin.x + end.x, begin.y + end.y};
}

}  // namespace

SvgTransform product(const SvgTransform& first, const SvgTransform& second) {
  const auto& [a, b, c, d, e, f] = first;
  const Point2 origin = applied(first, {second.e, second.f});
  return {a * second.a + c * second.b,
          b * second.a + d * second.b,
          a * second.c + c * second.d,
          b * second.c + d * second.d,
          origin.x,
          origin.y};
}

Point2 applied(const SvgTransform& t, Point2 p) {
  return {t.a * p.x + t.c * p.y + t.e, t.b * p.x + t.d * p.y + t.f};
}

void SvgOutline::require_finite(const TextCursor& at, Point2 p) {
  if (std::isfinite(p.x) && std::isfinite(p.y)) return;
  at.fail(ErrorCode::NumberOutOfRange, "a point beyond the largest double");
}

Point2 SvgOutline::placed(const TextCursor& at, Point2 p) const {
  const Point2 placed = applied(transform_, p);
  require_finite(at, placed);
  return placed;
}

std::size_t SvgOutline::most_points(std::size_t bytes) {
  return std::min(kMostPoints, kPointsOfAnyText + bytes / kBytesPerPoint);
}

void SvgOutline::step() {
  if (++steps_ % kPointsPerCheckpoint == 0) context_.checkpoint("flatten", steps_, steps_);
}

void SvgOutline::add(const TextCursor& at, Point2 placed) {
  step();
  require_finite(at, placed);
  with_place(at, [&] { context_.charge_memory(kPointBytes, "the drawing"); });
  if (drawing_.points.size() == most_points_) {
    at.fail(ErrorCode::ResourceLimit, "more than " + std::to_string(most_points_) +
                                          " points in a drawing of this size: cut it into several");
  }
  drawing_.points.push_back(placed);
  drawing_.places.push_back(static_cast<std::size_t>(at.position() - text_));
}

void SvgOutline::move_to(const TextCursor& at, Point2 p) {
  close_ring();
  with_place(at, [&] { context_.charge_memory(kRingBytes, "the drawing"); });
  add(at, placed(at, p));
}

void SvgOutline::line_to(const TextCursor& at, Point2 p) { add(at, placed(at, p)); }

double SvgOutline::tolerance(const TextCursor& at) const {
  if (tolerance_) return *tolerance_;
  at.fail(ErrorCode::BadShape,
          "a curve in a drawing without viewBox, width and height: give a tolerance");
}

/// Returns the number of chords. A chord over parameters h apart is at most h^2 / 8 times the
/// second derivative away from its curve.
std::size_t SvgOutline::chords(const TextCursor& at, double bend) {
  const double count = std::ceil(std::sqrt(bend / (8 * tolerance(at))));
  if (!(count <= static_cast<double>(most_points_ - drawing_.points.size()))) {
    at.fail(ErrorCode::ResourceLimit,
            "more than " + std::to_string(most_points_) +
                " points in a drawing of this size, where this curve is to be that close: a larger "
                "tolerance takes fewer");
  }
  return std::max<std::size_t>(1, static_cast<std::size_t>(count));
}

void SvgOutline::cubic_to(const TextCursor& at, Point2 c1, Point2 c2, Point2 p) {
  const std::array<Point2, 4> placed_curve{drawing_.points.back(), placed(at, c1), placed(at, c2),
                                           placed(at, p)};
  const auto& [a, b, c, d] = placed_curve;
  constexpr double kCubic = 6;
  const std::size_t n = chords(at, kCubic * std::max(bend_at(a, b, c), bend_at(b, c, d)));
  for (std::size_t i = 1; i < n; ++i) {
    add(at, on_cubic(placed_curve, static_cast<double>(i) / static_cast<double>(n)));
  }
  add(at, d);
}

void SvgOutline::quadratic_to(const TextCursor& at, Point2 c, Point2 p) {
  const Point2 from = drawing_.points.back(), middle = placed(at, c), to = placed(at, p);
  constexpr double kQuadratic = 2;
  const std::size_t n = chords(at, kQuadratic * bend_at(from, middle, to));
  for (std::size_t i = 1; i < n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n), s = 1 - t;
    const Point2 begin = mixed(from, s * s, middle, 2 * s * t);
    add(at, mixed(begin, 1, to, t * t));
  }
  add(at, to);
}

void SvgOutline::rational_to(const TextCursor& at, std::span<const WeightedPoint> control) {
  std::array<WeightedPoint, kMostDegree + 1> moved{};
  for (std::size_t i = 0; i < control.size(); ++i) {
    const auto& [x, y, w] = control[i];
    const Point2 p = placed(at, {x / w, y / w});
    moved[i] = {p.x * w, p.y * w, w};
    require_finite(at, {moved[i].x, moved[i].y});
  }
  add_rational(at, std::span(moved).first(control.size()), tolerance(at), 0);
}

/// Whether no control point is farther from the chord than the tolerance. Then no point of the
/// curve is, because it lies in the convex hull of its control points.
bool SvgOutline::is_flat(std::span<const WeightedPoint> placed, double tolerance) const {
  const auto point = [](const WeightedPoint& p) { return Point2{p.x / p.w, p.y / p.w}; };
  const Point2 a = point(placed.front()), b = point(placed.back());
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  return std::all_of(placed.begin(), placed.end(), [&](const WeightedPoint& each) {
    const Point2 p = point(each);
    const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
    const double t = square > 0 ? std::clamp(along / square, 0., 1.) : 0;
    return std::hypot(p.x - (a.x + t * dx), p.y - (a.y + t * dy)) <= tolerance;
  });
}

/// Adds chords for a placed curve, which is halved (de Casteljau) until all its parts are flat.
void SvgOutline::add_rational(const TextCursor& at, std::span<WeightedPoint> placed,
                              double tolerance, int depth) {
  constexpr int kMostHalvings = 48;  // After more halvings, parameters are equal as doubles.
  step();
  const WeightedPoint end = placed.back();
  if (depth == kMostHalvings || is_flat(placed, tolerance)) {
    return add(at, {end.x / end.w, end.y / end.w});
  }
  std::array<WeightedPoint, kMostDegree + 1> first{};
  const std::size_t n = placed.size();
  first[0] = placed[0];
  for (std::size_t r = 1; r < n; ++r) {
    for (std::size_t i = 0; i + r < n; ++i) {
      const WeightedPoint &a = placed[i], &b = placed[i + 1];
      placed[i] = {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.w + b.w) / 2};
    }
    first[r] = placed[0];
  }
  add_rational(at, std::span(first).first(n), tolerance, depth + 1);
  add_rational(at, placed, tolerance, depth + 1);
}

Point2 RecentDirections::at(double angle) {
  // Multiplication mixes the bits; the upper ones select the entry.
  constexpr std::uint64_t kMix = 0x9e3779b97f4a7c15;
  const std::uint64_t mixed_bits = std::bit_cast<std::uint64_t>(angle) * kMix;
  Entry& entry = entries_[mixed_bits >> (64 - std::countr_zero(kEntries))];
  if (entry.angle != angle) entry = {angle, direction_at(angle)};
  return entry.direction;
}

void SvgOutline::arc_to(const TextCursor& at, Point2 centre, Point2 u, Point2 v, double from,
                        double to, Point2 p) {
  const SvgTransform& t = transform_;
  const Point2 middle = placed(at, centre), end = placed(at, p);
  const Point2 pu{t.a * u.x + t.c * u.y, t.b * u.x + t.d * u.y};
  const Point2 pv{t.a * v.x + t.c * v.y, t.b * v.x + t.d * v.y};
  // Bounds the distance of any point of the ellipse from its centre.
  const double reach = std::hypot(std::hypot(pu.x, pu.y), std::hypot(pv.x, pv.y));
  const std::size_t n = chords(at, reach * (to - from) * (to - from));
  for (std::size_t i = 1; i < n; ++i) {
    const double angle = from + (to - from) * static_cast<double>(i) / static_cast<double>(n);
    const Point2 unit = directions_.at(angle);
    const Point2 off = mixed(pu, unit.x, pv, unit.y);
    add(at, {middle.x + off.x, middle.y + off.y});
  }
  add(at, end);
}

/// Ends a ring. A ring that returns to its first point lists it once.
void SvgOutline::close_ring() {
  auto& points = drawing_.points;
  const std::size_t begin = drawing_.ring_begin.back();
  while (points.size() > begin + 1 && points.back() == points[begin]) points.pop_back();
  if (points.size() == begin + 1) points.pop_back();  // A ring of one point is dropped.
  drawing_.places.resize(points.size());
  if (points.size() > begin) {
    drawing_.ring_begin.push_back(static_cast<std::uint32_t>(points.size()));
  }
}

void SvgOutline::end_shape(bool is_even_odd) {
  close_ring();
  const auto rings = static_cast<std::uint32_t>(drawing_.ring_count());
  if (rings == drawing_.shape_begin.back()) return;
  drawing_.shape_begin.push_back(rings);
  drawing_.is_even_odd.push_back(is_even_odd ? 1 : 0);
}

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
        command = command == 'M' ? 'L' : 'l';  // Further pairs of numbers are lines.
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
  /// Opens a subpath. After Z, it begins at the point where the previous subpath began.
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
  Point2 cubic_, quadratic_;  // The last control points, if the last command had any.
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

/// Adds an elliptic arc, converted from its ends to its centre as in SVG 1.1, appendix F.6.5. Radii
/// that do not reach are enlarged.
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
  // The coordinates are in units of the radii, along the radii.
  Point2 p{(axis.x * half.x + axis.y * half.y) / rx, (axis.x * half.y - axis.y * half.x) / ry};
  const double reach = std::hypot(p.x, p.y);
  if (!std::isfinite(reach)) {
    text_.fail(ErrorCode::NumberOutOfRange, "an arc beyond the largest double", place_);
  }
  if (reach == 0) return line(to);  // The arc is nearly straight.
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
  const double from = arc_tangent(p.y - c.y, p.x - c.x);
  double end = arc_tangent(-p.y - c.y, -p.x - c.x);
  // A large arc has at least a half turn, and any other arc has at most a half turn. With a margin
  // of a quarter turn, rounding cannot change an arc of a half turn to an empty arc or a full turn.
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
