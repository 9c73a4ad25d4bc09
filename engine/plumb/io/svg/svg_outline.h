// Outlines of drawings: lines and curves, moved by affine maps and flattened to closed polygons.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "plumb/base/context.h"
#include "plumb/io/svg/svg_syntax.h"
#include "plumb/io/svg_reader.h"
#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/point.h"

namespace plumb {

/// The map x' = a x + c y + e, y' = b x + d y + f: matrix(a b c d e f) of SVG.
struct SvgTransform {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
};
/// Returns the map that applies `second`, then `first`.
SvgTransform product(const SvgTransform& first, const SvgTransform& second);
/// Returns the image of a point.
Point2 applied(const SvgTransform& t, Point2 p);

/// Vectors of length 1 at angles. Circles of a drawing repeat the same angles, so the vectors of
/// recent angles are stored.
class RecentDirections {
 public:
  /// Returns direction_at(angle).
  Point2 at(double angle);

 private:
  static constexpr std::size_t kEntries = 512;  // A power of two.
  struct Entry {
    double angle = 0;
    Point2 direction{1, 0};
  };
  std::array<Entry, kEntries> entries_;
};

/// A control point of a rational curve, in homogeneous coordinates: it lies at (x / w, y / w), and
/// its weight w is above zero.
struct WeightedPoint {
  double x = 0, y = 0, w = 1;
};

/// Collects the shapes of a drawing. Coordinates come in the units of an element. Curves are
/// replaced by chords that are nowhere farther from them than the tolerance, measured in units of
/// the drawing.
///
/// All points together are at most 2^20 and one for every 7 bytes of the text: their lists take at
/// most 64 MB and ten times the text, doubling as they grow, however fine the tolerance and
/// whatever the text repeats.
///
/// Every function that adds points takes a cursor at the part of the text that it comes from.
/// Errors there: NumberOutOfRange beyond the largest double; BadShape for a curve without a
/// tolerance; ResourceLimit, also for too many points; Cancelled.
class SvgOutline {
 public:
  /// `text` is where places are counted from.
  SvgOutline(std::string_view text, std::optional<double> tolerance, Context& context)
      : text_(text.data()),
        tolerance_(tolerance),
        most_points_(most_points(text.size())),
        context_(context) {}

  void set_tolerance(double tolerance) { tolerance_ = tolerance; }
  void set_transform(const SvgTransform& transform) { transform_ = transform; }

  /// Ends the ring that is open, if any, and begins one.
  void move_to(const TextCursor& at, Point2 p);
  void line_to(const TextCursor& at, Point2 p);
  void cubic_to(const TextCursor& at, Point2 c1, Point2 c2, Point2 p);
  void quadratic_to(const TextCursor& at, Point2 c, Point2 p);
  /// Follows centre + cos t u + sin t v from t = from to t = to, where p is.
  void arc_to(const TextCursor& at, Point2 centre, Point2 u, Point2 v, double from, double to,
              Point2 p);
  /// Follows a rational Bezier curve from its first control point, where the outline is, to its
  /// last one. The degree is at most kMostDegree.
  void rational_to(const TextCursor& at, std::span<const WeightedPoint> control);
  static constexpr std::size_t kMostDegree = 25;
  void close_ring();
  /// Returns how many rings have ended.
  std::size_t ring_count() const { return drawing_.ring_count(); }
  /// Makes the rings since the last shape a shape, unless there are none.
  /// `is_even_odd` is the rule by which the shape is filled.
  void end_shape(bool is_even_odd = false);
  /// Counts one of many steps within a value; asks the context every few thousand steps.
  void step();

  SvgDrawing take() { return std::move(drawing_); }
  void note(std::string text) { drawing_.notes.push_back(std::move(text)); }

 private:
  static void require_finite(const TextCursor& at, Point2 p);
  Point2 placed(const TextCursor& at, Point2 p) const;
  void add(const TextCursor& at, Point2 placed);
  /// Returns how many chords keep within the tolerance, for a second derivative of at most `bend`
  /// over parameters 0 to 1.
  std::size_t chords(const TextCursor& at, double bend);
  double tolerance(const TextCursor& at) const;
  bool is_flat(std::span<const WeightedPoint> placed, double tolerance) const;
  void add_rational(const TextCursor& at, std::span<WeightedPoint> placed, double tolerance,
                    int depth);

  static std::size_t most_points(std::size_t bytes);

  const char* text_;
  std::optional<double> tolerance_;
  std::size_t most_points_;
  Context& context_;
  std::size_t steps_ = 0;
  SvgTransform transform_;
  SvgDrawing drawing_;
  RecentDirections directions_;
};

// The path data of SVG (attribute d): M L H V C S Q T A Z, absolute and relative.

/// Adds the subpaths as rings; each is closed, as it is when it is filled. Throws Error{Syntax},
/// Error{NumberOutOfRange} and the errors of the outline.
void read_svg_path(SvgValue& text, SvgOutline& outline);

/// Adds a whole ellipse.
void add_svg_ellipse(const TextCursor& at, Point2 centre, double rx, double ry,
                     SvgOutline& outline);

}  // namespace plumb
