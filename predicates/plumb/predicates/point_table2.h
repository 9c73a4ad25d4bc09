// The table in which the engine stores points of the plane. The table consists of flat arrays of
// doubles and of a second, exact table. The exact table stores the few points that doubles cannot
// represent, such as points with fractions or with integers beyond 2^53. Predicates take points as
// indices into the table. A Crossing2 represents the intersection of two lines through points of
// the table; its exact coordinates are not computed.
//
// Main flow of every predicate (each stage can be called on its own, in namespace rung):
//  1. Filter   decides from the cached doubles, or returns Unsure
//  2. Exact    computes in fixed-width integers; returns Unsure for points that are not doubles and
//              for coordinates whose exponents differ too much
//  3. Big      computes in GMP integers and always decides
// The page docs/design/numbers.md proves the error bounds.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/input_predicates.h"
#include "plumb/predicates/point.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Read-only view of an exact point (X / W, Y / W) as three integers X, Y and W > 0. The view is
/// valid until its table grows. The caller must not free these integers with mpz_clear.
struct HomogeneousView2 {
  mpz_t x;  ///< The integer X.
  mpz_t y;  ///< The integer Y.
  mpz_t w;  ///< The integer W > 0.
};

/// Append-only table of exact points. approx(i) is the nearest point with double coordinates (ties
/// to even). If is_double(i), approx(i) equals point i. For all other points, the table stores
/// integers. The limbs (machine words) of all these integers lie in one array, so that no point
/// needs a memory allocation of its own. A table stores at most 2^32 - 2 points.
class PointTable2 {
 public:
  /// Reserves memory for `points` points, including the points that are already in the table.
  void reserve(std::size_t points);
  /// Appends a point. Requires finite coordinates. Negative zero is stored as zero.
  void push_back(Point2 p);
  /// Appends a point. If doubles represent both coordinates exactly, the point is stored as
  /// doubles. A coordinate may be so large that its nearest double is infinite. In this case,
  /// approx() returns +-DBL_MAX for it.
  void push_back(const Rational& x, const Rational& y);
  /// Appends all points of `other` in their order. Requires that `other` is not this table. Cost:
  /// O(size of other).
  void append(const PointTable2& other);
  /// Returns a table of the points whose entry in `keep` is not 0. The order of the points is kept.
  /// Requires that `keep` has one entry for each point. Cost: O(n) for n points.
  PointTable2 subset(std::span<const std::uint8_t> keep) const;

  std::size_t size() const { return points_.size(); }  ///< Returns the number of points.
  bool all_double() const { return slot_.empty(); }    ///< Whether every coordinate is a double.
  /// Whether both coordinates of point i are doubles.
  bool is_double(std::uint32_t i) const { return all_double() || slot_[i] == kNoSlot; }
  Point2 approx(std::uint32_t i) const { return points_[i]; }  ///< Returns the nearest doubles.
  RationalPoint2 exact(std::uint32_t i) const;                 ///< Returns the exact coordinates.
  /// Returns the exact homogeneous coordinates. Requires !is_double(i).
  HomogeneousView2 homogeneous(std::uint32_t i) const;

  /// Returns the size of the stored points in bytes, without unused capacity.
  std::size_t bytes() const {
    return points_.size() * sizeof(Point2) + slot_.size() * sizeof(std::uint32_t) +
           entries_.size() * sizeof(Entry) + limbs_.size() * sizeof(mp_limb_t);
  }

 private:
  static constexpr std::uint32_t kNoSlot = 0xffffffff;
  /// The three integers of a point. The integers lie one after another in limbs_, from index
  /// `begin` on. The sign of each size is the sign of the integer, as in mpz_t.
  struct Entry {
    std::size_t begin;
    std::int32_t x_size;
    std::int32_t y_size;
    std::int32_t w_size;
  };
  std::int32_t append_limbs(mpz_srcptr value);
  void append_entry(const PointTable2& other, std::uint32_t i);

  std::vector<Point2> points_;
  /// For each point, its index into entries_, or kNoSlot. This array is empty while all points are
  /// doubles.
  std::vector<std::uint32_t> slot_;
  std::vector<Entry> entries_;
  std::vector<mp_limb_t> limbs_;
};

