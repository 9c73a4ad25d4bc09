// A ray among the cells of a complex (internal to the locator), and numbers known up to an error,
// with which its filters compute.
//
// Ball: a number known up to an error. kEps = 2^-52 bounds a rounding in every rounding mode. kTiny
// covers what flushing takes: an operand read as 0 changes by less than 2^-1022, a result flushed
// to 0 by as much; an operand's error is at least kTiny, so a product with a flushed operand is
// within |other| * error too. kUp covers the roundings of the error itself. Infinities and NaNs
// give no sign.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "plumb/predicates/sign.h"
#include "plumb/predicates/space/query_point3.h"
#include "plumb/space/space_complex.h"

namespace plumb {

/// A number with |number - mid| <= error.
struct Ball {
  static constexpr double kEps = 0x1p-52;     ///< More than a rounding, relative to the value.
  static constexpr double kUp = 1 + 0x1p-48;  ///< More than the roundings of an error.
  static constexpr double kTiny = 0x1p-1020;  ///< More than flushing takes.

  double mid = 0;    ///< A double near the number.
  double error = 0;  ///< A bound for its distance from the number.

  /// Returns a ball around a double with this radius.
  static Ball about(double value, double radius = 0) { return {value, radius * kUp + kTiny}; }
  /// Returns the ball of all numbers.
  static Ball unknown() { return {0, std::numeric_limits<double>::infinity()}; }

  /// Returns the sign of the number if it is sure.
  FilteredSign sign() const {
    if (mid > error) return FilteredSign::Positive;
    return mid < -error ? FilteredSign::Negative : FilteredSign::Unsure;
  }
  /// Returns an upper bound of the number.
  double upper() const { return mid + error + kEps * (std::fabs(mid) + error); }

  friend Ball operator-(Ball a) { return {-a.mid, a.error}; }
  friend Ball operator+(Ball a, Ball b) { return rounded(a.mid + b.mid, a.error + b.error); }
  friend Ball operator-(Ball a, Ball b) { return rounded(a.mid - b.mid, a.error + b.error); }
  friend Ball operator*(Ball a, Ball b) {
    return rounded(a.mid * b.mid,
                   std::fabs(a.mid) * b.error + std::fabs(b.mid) * a.error + a.error * b.error);
  }
  /// Returns the quotient; unknown unless b is surely away from 0. |a/b - m| <= (ea + |m| eb) /
  /// (|b| - eb) for the quotient m of the middles, and |b| - eb >= |b| / 2.
  friend Ball operator/(Ball a, Ball b) {
    if (!(b.error <= std::fabs(b.mid) / 2)) return unknown();
    const double m = a.mid / b.mid;
    return rounded(m, 2 * (a.error + std::fabs(m) * b.error) / std::fabs(b.mid));
  }

 private:
  static Ball rounded(double mid, double error) {
    return {mid, (error + kEps * std::fabs(mid) + kTiny) * kUp};
  }
};

// The ray.
//
// Notation
//   O         where the ray starts; k the axis along which it runs fastest; its direction has 1 or
//             -1 there and slope_i = d_i / d_k along the other two, i and j
//   distance  of a point x: (x - O)_k d_k, how far along the ray it is
//   shadow    of a point x: (x - O)_i - slope_i (x - O)_k, the same for j: what is seen of x in the
//             direction of the ray, which is itself the origin of the shadows
//
// The line of the ray meets a vertex where its shadow is the origin, an edge where its shadow
// passes the origin, and a facet that it does not run along where the boundary's shadow goes around
// the origin an odd number of times. Only signs are computed, each by a filter first, then exactly.
// The shadows of a facet along the ray are on a line, and the same rules then find what the ray
// meets of its boundary.

/// A vertex, edge or facet that the line of a ray meets in one point.
struct SpaceRayHit {
  SpaceItem item;  ///< The cell.
  PlaneId plane;   ///< A plane that holds the facet or edge and that the line crosses.
  Ball distance;   ///< The distance along the ray; negative behind the origin.
};

/// The number finite + infinite R: what grows with the frame (plane_table.h).
struct FramedNumber {
  Rational finite;    ///< The part without R.
  Rational infinite;  ///< The factor of R.

