// Points of the plane as an engine stores them: flat arrays of doubles, and an exact side table for
// the few that no double can hold (integers beyond 2^53, fractions). Predicates by index, and the
// crossing of two lines through such points, kept implicit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plumb/predicates/point.h"
#include "plumb/predicates/rational.h"
#include "plumb/predicates/sign.h"

namespace plumb {

/// An exact point for output.
struct RationalPoint2 {
  Rational x;
  Rational y;
  friend bool operator==(const RationalPoint2&, const RationalPoint2&) = default;
};

/// Read-only view of an exact point as integers X : Y : W, W > 0; the point is (X / W, Y / W).
/// Valid until the table grows.
struct HomogeneousView2 {
  mpz_t x;
  mpz_t y;
  mpz_t w;
};

/// Append-only table of exact points. approx(i) is the nearest double point (round to nearest
/// even); it *is* the point when is_double(i). Exact numbers lie in one limb pool: no allocation
/// per point. At most 2^32 - 2 points.
class PointTable2 {
 public:
  void reserve(std::size_t points);
  /// Requires finite coordinates. Negative zero is stored as zero.
  void push_back(Point2 p);
  /// Stored as doubles when both coordinates are exactly doubles. Coordinates that round to
  /// infinity are allowed: approx() then holds +-DBL_MAX.
  void push_back(const Rational& x, const Rational& y);

  std::size_t size() const { return points_.size(); }
  bool all_double() const { return slot_.empty(); }
  bool is_double(std::uint32_t i) const { return all_double() || slot_[i] == kNoSlot; }
  Point2 approx(std::uint32_t i) const { return points_[i]; }
  RationalPoint2 exact(std::uint32_t i) const;
  /// Requires !is_double(i).
  HomogeneousView2 homogeneous(std::uint32_t i) const;

 private:
  static constexpr std::uint32_t kNoSlot = 0xffffffff;
  /// Three integers, end to end in limbs_; the sign of a size is the sign of its integer (as in
  /// mpz).
  struct Entry {
    std::size_t begin;
    std::int32_t x_size;
    std::int32_t y_size;
    std::int32_t w_size;
  };
  std::int32_t append_limbs(mpz_srcptr value);

  std::vector<Point2> points_;
  std::vector<std::uint32_t> slot_;  ///< empty while all points are doubles, else one per point
  std::vector<Entry> entries_;
  std::vector<mp_limb_t> limbs_;
};

/// Lexicographic order (x, then y) of points i and j.
Sign compare_xy(const PointTable2& points, std::uint32_t i, std::uint32_t j);

/// Positive when i, j, k turn left (counter-clockwise), Zero when collinear.
Sign orient2d(const PointTable2& points, std::uint32_t i, std::uint32_t j, std::uint32_t k);

/// Sign of the cross product (b - a) x (d - c).
Sign cross_sign(const PointTable2& points, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                std::uint32_t d);

/// The point where the lines ab and cd meet, kept implicit: four point indices and a cached box.
/// Requires the lines not to be parallel.
struct Crossing2 {
  std::uint32_t a, b, c, d;
  double x, y;    ///< approximation
  double radius;  ///< |exact - approximation| <= radius in both coordinates; may be +inf
};

Crossing2 make_crossing(const PointTable2& points, std::uint32_t a, std::uint32_t b,
                        std::uint32_t c, std::uint32_t d);

/// Lexicographic order of constructed points.
Sign compare_xy(const PointTable2& points, const Crossing2& p, std::uint32_t i);
Sign compare_xy(const PointTable2& points, const Crossing2& p, const Crossing2& q);

/// Side of the line i -> j on which the crossing lies; Positive = left.
Sign orient2d(const PointTable2& points, std::uint32_t i, std::uint32_t j, const Crossing2& p);

/// The exact coordinates, for output.
RationalPoint2 exact(const PointTable2& points, const Crossing2& p);

}  // namespace plumb
