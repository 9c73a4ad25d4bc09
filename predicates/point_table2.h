// Points of the plane as an engine stores them: flat arrays of doubles, and an exact side table for
// the few that no double can hold (integers beyond 2^53, fractions). Predicates by index, and the
// crossing of two lines through such points, kept implicit.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/rung_counters.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Read-only view of an exact point as integers X : Y : W, W > 0; the point is (X / W, Y / W).
/// Valid until the table grows.
struct HomogeneousView2 {
  mpz_t x;  ///< X
  mpz_t y;  ///< Y
  mpz_t w;  ///< W
};

/// Append-only table of exact points. approx(i) is the nearest double point (round to nearest
/// even); it *is* the point when is_double(i). Exact numbers lie in one limb pool: no allocation
/// per point. At most 2^32 - 2 points.
class PointTable2 {
 public:
  void reserve(std::size_t points);  ///< Room for so many points.
  /// Requires finite coordinates. Negative zero is stored as zero.
  void push_back(Point2 p);
  /// Stored as doubles when both coordinates are exactly doubles. Coordinates that round to
  /// infinity are allowed: approx() then holds +-DBL_MAX.
  void push_back(const Rational& x, const Rational& y);
  /// Appends all points of `other`, in order. O(size of other).
  void append(const PointTable2& other);
  /// The points whose `keep` entry is not 0, in order. Requires one entry per point. O(n).
  PointTable2 subset(std::span<const std::uint8_t> keep) const;

  std::size_t size() const { return points_.size(); }  ///< Rows.
  bool all_double() const { return slot_.empty(); }    ///< Is every coordinate a double?
  /// Are both coordinates of the point doubles?
  bool is_double(std::uint32_t i) const { return all_double() || slot_[i] == kNoSlot; }
  Point2 approx(std::uint32_t i) const { return points_[i]; }  ///< The nearest doubles.
  RationalPoint2 exact(std::uint32_t i) const;                 ///< The coordinates as fractions.
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
  void append_entry(const PointTable2& other, std::uint32_t i);

  std::vector<Point2> points_;
  std::vector<std::uint32_t> slot_;  ///< empty while all points are doubles, else one per point
  std::vector<Entry> entries_;
  std::vector<mp_limb_t> limbs_;
};

/// Lexicographic order (x, then y) of points i and j. compare_xy(i, j) = -compare_xy(j, i);
/// transitive; Zero iff the points are equal.
Sign compare_xy(const PointTable2& points, std::uint32_t i, std::uint32_t j);

/// Positive when i, j, k turn left (counter-clockwise), Zero when collinear. Swapping two
/// arguments flips the sign, a cyclic shift keeps it.
Sign orient2d(const PointTable2& points, std::uint32_t i, std::uint32_t j, std::uint32_t k);

/// Sign of the cross product (b - a) x (d - c): Positive when d - c points left of b - a, Zero when
/// parallel or either is zero. cross_sign(a, b, a, c) = orient2d(a, b, c).
Sign cross_sign(const PointTable2& points, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                std::uint32_t d);

/// The point where the lines ab and cd meet, kept implicit: four point indices and a cached box.
/// Requires the lines not to be parallel.
struct Crossing2 {
  /// Index of a point.
  std::uint32_t a, b, c, d;  ///< index of a point
  double x, y;               ///< approximation
  double radius;             ///< |exact - approximation| <= radius in both coordinates; may be +inf
};

/// Never exact arithmetic: about 20 ns.
Crossing2 make_crossing(const PointTable2& points, std::uint32_t a, std::uint32_t b,
                        std::uint32_t c, std::uint32_t d);

/// Lexicographic order of a constructed point and point i, or of two constructed points: one order
/// with compare_xy(points, i, j), total on the points of both kinds.
Sign compare_xy(const PointTable2& points, const Crossing2& p, std::uint32_t i);
Sign compare_xy(const PointTable2& points, const Crossing2& p, const Crossing2& q);

/// Side of the line i -> j on which the crossing lies; Positive = left. Zero without arithmetic for
/// the two lines that define it, given by the same indices. Requires points i and j to differ.
Sign orient2d(const PointTable2& points, std::uint32_t i, std::uint32_t j, const Crossing2& p);

/// The exact coordinates, for output.
RationalPoint2 exact(const PointTable2& points, const Crossing2& p);

