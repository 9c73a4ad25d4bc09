// The cubic spline through points with chord lengths as parameters.
//
// The unknowns are the derivatives m at the points. The second derivative is continuous at point i
// with the chords h before it and g behind it if
//   g m[i-1] + 2 (h + g) m[i] + h m[i+1] = 3 (g s + h t),
// where s and t are the slopes of the two chords. At an open end the direction is given, or the
// curvature is 0, which is the same equation with one chord: 2 m[0] + m[1] = 3 t. Each diagonal
// entry is at least twice the sum of the others of its row, so each round of Gauss and Seidel
// halves the error at least, and a fixed number of rounds reaches the precision of doubles, for
// closed curves as for open ones. Source: C. de Boor, A Practical Guide to Splines, chapter IV.
// Tested by tests/io/dxf_test.cpp.
#include "plumb/io/plane/dxf_fit.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace plumb {
namespace {

constexpr int kRounds = 64;

class FitSolver {
 public:
  FitSolver(std::span<const Point2> points, const FitEnds& ends) : ends_(ends) {
    for (const Point2& p : points) {
      if (points_.empty() || points_.back() != p) points_.push_back(p);
    }
    if (ends.is_closed && points_.size() > 1 && points_.back() != points_.front()) {
      points_.push_back(points_.front());
    }
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      const double dx = points_[i + 1].x - points_[i].x, dy = points_[i + 1].y - points_[i].y;
      chords_.push_back(std::hypot(dx, dy));
      slopes_.push_back({dx / chords_.back(), dy / chords_.back()});
    }
    derivatives_.resize(points_.size());
  }

  FitCurve solve(Context& context) {
    if (chords_.empty()) return {};
    for (int round = 0; round < kRounds; ++round) {
      context.checkpoint("flatten", static_cast<std::uint64_t>(round), kRounds);
      for (std::size_t i = 0; i < points_.size(); ++i) update(i);
    }
    return curve();
  }

 private:
  std::size_t last() const { return points_.size() - 1; }

  void update(std::size_t i) {
    if (ends_.is_closed && i == last()) {
      derivatives_[i] = derivatives_[0];
    } else if (i == 0 && !ends_.is_closed) {
      derivatives_[i] = at_end(ends_.begin, slopes_.front(), derivatives_[1]);
    } else if (i == last()) {
      derivatives_[i] = at_end(ends_.end, slopes_.back(), derivatives_[i - 1]);
    } else {
      derivatives_[i] = between(i == 0 ? last() - 1 : i - 1, i);
    }
  }

  static Point2 at_end(const std::optional<Point2>& given, Point2 slope, Point2 next) {
    const double length = given ? std::hypot(given->x, given->y) : 0;
    if (length > 0) return {given->x / length, given->y / length};
    return {(3 * slope.x - next.x) / 2, (3 * slope.y - next.y) / 2};
  }

  /// Returns the derivative at the point where chord `before` ends and chord `after` begins.
  Point2 between(std::size_t before, std::size_t after) const {
    const double h = chords_[before], g = chords_[after];
    const Point2 s = slopes_[before], t = slopes_[after];
    const Point2 last = derivatives_[before], next = derivatives_[after + 1];
    const auto solved = [&](double s_, double t_, double last_, double next_) {
      return (3 * (g * s_ + h * t_) - g * last_ - h * next_) / (2 * (h + g));
    };
    return {solved(s.x, t.x, last.x, next.x), solved(s.y, t.y, last.y, next.y)};
  }

  FitCurve curve() const {
    FitCurve result{{points_.front()}, {0}};
    for (std::size_t i = 0; i < chords_.size(); ++i) {
      const Point2 a = points_[i], b = points_[i + 1], m = derivatives_[i], n = derivatives_[i + 1];
      const double third = chords_[i] / 3;
      result.control.push_back({a.x + third * m.x, a.y + third * m.y});
      result.control.push_back({b.x - third * n.x, b.y - third * n.y});
      result.control.push_back(b);
      result.begin.push_back(result.begin.back() + chords_[i]);
    }
    return result;
  }

  const FitEnds& ends_;
  std::vector<Point2> points_;
  std::vector<double> chords_;
  std::vector<Point2> slopes_;
  std::vector<Point2> derivatives_;
};

}  // namespace

FitCurve fit_curve(std::span<const Point2> points, const FitEnds& ends, Context& context) {
  return FitSolver(points, ends).solve(context);
}

}  // namespace plumb
