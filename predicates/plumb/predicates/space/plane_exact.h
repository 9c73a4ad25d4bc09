// Computes the exact coefficients of planes, and determinants of these coefficients. All numbers
// are integers of a fixed width or GMP integers. The result of every predicate on planes is the
// sign of such a determinant.
//
// Notation: a plane is written as n.x + d 2^scale = 0. Here n is a vector of three integers, and d
// is an integer. If n and d are multiplied by a common positive factor, the plane stays the same.
// Let p, q, r be input points on the grid of unit 2^g. Then p = P 2^g, q = Q 2^g and r = R 2^g with
// integer vectors P, Q and R. The plane through p, q, r has n = (Q - P) x (R - P), d = -n.P and
// scale = g.
//
// Bits (docs/design/numbers.md, Planes). If |P| < 2^b for all three points, then |Q - P| < 2^(b+1),
// |n| < 2^(2b+3), |d| <= 3 |n| |P| < 2^(3b+5). A width W has C limbs (64-bit words) for each
// coordinate, N limbs for each component of a normal, and D limbs for each offset. The function
// load() guarantees the bound
//
//   (L)  |n| <= 2^(64N-3)  and  |d| <= 2^(64D-2)
//
// With this bound, no computation below overflows, as the following table shows. In the table, M =
// 64N and O = 64D:
//   minor  n x m                       2 2^(2M-6)                    = 2^(2M-5)  < 2^(2M-1)
//   det3   (n x m).k                   3 2^(2M-5) 2^(M-3)            < 2^(3M-6)  < 2^(3M-1)
//   x      sum of 3 d (n x m)          3 2^(O-2) 2^(2M-5)            < 2^(O+2M-5) < 2^(O+2M-1)
//   det4   sum of 4 d det3             4 2^(O-2) 2^(3M-6)            = 2^(O+3M-6) < 2^(O+3M-1)
//          x.n + d det3                3 2^(O+3M-8) + 2^(O+3M-8)     = 2^(O+3M-6)
// The inequalities 2b+3 <= 64N-3 and 3b+5 <= 64D-2 give a limit for b. The limit is 29 for N,D =
// 1,2. It is 61 for N,D = 2,3, and 125 for N,D = 4,6.
//
// Parts (docs/design/frame.md, Lemma 2). The offset of a plane of the frame (plane_table.h) is d R,
// and the stored offset is d. Each of the following expressions is linear in the offsets:
//   det4                  has one offset in each of its terms
//   common point          x = P0 + P1 R, because each component is a sum of d (n x m); w contains
//                         no offset
//   side of x on s        n.(P0 + P1 R) + (d0 + d1 R) w
//   x / w against y / v   (P0 + P1 R) v - (Q0 + Q1 R) w, times the signs of w and v
// So every expression has a value c0 + c1 R. To compute the Infinite part c1, the offsets of planes
// that do not belong to the frame are replaced by 0. To compute the Finite part c0, the offsets of
// planes of the frame are replaced by 0. R is larger than every number. Therefore the expression
// has the sign of c1 if c1 is not 0, and otherwise the sign of c0. If none of the planes belongs to
// the frame, c1 is 0 and is not computed.
#pragma once

#include <array>
#include <climits>
#include <cstddef>

#include "plumb/predicates/arithmetic/double_bits.h"
#include "plumb/predicates/arithmetic/scaled.h"
#include "plumb/predicates/space/plane_table.h"

