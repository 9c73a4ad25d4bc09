#include "plumb/io/svg_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "plumb/base/error.h"
#include "plumb/io/with_place.h"

namespace plumb {
namespace {

constexpr std::uint64_t kPointBytes = 2 * (sizeof(Point2) + sizeof(std::size_t));
constexpr std::uint64_t kRingBytes = 4 * sizeof(std::uint32_t);
constexpr std::size_t kPointsOfAnyText = std::size_t{1} << 20U;
constexpr std::size_t kBytesPerPoint = 7;                   // of the text, beyond those
constexpr std::size_t kMostPoints = std::size_t{1} << 30U;  // that a surface can hold
constexpr std::size_t kStepsPerCheckpoint = 4096;

Point2 mixed(Point2 a, double s, Point2 b, double t) {
  return {s * a.x + t * b.x, s * a.y + t * b.y};
}

/// Twice the turn that a curve makes at the middle one of three control points.
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
  if (++steps_ % kStepsPerCheckpoint == 0) context_.checkpoint("flatten", steps_, steps_);
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

/// A chord over parameters h apart is at most h^2 / 8 times the second derivative away from its curve.
std::size_t SvgOutline::chords(const TextCursor& at, double bend) {
  if (!tolerance_) {
    at.fail(ErrorCode::BadShape,
            "a curve in a drawing without viewBox, width and height: give a tolerance");
  }
  const double count = std::ceil(std::sqrt(bend / (8 * *tolerance_)));
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

void SvgOutline::arc_to(const TextCursor& at, Point2 centre, Point2 u, Point2 v, double from,
                        double to, Point2 p) {
  const SvgTransform& t = transform_;
  const Point2 middle = placed(at, centre), end = placed(at, p);
  const Point2 pu{t.a * u.x + t.c * u.y, t.b * u.x + t.d * u.y};
  const Point2 pv{t.a * v.x + t.c * v.y, t.b * v.x + t.d * v.y};
  // No point of the ellipse is further from its centre.
  const double reach = std::hypot(std::hypot(pu.x, pu.y), std::hypot(pv.x, pv.y));
  const std::size_t n = chords(at, reach * (to - from) * (to - from));
  for (std::size_t i = 1; i < n; ++i) {
    const double angle = from + (to - from) * static_cast<double>(i) / static_cast<double>(n);
    const Point2 off = mixed(pu, std::cos(angle), pv, std::sin(angle));
    add(at, {middle.x + off.x, middle.y + off.y});
  }
  add(at, end);
}

/// A ring that comes back to its first point needs it once.
void SvgOutline::close_ring() {
  auto& points = drawing_.points;
  const std::size_t begin = drawing_.ring_begin.back();
  while (points.size() > begin + 1 && points.back() == points[begin]) points.pop_back();
  if (points.size() == begin + 1) points.pop_back();  // nothing but a place
  drawing_.places.resize(points.size());
  if (points.size() > begin) {
    drawing_.ring_begin.push_back(static_cast<std::uint32_t>(points.size()));
  }
}

void SvgOutline::end_shape() {
  close_ring();
  const auto rings = static_cast<std::uint32_t>(drawing_.ring_count());
  if (rings > drawing_.shape_begin.back()) drawing_.shape_begin.push_back(rings);
}

}  // namespace plumb
