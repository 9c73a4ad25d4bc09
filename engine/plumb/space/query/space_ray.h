// Numbers known up to an error: what filters of constructed quantities compute with.
//
// eps = 2^-52, right in every rounding mode. kTiny pays for what flushing takes: an operand read as
// 0 changes by less than 2^-1022, a result flushed to 0 by as much; an operand's error is at least
// kTiny, so a product with a flushed operand is within |other| * error too. kUp pays for the
// roundings of the error itself. Infinities and NaNs end in no sign.
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

/// |value - mid| <= error.
struct Ball {
  static constexpr double kEps = 0x1p-52;
  static constexpr double kUp = 1 + 0x1p-48;
  static constexpr double kTiny = 0x1p-1020;

  double mid = 0;
  double error = 0;

  static Ball about(double value, double radius = 0) { return {value, radius * kUp + kTiny}; }
  static Ball unknown() { return {0, std::numeric_limits<double>::infinity()}; }

  FilteredSign sign() const {
    if (mid > error) return FilteredSign::Positive;
    return mid < -error ? FilteredSign::Negative : FilteredSign::Unsure;
  }
  double upper() const { return mid + error + kEps * (std::fabs(mid) + error); }

  friend Ball operator-(Ball a) { return {-a.mid, a.error}; }
  friend Ball operator+(Ball a, Ball b) { return rounded(a.mid + b.mid, a.error + b.error); }
  friend Ball operator-(Ball a, Ball b) { return rounded(a.mid - b.mid, a.error + b.error); }
  friend Ball operator*(Ball a, Ball b) {
    return rounded(a.mid * b.mid,
                   std::fabs(a.mid) * b.error + std::fabs(b.mid) * a.error + a.error * b.error);
  }
  /// |a/b - m| <= (ea + |m| eb) / (|b| - eb) for the quotient m of the centres.
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

// A ray among the items of a complex (internal to the locator).
//
// Notation
//   O         where the ray starts; k the axis along which it runs fastest; its direction has 1 or
//             -1 there and slope_i = d_i / d_k along the other two, i and j
//   distance  of a point x: (x - O)_k d_k, how far along the ray it is
//   shadow    of a point x: (x - O)_i - slope_i (x - O)_k, the same for j: what is seen of x by
//             someone who looks along the ray, which is itself the origin of the shadows
//
// The line of the ray meets a vertex where its shadow is the origin, an edge where its shadow
// passes the origin, and a facet that it does not run along where the boundary's shadow goes around
// the origin an odd number of times. Only signs are asked for, each of a filter first, then
// exactly. The shadows of a facet along the ray are on a line, and the same rules then find what
// the ray meets of its boundary.

/// A vertex, edge or facet that the line of a ray meets in one point.
struct SpaceRayHit {
  SpaceItem item;
  PlaneId plane;  ///< of a facet or edge: holds it, and the line crosses it
  Ball distance;
};

/// finite + infinite R: what grows with the frame (plane_table.h).
struct FramedNumber {
  Rational finite;
  Rational infinite;

  Sign sign() const { return infinite != 0 ? sign_of(infinite.sign()) : sign_of(finite.sign()); }
  friend FramedNumber operator-(const FramedNumber& a) { return {-a.finite, -a.infinite}; }
  friend FramedNumber operator-(const FramedNumber& a, const FramedNumber& b) {
    return {a.finite - b.finite, a.infinite - b.infinite};
  }
  friend FramedNumber operator*(const Rational& s, const FramedNumber& a) {
    return {s * a.finite, s * a.infinite};
  }
};

class SpaceRay {
 public:
  /// Along a coordinate axis. The origin must outlive the ray.
  SpaceRay(const SpaceComplex& complex, const QueryPoint3& origin, std::size_t axis,
           bool is_reverse);
  /// Requires a direction that is not zero.
  SpaceRay(const SpaceComplex& complex, const QueryPoint3& origin, const RationalPoint3& direction);

  // What the whole line meets, in front of the origin or not, is added to `hits`.
  void meet(FacetId f, std::vector<SpaceRayHit>& hits) const;
  void meet(EdgeId e, std::vector<SpaceRayHit>& hits) const;
  void meet(VertexId v, std::vector<SpaceRayHit>& hits) const;
  /// Does the line surely meet nothing of the facet? Tells of triangles between doubles, along an
  /// axis, in a few filters.
  bool passes_by(FacetId f) const;

  /// Positive: in front of the origin.
  Sign side(const SpaceRayHit& hit) const;
  /// The order along the ray.
  Sign compare(const SpaceRayHit& x, const SpaceRayHit& y) const;
  /// Requires an origin and a hit off the frame.
  RationalPoint3 point(const SpaceRayHit& hit) const;

  std::size_t axis() const { return k_; }
  bool is_reverse() const { return is_reverse_; }
  const QueryPoint3& origin() const { return origin_; }
  /// Along axes other than axis().
  Ball slope(std::size_t axis) const { return slope_[axis]; }
  bool is_axis_parallel() const { return is_axis_parallel_; }

 private:
  /// The signs of a shadow.
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
  SpacePoint point_of(VertexId v) const { return complex_.vertex_point[v.value()]; }

  Sign shadow_sign(VertexId v, std::size_t c) const;
  Sign turn(VertexId a, VertexId b) const;
  End end(VertexId v) const { return {v, {{shadow_sign(v, 0), shadow_sign(v, 1)}}}; }
  Passing passing(const End& a, const End& b) const;
  bool meet_cycle(UseId first, bool& is_inside, std::vector<SpaceRayHit>& hits) const;
  bool meet_edge(EdgeId e, const End& a, const End& b, std::vector<SpaceRayHit>& hits) const;

  SpaceRayHit hit_of(SpaceItem item, PlaneId plane) const;
  PlaneId crossing_plane(EdgeId e) const;
  Rational exact_slope(std::size_t axis) const {
    return exact_slope_ ? (*exact_slope_)[axis] : Rational();
  }

  // Number: Ball or FramedNumber.
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
  std::optional<std::array<Rational, 3>> exact_slope_;  ///< along an axis: none, all are 0
};

}  // namespace plumb