#pragma GCC visibility push(default)
namespace plumb::exact3 {

/// The widths of the exact stages. kCoordinate, kNormal and kOffset are the numbers of limbs C, N
/// and D. kMaxBits is the limit for b.
struct Narrow {
  static constexpr int kCoordinate = 1, kNormal = 1, kOffset = 2, kMaxBits = 29, kIndex = 0;
};
struct Medium {
  static constexpr int kCoordinate = 1, kNormal = 2, kOffset = 3, kMaxBits = 61, kIndex = 1;
};
struct Wide {
  static constexpr int kCoordinate = 2, kNormal = 4, kOffset = 6, kMaxBits = 125, kIndex = 2;
};

template <class W>
using Coordinate = Fixed<W::kCoordinate>;
template <class W>
using Normal = Fixed<W::kNormal>;
template <class W>
using Offset = Fixed<W::kOffset>;
template <class W>
using Minor = Fixed<2 * W::kNormal>;
template <class W>
using Det3 = Fixed<3 * W::kNormal>;
template <class W>
using Numerator = Fixed<W::kOffset + 2 * W::kNormal>;
template <class W>
using Det4 = Fixed<W::kOffset + 3 * W::kNormal>;

template <class Number>
using Vector = std::array<Number, 3>;

/// The value of `scale` for a plane through the origin. The offset d of such a plane is 0, so the
/// factor 2^scale does not matter. This value is the largest integer, so such a plane does not
/// affect the minimum of the scales of several planes (see align()).
inline constexpr int kAnyScale = INT_MAX;

/// The plane n.x + d 2^scale = 0 in integers of the width W.
template <class W>
struct FixedPlane {
  Vector<Normal<W>> n;
  Offset<W> d;
  int scale = kAnyScale;
};

/// The plane n.x + d 2^scale = 0 in integers of any length.
struct BigPlane {
  Vector<Integer> n;
  Integer d;
  int scale = kAnyScale;
};

/// The plane n.x + d 2^scale = 0 in integers of a width that holds the image of every FixedPlane
/// under an affine map with numbers of up to 254 bits.
struct LongPlane {
  static constexpr int kLimbs = 12;
  using Number = Fixed<kLimbs>;
  Vector<Number> n;
  Number d;
  int scale = kAnyScale;
};

/// A plane whose exact coefficients are not computed yet; load() computes them.
struct Operand {
  const PlaneTable* table;  ///< The table that contains the plane.
  PlaneSource source;       ///< The definition of the plane.
  Grid grid;                ///< The grid of the input points that define the plane.
  /// The least sufficient width: 0 means Narrow, 1 Medium, 2 Wide, and 3 any length.
  int width;
};

/// Returns the Operand for a plane, without computing its coefficients.
Operand operand(const PlaneTable& table, const PlaneSource& source);
inline Operand operand(const PlaneTable& table, PlaneId plane) {
  return operand(table, table.source(plane));
}

/// Returns the side of `plane` on which the input point x lies, or Unsure. The function decides
/// only for planes that are orthogonal to a coordinate axis. The three points that define such a
/// plane have the same coordinate along this axis. The function compares this coordinate with the
/// coordinate of x. For all other planes, the function returns Unsure. Requires that `plane` is
/// defined by three input points.
FilteredSign side_across(const PlaneTable& table, InputPointId x, const PlaneSource& plane);

/// Returns the side of `plane` on which the input point x lies. Requires that `plane` is defined by
/// three input points. The function computes the side by orient3d from these three points and x.
/// Returns Unsure if the points have too many bits for fixed widths.
FilteredSign side_by_corners(const PlaneTable& table, InputPointId x, const PlaneSource& plane);

/// The parts of a number c0 + c1 R: Finite is c0, Infinite is c1.
enum class Part { Finite, Infinite };

/// Prepares `plane` for the computation of one part of a number c0 + c1 R. The offset of a plane of
/// the frame is a multiple of R, and belongs to Part::Infinite. Every other offset contains no R,
/// and belongs to Part::Finite. If the offset does not belong to `part`, the function sets it to 0.
template <class Plane>
void take_part(const Operand& operand, Part part, Plane& plane) {
  if (operand.source.is_frame() == (part == Part::Infinite)) return;
  plane.d = decltype(plane.d)(0);
  plane.scale = kAnyScale;
}

/// Returns the sign of c0 + c1 R, where R stands for the half-width of the frame, which is larger
/// than every number. The caller passes the function `question`: question(part) returns the sign of
/// one part as a FilteredSign. If `has_frame` is false, c1 is 0 and its sign is not computed.
template <class Question>
FilteredSign by_parts(bool has_frame, const Question& question) {
  if (has_frame) {
    const FilteredSign s = question(Part::Infinite);
    if (s != FilteredSign::Zero) return s;
  }
  return question(Part::Finite);
}

/// Returns the exact coefficients. For a plane of the frame, whose offset is d R, the returned
/// offset is d. All widths give the same numbers. Requires operand.width <= W::kIndex.
template <class W>
FixedPlane<W> load(const Operand& operand);
/// Returns the exact coefficients in integers of any length.
BigPlane load_big(const Operand& operand);

extern template FixedPlane<Narrow> load(const Operand&);
extern template FixedPlane<Medium> load(const Operand&);
extern template FixedPlane<Wide> load(const Operand&);

// --- products, with the same names for integers of fixed width and GMP integers
// ------------------------------

template <class To, int A, int B>
To product(const Fixed<A>& x, const Fixed<B>& y) {
  return multiply_to<To::kLimbs>(x, y);
}
template <class To>
Integer product(const Integer& x, const Integer& y) {
  return x * y;
}

template <class To, class Number>
To cross_component(const Vector<Number>& a, const Vector<Number>& b, std::size_t i) {
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  return product<To>(a[j], b[k]) - product<To>(a[k], b[j]);
}

template <class To>
Integer cross_component(const Vector<Integer>& a, const Vector<Integer>& b, std::size_t i) {
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  Integer result = a[j] * b[k];
  result.subtract_product(a[k], b[j]);
  return result;
}

template <class To, class Number>
Vector<To> cross(const Vector<Number>& a, const Vector<Number>& b) {
  return {cross_component<To>(a, b, 0), cross_component<To>(a, b, 1), cross_component<To>(a, b, 2)};
}

template <class To, class A, class B>
To dot(const Vector<A>& a, const Vector<B>& b) {
  To sum = product<To>(a[0], b[0]);
  sum += product<To>(a[1], b[1]);
  sum += product<To>(a[2], b[2]);
  return sum;
}

template <class To>
Integer dot(const Vector<Integer>& a, const Vector<Integer>& b) {
  Integer sum = a[0] * b[0];
  sum.add_product(a[1], b[1]).add_product(a[2], b[2]);
  return sum;
}

// --- shifts --------------------------------------------------------------------------------------

/// Shifts `value` to the left by `shift` bits and returns true. If |value| would then have more
/// than `max_bits` bits, the function returns false instead. Requires shift >= 0.
template <int L>
bool shift_within(Fixed<L>& value, int shift, int max_bits) {
  if (shift == 0 || value.is_zero()) return true;
  if (shift > max_bits || bit_length(value) + shift > max_bits) return false;
  value = value << shift;
  return true;
}
inline bool shift_within(Integer& value, int shift, int) {
  value <<= static_cast<unsigned>(shift);
  return true;
}

inline Sign sign_of(const Integer& x) { return static_cast<Sign>(x.sign()); }
template <int L>
Sign sign_of(const Fixed<L>& x) {
  return x.sign();
}

/// Returns the largest number of bits that the bound (L) allows for an offset.
template <class W>
constexpr int offset_bits(const FixedPlane<W>&) {
  return 64 * W::kOffset - 2;
}
inline int offset_bits(const BigPlane&) { return INT_MAX; }

/// Converts all planes to a common scale, which is the least of their scales. Returns false if an
/// offset then violates the bound (L).
template <class Plane, std::size_t K>
bool align(std::array<Plane, K>& planes) {
  int scale = kAnyScale;
  for (const Plane& p : planes) scale = p.scale < scale ? p.scale : scale;
  for (Plane& p : planes) {
    if (p.scale == kAnyScale) continue;
    if (!shift_within(p.d, p.scale - scale, offset_bits(p))) return false;
    p.scale = scale;
  }
  return true;
}

// --- determinants --------------------------------------------------------------------------------

/// The types of the numbers that the functions below compute, for each type of plane.
template <class Plane>
struct Types;
template <class W>
struct Types<FixedPlane<W>> {
  using Minor = exact3::Minor<W>;
  using Det3 = exact3::Det3<W>;
  using Numerator = exact3::Numerator<W>;
  using Det4 = exact3::Det4<W>;
};
template <>
struct Types<BigPlane> {
  using Minor = Integer;
  using Det3 = Integer;
  using Numerator = Integer;
  using Det4 = Integer;
};

/// Returns the sign of the determinant of three normals.
template <class Plane>
Sign det3_sign(const Plane& p, const Plane& q, const Plane& r) {
  using T = Types<Plane>;
  const Vector<typename T::Minor> pq = cross<typename T::Minor>(p.n, q.n);
  return sign_of(dot<typename T::Det3>(pq, r.n));
}

/// Returns the sign of a component of n_p x n_q.
template <class Plane>
Sign minor_sign(const Plane& p, const Plane& q, std::size_t axis) {
  return sign_of(cross_component<typename Types<Plane>::Minor>(p.n, q.n, axis));
}

/// Two determinants for four planes: det4 is the determinant of their rows (n, d), and det3 the
/// determinant of the normals of the first three planes.
template <class Plane>
struct Determinants {
  typename Types<Plane>::Det4 det4;
  typename Types<Plane>::Det3 det3;
};

/// Returns both determinants. det4 is expanded along the column of offsets. The expansion has four
/// determinants of three normals each, and these determinants share two cross products. Another
/// method would be to compute the common point of p, q and r, and to insert it into the equation of
/// s. The expansion takes a sixth fewer products of words than this method. Requires aligned
/// planes.
template <class Plane>
Determinants<Plane> expand(const Plane& p, const Plane& q, const Plane& r, const Plane& s) {
  using T = Types<Plane>;
  const auto pq = cross<typename T::Minor>(p.n, q.n), rs = cross<typename T::Minor>(r.n, s.n);
  const typename T::Det3 pqr = dot<typename T::Det3>(pq, r.n);
  typename T::Det4 sum = product<typename T::Det4>(s.d, pqr);
  sum -= product<typename T::Det4>(r.d, dot<typename T::Det3>(pq, s.n));
  sum += product<typename T::Det4>(q.d, dot<typename T::Det3>(rs, p.n));
  sum -= product<typename T::Det4>(p.d, dot<typename T::Det3>(rs, q.n));
  return {sum, pqr};
}

/// Returns expand(p, q, r, s). This function is compiled only once, in plane_exact.cpp. The
/// compiler inlines products there if this is faster.
template <class Plane>
Determinants<Plane> determinants(const Plane& p, const Plane& q, const Plane& r, const Plane& s);
template <>
Determinants<FixedPlane<Narrow>> determinants(const FixedPlane<Narrow>&, const FixedPlane<Narrow>&,
                                              const FixedPlane<Narrow>&, const FixedPlane<Narrow>&);
template <>
Determinants<FixedPlane<Medium>> determinants(const FixedPlane<Medium>&, const FixedPlane<Medium>&,
                                              const FixedPlane<Medium>&, const FixedPlane<Medium>&);
template <>
Determinants<FixedPlane<Wide>> determinants(const FixedPlane<Wide>&, const FixedPlane<Wide>&,
                                            const FixedPlane<Wide>&, const FixedPlane<Wide>&);
template <>
Determinants<BigPlane> determinants(const BigPlane&, const BigPlane&, const BigPlane&,
                                    const BigPlane&);

/// The point x 2^scale / w. Let p, q, r be planes with the normals n_p, n_q, n_r and the offsets
/// d_p, d_q, d_r. For their common point, Cramer's rule gives x = d_p (n_q x n_r) + d_q (n_r x n_p)
/// + d_r (n_p x n_q) and w = -det3.
template <class Numerator_, class Det3_>
struct Homogeneous {
  Vector<Numerator_> x;
  Det3_ w;
  int scale = 0;
};

template <class Plane>
using PointOf = Homogeneous<typename Types<Plane>::Numerator, typename Types<Plane>::Det3>;

/// Returns the common point of three planes. If the planes have no common point or more than one, w
/// is 0. Requires aligned planes.
template <class Plane>
PointOf<Plane> common_point(const Plane& p, const Plane& q, const Plane& r) {
  using T = Types<Plane>;
  const auto qr = cross<typename T::Minor>(q.n, r.n);
  const auto rp = cross<typename T::Minor>(r.n, p.n);
  const auto pq = cross<typename T::Minor>(p.n, q.n);
  PointOf<Plane> point;
  for (std::size_t i = 0; i < 3; ++i) {
    typename T::Numerator sum = product<typename T::Numerator>(p.d, qr[i]);
    sum += product<typename T::Numerator>(q.d, rp[i]);
    sum += product<typename T::Numerator>(r.d, pq[i]);
    point.x[i] = sum;
  }
  point.w = -dot<typename T::Det3>(pq, r.n);
  point.scale = p.scale != kAnyScale ? p.scale : (q.scale != kAnyScale ? q.scale : r.scale);
  if (point.scale == kAnyScale) point.scale = 0;
  return point;
}

/// Returns the sign of n.x + d w. The side of the plane on which the point lies is this sign times
/// the sign of w. Requires that the point and the plane have the same scale.
template <class Plane>
Sign value_sign(const PointOf<Plane>& point, const Plane& plane) {
  using T = Types<Plane>;
  typename T::Det4 value = dot<typename T::Det4>(point.x, plane.n);
  value += product<typename T::Det4>(plane.d, point.w);
  return sign_of(value);
}

}  // namespace plumb::exact3
#pragma GCC visibility pop