/// Compares points i and j lexicographically (x, then y). The result is Zero if and only if the
/// points are equal. The order is transitive, and swapping i and j flips the sign.
Sign compare_xy(const PointTable2& points, std::uint32_t i, std::uint32_t j);

/// Returns the orientation of three points. The orientation is Positive if i, j, k make a left turn
/// (are in counter-clockwise order), and Zero if they are collinear. Swapping two points flips the
/// sign; a cyclic shift of the points does not change the sign.
Sign orient2d(const PointTable2& points, std::uint32_t i, std::uint32_t j, std::uint32_t k);

/// Returns the sign of the cross product (b - a) x (d - c). The sign is Positive if the vector d -
/// c points to the left of the vector b - a. The sign is Zero if the vectors are parallel or one of
/// the vectors is zero. cross_sign(a, b, a, c) equals orient2d(a, b, c).
Sign cross_sign(const PointTable2& points, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                std::uint32_t d);

/// The intersection of the lines ab and cd. The intersection is represented by four point indices
/// and a cached box around the intersection. Requires that the lines are not parallel.
struct Crossing2 {
  std::uint32_t a, b, c, d;  ///< Indices of the points that define the two lines.
  double x, y;               ///< Approximate coordinates.
  double radius;             ///< Bound for the errors of x and of y; may be +inf.
};

/// Returns the intersection of the lines ab and cd. Requires that the lines are not parallel. The
/// function uses no exact arithmetic. If doubles give no bound for the error, the function sets the
/// radius to +inf. Cost: about 20 ns.
Crossing2 make_crossing(const PointTable2& points, std::uint32_t a, std::uint32_t b,
                        std::uint32_t c, std::uint32_t d);

/// Compares a crossing with point i, or compares two crossings. The order is lexicographic (x, then
/// y). Together with compare_xy(points, i, j), these functions define one total order of all points
/// and crossings.
Sign compare_xy(const PointTable2& points, const Crossing2& p, std::uint32_t i);
Sign compare_xy(const PointTable2& points, const Crossing2& p, const Crossing2& q);

/// Returns the side of the directed line from i to j on which the crossing lies: Positive if the
/// crossing lies to the left. If i and j are the two points of a line that defines the crossing,
/// the result is Zero without arithmetic. Requires that points i and j differ.
Sign orient2d(const PointTable2& points, std::uint32_t i, std::uint32_t j, const Crossing2& p);

/// Returns the exact coordinates of a crossing, for output.
RationalPoint2 exact(const PointTable2& points, const Crossing2& p);

/// The stages of the predicates above. Each stage can be called on its own.
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

// The stages that follow the inlined filters.
Sign compare_xy_unsure(const PointTable2& points, std::uint32_t i, std::uint32_t j);
Sign orient2d_mixed(const PointTable2& points, std::uint32_t i, std::uint32_t j, std::uint32_t k);
Sign cross_sign_mixed(const PointTable2& points, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                      std::uint32_t d);
Sign compare_xy_unsure(const PointTable2& points, const Crossing2& p, std::uint32_t i);
Sign compare_xy_unsure(const PointTable2& points, const Crossing2& p, const Crossing2& q);

/// Returns the sign of p - q if |p - q| is greater than `radius` (with a small safety margin).
/// Otherwise returns Unsure. Requires radius >= 2^-300. Also requires |p| < 2^303 or radius = +inf.
/// In any rounding mode, the relative error of the computed difference is at most 2^-52.
/// Flush-to-zero or denormals-are-zero may add an error of at most 2^-1020. Therefore the
/// difference is compared with 1.0001 `radius`. The factor covers the relative error, the error of
/// flushing, and the rounding of the product.
inline FilteredSign compare_apart(double p, double q, double radius) {
  const double difference = p - q;
  if (!(std::fabs(difference) > 1.0001 * radius)) return FilteredSign::Unsure;
  return difference > 0 ? FilteredSign::Positive : FilteredSign::Negative;
}

}  // namespace detail

/// Compares the approximate x-coordinates. The approximations result from rounding to nearest,
/// clamping and flushing, which are monotone. Therefore, if one approximation is strictly less than
/// the other, the exact coordinates have the same order.
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

/// Compares only the x-coordinates. If the x-coordinate of point i is not a double, the relative
/// error of its approximation is at most 2^-53. The only exception is a coordinate that was clamped
/// to +-DBL_MAX. Such a coordinate is so large that no box with a finite radius contains it.
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