/// The rungs behind the predicates above, each callable on its own. Filters answer from the cached
/// doubles; Exact rungs compute in fixed-width integers and are Unsure for points that are not
/// doubles or whose exponents are spread too far; Big rungs always know.
namespace rung {

FilteredSign compare_xy_filter(const PointTable2& points, std::uint32_t i, std::uint32_t j);
FilteredSign orient2d_filter(const PointTable2& points, std::uint32_t i, std::uint32_t j,
                             std::uint32_t k);
FilteredSign cross_sign_filter(const PointTable2& points, std::uint32_t a, std::uint32_t b,
                               std::uint32_t c, std::uint32_t d);
FilteredSign compare_xy_filter(const PointTable2& points, const Crossing2& p, std::uint32_t i);
FilteredSign compare_xy_filter(const Crossing2& p, const Crossing2& q);
FilteredSign orient2d_filter(const PointTable2& points, std::uint32_t i, std::uint32_t j,
                             const Crossing2& p);

FilteredSign compare_xy_exact(const PointTable2& points, const Crossing2& p, std::uint32_t i);
FilteredSign compare_xy_exact(const PointTable2& points, const Crossing2& p, const Crossing2& q);
FilteredSign orient2d_exact(const PointTable2& points, std::uint32_t i, std::uint32_t j,
                            const Crossing2& p);

Sign compare_xy_big(const PointTable2& points, std::uint32_t i, std::uint32_t j);
Sign orient2d_big(const PointTable2& points, std::uint32_t i, std::uint32_t j, std::uint32_t k);
Sign cross_sign_big(const PointTable2& points, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                    std::uint32_t d);
Sign compare_xy_big(const PointTable2& points, const Crossing2& p, std::uint32_t i);
Sign compare_xy_big(const PointTable2& points, const Crossing2& p, const Crossing2& q);
Sign orient2d_big(const PointTable2& points, std::uint32_t i, std::uint32_t j, const Crossing2& p);

}  // namespace rung

namespace detail {

/// The ladders below the inlined filters.
Sign compare_xy_unsure(const PointTable2& points, std::uint32_t i, std::uint32_t j);
Sign orient2d_mixed(const PointTable2& points, std::uint32_t i, std::uint32_t j, std::uint32_t k);
Sign cross_sign_mixed(const PointTable2& points, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                      std::uint32_t d);
Sign compare_xy_unsure(const PointTable2& points, const Crossing2& p, std::uint32_t i);
Sign compare_xy_unsure(const PointTable2& points, const Crossing2& p, const Crossing2& q);

/// Sign of p - q when they are more than `radius` apart. Requires |p| < 2^303 or radius = +inf, and
/// radius >= 2^-300. The computed difference is off by a factor of 1 + 2^-52 in any rounding mode
/// and by 2^-1020 under FTZ/DAZ: the factor covers both, and the roundings of `radius`.
inline FilteredSign compare_apart(double p, double q, double radius) {
  const double difference = p - q;
  if (!(std::fabs(difference) > 1.0001 * radius)) return FilteredSign::Unsure;
  return difference > 0 ? FilteredSign::Positive : FilteredSign::Negative;
}

}  // namespace detail

/// Rounding to nearest and clamping are monotone, and so is flushing: approximations seen in strict
/// order prove the points in that order, of whatever kind they are.
inline FilteredSign rung::compare_xy_filter(const PointTable2& points, std::uint32_t i,
                                            std::uint32_t j) {
  const Point2 p = points.approx(i);
  const Point2 q = points.approx(j);
  if (p.x < q.x) return FilteredSign::Negative;
  if (p.x > q.x) return FilteredSign::Positive;
  return FilteredSign::Unsure;
}

inline Sign compare_xy(const PointTable2& points, std::uint32_t i, std::uint32_t j) {
  const FilteredSign f = rung::compare_xy_filter(points, i, j);
  if (!is_decided(f)) return detail::compare_xy_unsure(points, i, j);
  return decide(Predicate::ComparePoints2, Rung::Filter, f);
}

inline Sign orient2d(const PointTable2& points, std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  if (!points.all_double()) return detail::orient2d_mixed(points, i, j, k);
  return orient2d(points.approx(i), points.approx(j), points.approx(k));
}

inline Sign cross_sign(const PointTable2& points, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                       std::uint32_t d) {
  if (!points.all_double()) return detail::cross_sign_mixed(points, a, b, c, d);
  return cross_sign(points.approx(a), points.approx(b), points.approx(c), points.approx(d));
}

/// A coordinate that is no double is within 2^-53 of its size from its approximation, or is clamped
/// and then further out than any finite radius reaches.
inline FilteredSign rung::compare_xy_filter(const PointTable2& points, const Crossing2& p,
                                            std::uint32_t i) {
  const double x = points.approx(i).x;
  return plumb::detail::compare_apart(p.x, x, p.radius + 0x1p-52 * std::fabs(x));
}

inline FilteredSign rung::compare_xy_filter(const Crossing2& p, const Crossing2& q) {
  return plumb::detail::compare_apart(p.x, q.x, p.radius + q.radius);
}

inline Sign compare_xy(const PointTable2& points, const Crossing2& p, std::uint32_t i) {
  const FilteredSign f = rung::compare_xy_filter(points, p, i);
  if (!is_decided(f)) return detail::compare_xy_unsure(points, p, i);
  return decide(Predicate::CompareCrossings2, Rung::Filter, f);
}

inline Sign compare_xy(const PointTable2& points, const Crossing2& p, const Crossing2& q) {
  const FilteredSign f = rung::compare_xy_filter(p, q);
  if (!is_decided(f)) return detail::compare_xy_unsure(points, p, q);
  return decide(Predicate::CompareCrossings2, Rung::Filter, f);
}

}  // namespace plumb
#pragma GCC visibility pop