  /// Returns the sign for all large R.
  Sign sign() const { return infinite != 0 ? sign_of(infinite.sign()) : sign_of(finite.sign()); }
  friend FramedNumber operator-(const FramedNumber& a) { return {-a.finite, -a.infinite}; }
  friend FramedNumber operator-(const FramedNumber& a, const FramedNumber& b) {
    return {a.finite - b.finite, a.infinite - b.infinite};
  }
  friend FramedNumber operator*(const Rational& s, const FramedNumber& a) {
    return {s * a.finite, s * a.infinite};
  }
};

/// A ray from a point, with exact predicates about what it meets. Immutable.
class SpaceRay {
 public:
  /// Makes a ray along a coordinate axis, or against it if is_reverse. Keeps references to the
  /// complex and the origin.
  SpaceRay(const SpaceComplex& complex, const QueryPoint3& origin, std::size_t axis,
           bool is_reverse);
  /// Makes a ray in any direction, which must not be zero.
  SpaceRay(const SpaceComplex& complex, const QueryPoint3& origin, const RationalPoint3& direction);

  // These append to `hits` what the whole line meets, in front of the origin or not. A facet
  // appends itself if the line crosses it inside, else what the line meets of its boundary.
  void add_hits(FacetId f, std::vector<SpaceRayHit>& hits) const;
  void add_hits(EdgeId e, std::vector<SpaceRayHit>& hits) const;
  void add_hits(VertexId v, std::vector<SpaceRayHit>& hits) const;
  /// Whether the line surely meets nothing of the facet. Decides only for triangles of doubles and
  /// rays along an axis, by a few filters.
  bool passes_by(FacetId f) const;

  /// Returns Positive if the hit is in front of the origin, Zero at the origin.
  Sign side(const SpaceRayHit& hit) const;
  /// Returns the order of two hits along the ray.
  Sign compare(const SpaceRayHit& x, const SpaceRayHit& y) const;
  /// Returns the exact point of a hit. Requires an origin and a hit off the frame.
  RationalPoint3 point(const SpaceRayHit& hit) const;

  /// Returns the axis along which the ray runs fastest.
  std::size_t axis() const { return k_; }
  /// Whether it runs against that axis.
  bool is_reverse() const { return is_reverse_; }
  /// Returns where the ray starts.
  const QueryPoint3& origin() const { return origin_; }
  /// Returns the slope along an axis other than axis().
  Ball slope(std::size_t axis) const { return slope_[axis]; }
  /// Whether the ray is parallel to axis().
  bool is_axis_parallel() const { return is_axis_parallel_; }

 private:
  /// The signs of a shadow's coordinates.
  struct Place {
    std::array<Sign, 2> at;
    bool is_origin() const { return at[0] == Sign::Zero && at[1] == Sign::Zero; }
  };
  struct End {
    VertexId vertex;
    Place place;
  };
  enum class Passing { Aside, OnRight, Through };

  std::size_t side_axis(std::size_t c) const { return (k_ + 1 + c) % 3; }
  SpacePoint point_of(VertexId v) const { return complex_.vertex_point[v]; }

  Sign shadow_sign(VertexId v, std::size_t c) const;
  Sign turn(VertexId a, VertexId b) const;
  End end(VertexId v) const { return {v, {{shadow_sign(v, 0), shadow_sign(v, 1)}}}; }
  Passing passing(const End& a, const End& b) const;
  bool runs_along(PlaneId plane, IntegerRow& row) const;
  void add_hits_in_plane(FacetId f, const IntegerRow& row, std::vector<SpaceRayHit>& hits) const;
  bool add_hits_of_cycle(UseId first, bool& is_inside, std::vector<SpaceRayHit>& hits) const;
  bool add_hit_inside_edge(EdgeId e, const End& a, const End& b,
                           std::vector<SpaceRayHit>& hits) const;

  SpaceRayHit hit_of(SpaceItem item, PlaneId plane) const;
  PlaneId crossing_plane(EdgeId e) const;
  Rational exact_slope(std::size_t axis) const {
    return exact_slope_ ? (*exact_slope_)[axis] : Rational();
  }

  // These compute with Ball (filter) or FramedNumber (exactly).
  template <class Number>
  Number offset(VertexId v, std::size_t axis) const;
  template <class Number>
  Number shadow(VertexId v, std::size_t c) const;
  template <class Number>
  Number distance(const SpaceRayHit& hit) const;
  template <class Number>
  Number plane_distance(PlaneId plane) const;
  Ball rough_climb(PlaneId plane) const;
  Rational climb(PlaneId plane) const;

  const SpaceComplex& complex_;
  const QueryPoint3& origin_;
  std::size_t k_;
  bool is_reverse_;
  bool is_axis_parallel_;
  std::array<Ball, 3> slope_;
  std::optional<std::array<Rational, 3>> exact_slope_;  ///< Empty along an axis, where all are 0.
};

}  // namespace plumb
