// The predicates on planes, and on lines given by two planes: determinants of the rows (n, d).
//
// Each asks its filter stage with the rows of doubles, then exact integers of growing widths
// (exact3::exact_sign()). A determinant of degree 1 in the offsets is c0 + c1 R if a plane of the
// frame takes part; its two parts are asked one after the other, filters included
// (docs/design/frame.md).
//
// Error bounds of the filters, as docs/design/numbers.md (Planes) proves them. |n_i| <= 1; e and f
// are the normal_error and the offset_error of rows, whose errors are at most e / 2 and f / 2; the
// other halves pay for roundings. eps = 2^-52 bounds a rounding in any mode, and e >= 2^-48 = 16
// eps. What flushing subnormals loses is about 2^-1022 each, which the last bit of e and of f >=
// 2^-126 pays for.
//
//   minor  two products of components off by e_p / 2 and e_q / 2: e_p + e_q, roundings 6 eps.
//          The code takes 2 (e_p + e_q).
//   det3   the three components of a row are off by e / 2 against cofactors of at most 2: 3 e for
//          each row; roundings 30 eps. The code takes 6 (e_p + e_q + e_r).
//   det4   sum of d_i det3_i with |det3_i| <= 4, off by less than 4 sum e: 4 |d_i| sum e + 2 f_i;
//          roundings 20 eps sum |d|. The code takes 8 (sum e)(sum |d|) + 4 sum f.
//
// Nothing overflows: |d| <= 2^900 wherever f is finite. An infinite f makes the bound infinite, and
// the filter is Unsure.
//
// Tested by tests/predicates/plane_signs_test.cpp and tests/predicates/frame_test.cpp.

#include "plumb/predicates/plane_signs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "plumb/predicates/input/rung_counters.h"
#include "plumb/predicates/space/filter_stages.h"

namespace plumb {

using exact3::operands;

namespace {

/// Returns the sign of a value that is known up to `error`. Returns Unsure for NaNs.
FilteredSign beyond(double value, double error) {
  if (value > error) return FilteredSign::Positive;
  return value < -error ? FilteredSign::Negative : FilteredSign::Unsure;
}

/// Returns component i of the cross product of two normals.
double minor(const PlaneRow& p, const PlaneRow& q, std::size_t i) {
  const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
  return p.n[j] * q.n[k] - p.n[k] * q.n[j];
}

double det3(const PlaneRow& p, const PlaneRow& q, const PlaneRow& r) {
  return minor(p, q, 0) * r.n[0] + minor(p, q, 1) * r.n[1] + minor(p, q, 2) * r.n[2];
}

double sum_of_normal_errors(const PlaneRow& p, const PlaneRow& q, const PlaneRow& r) {
  return static_cast<double>(p.normal_error) + static_cast<double>(q.normal_error) +
         static_cast<double>(r.normal_error);
}

// The determinants as functions that exact3::exact_sign() calls with planes of any number type.
struct MinorForm {
  std::size_t axis;
  Sign operator()(const auto& p) const { return exact3::minor_sign(p[0], p[1], axis); }
};
struct Det3Form {
  Sign operator()(const auto& p) const { return exact3::det3_sign(p[0], p[1], p[2]); }
};
struct Det4Form {
  Sign operator()(const auto& p) const {
    return exact3::sign_of(exact3::determinants(p[0], p[1], p[2], p[3]).det4);
  }
};

}  // namespace

namespace rung {

FilteredSign minor_filter(const PlaneRow& p, const PlaneRow& q, std::size_t axis) {
  const double errors = static_cast<double>(p.normal_error) + static_cast<double>(q.normal_error);
  return beyond(minor(p, q, axis), 2 * errors);
}

FilteredSign det3_filter(const PlaneRow& p, const PlaneRow& q, const PlaneRow& r) {
  return beyond(det3(p, q, r), 6 * sum_of_normal_errors(p, q, r));
}

/// Expands by the column of offsets.
FilteredSign det4_filter(const PlaneRow& p, const PlaneRow& q, const PlaneRow& r,
                         const PlaneRow& s) {
  const double value =
      s.d * det3(p, q, r) - p.d * det3(q, r, s) + q.d * det3(p, r, s) - r.d * det3(p, q, s);
  const double offsets = std::fabs(p.d) + std::fabs(q.d) + std::fabs(r.d) + std::fabs(s.d);
  const double normal_errors = sum_of_normal_errors(p, q, r) + static_cast<double>(s.normal_error);
  const double offset_errors =
      static_cast<double>(p.offset_error) + static_cast<double>(q.offset_error) +
      static_cast<double>(r.offset_error) + static_cast<double>(s.offset_error);
  return beyond(value, 8 * normal_errors * offsets + 4 * offset_errors);
}

FilteredSign far_det4_filter(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s) {
  const auto is_frame = [&](PlaneId plane) { return planes.is_frame(plane); };
  if (!is_frame(p) && !is_frame(q) && !is_frame(r) && !is_frame(s)) return FilteredSign::Unsure;
  return det4_filter(far_row(planes, p), far_row(planes, q), far_row(planes, r),
                     far_row(planes, s));
}

FilteredSign near_det4_filter(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r,
                              PlaneId s) {
  return det4_filter(near_row(planes, p), near_row(planes, q), near_row(planes, r),
                     near_row(planes, s));
}

// For g++, the definition of a template determines its visibility, not the declaration in the
// header.
#pragma GCC visibility push(default)
template <class W>
FilteredSign minor_fixed(const PlaneTable& planes, PlaneId p, PlaneId q, std::size_t axis) {
  return exact3::fixed_sign<W>(operands<2>(planes, {p, q}), MinorForm{axis});
}
template <class W>
FilteredSign det3_fixed(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r) {
  return exact3::fixed_sign<W>(operands<3>(planes, {p, q, r}), Det3Form{});
}
template <class W>
FilteredSign det4_fixed(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s) {
  return exact3::fixed_sign<W>(operands<4>(planes, {p, q, r, s}), Det4Form{});
}

#pragma GCC visibility pop

template FilteredSign minor_fixed<exact3::Narrow>(const PlaneTable&, PlaneId, PlaneId, std::size_t);
template FilteredSign minor_fixed<exact3::Medium>(const PlaneTable&, PlaneId, PlaneId, std::size_t);
template FilteredSign minor_fixed<exact3::Wide>(const PlaneTable&, PlaneId, PlaneId, std::size_t);
template FilteredSign det3_fixed<exact3::Narrow>(const PlaneTable&, PlaneId, PlaneId, PlaneId);
template FilteredSign det3_fixed<exact3::Medium>(const PlaneTable&, PlaneId, PlaneId, PlaneId);
template FilteredSign det3_fixed<exact3::Wide>(const PlaneTable&, PlaneId, PlaneId, PlaneId);
template FilteredSign det4_fixed<exact3::Narrow>(const PlaneTable&, PlaneId, PlaneId, PlaneId,
                                                 PlaneId);
template FilteredSign det4_fixed<exact3::Medium>(const PlaneTable&, PlaneId, PlaneId, PlaneId,
                                                 PlaneId);
template FilteredSign det4_fixed<exact3::Wide>(const PlaneTable&, PlaneId, PlaneId, PlaneId,
                                               PlaneId);

Sign minor_big(const PlaneTable& planes, PlaneId p, PlaneId q, std::size_t axis) {
  return exact3::big_sign(operands<2>(planes, {p, q}), MinorForm{axis});
}
Sign det3_big(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r) {
  return exact3::big_sign(operands<3>(planes, {p, q, r}), Det3Form{});
}
Sign det4_big(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s) {
  return exact3::big_sign(operands<4>(planes, {p, q, r, s}), Det4Form{});
}

}  // namespace rung

namespace {

/// Calls the stages of a predicate in turn. The first argument is the answer of the filter.
template <std::size_t K, class Form>
Sign climb(Predicate predicate, FilteredSign filter, const PlaneTable& planes,
           const std::array<PlaneId, K>& ids, const Form& form) {
  if (is_decided(filter)) return plumb::decide(predicate, Rung::Filter, filter);
  return exact3::exact_sign(operands<K>(planes, ids), form,
                            [&](Rung rung) { count_rung(predicate, rung); });
}

Sign zero_by_identity(Predicate predicate) {
  count_rung(predicate, Rung::Identity);
  return Sign::Zero;
}

}  // namespace

Sign minor_sign(const PlaneTable& planes, PlaneId p, PlaneId q, std::size_t axis) {
  if (p == q) return zero_by_identity(Predicate::PlaneMinor);
  return climb<2>(Predicate::PlaneMinor, rung::minor_filter(planes.row(p), planes.row(q), axis),
                  planes, {p, q}, MinorForm{axis});
}

Sign det3_sign(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r) {
  if (p == q || q == r || p == r) return zero_by_identity(Predicate::PlaneDet3);
  return climb<3>(Predicate::PlaneDet3,
                  rung::det3_filter(planes.row(p), planes.row(q), planes.row(r)), planes, {p, q, r},
                  Det3Form{});
}

Sign det4_sign(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s) {
  if (p == q || p == r || p == s || q == r || q == s || r == s) {
    return zero_by_identity(Predicate::PlaneDet4);
  }
  FilteredSign filter =
      rung::det4_filter(planes.row(p), planes.row(q), planes.row(r), planes.row(s));
  if (!is_decided(filter)) filter = rung::far_det4_filter(planes, p, q, r, s);
  if (is_decided(filter)) return plumb::decide(Predicate::PlaneDet4, Rung::Filter, filter);
  return exact3::exact_sign(
      operands<4>(planes, {p, q, r, s}), Det4Form{},
      [&] { return rung::near_det4_filter(planes, p, q, r, s); },
      [](Rung rung) { count_rung(Predicate::PlaneDet4, rung); });
}

/// Let X be the common point of p, q, r. Then s(X) = det4 / det3(p, q, r), and along the direction
/// n_p x n_q the value of s grows by det3(p, q, s) per unit. The point Y is where s is zero, so
/// Y - X has the sign of -s(X) det3(p, q, s).
Sign order_along_line(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s) {
  return -(det4_sign(planes, p, q, r, s) * det3_sign(planes, p, q, r) * det3_sign(planes, p, q, s));
}

/// All four normals are orthogonal to the line, so n_m1 x n_m2 is a multiple of n_p x n_q. Any
/// component where the latter is not zero gives the sign of the factor. The component that is
/// largest in doubles is tried first, because its filter is most likely to decide.
Sign turn_about_line(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId m1, PlaneId m2) {
  if (m1 == m2) return Sign::Zero;
  std::array<std::size_t, 3> axes = {0, 1, 2};
  const PlaneRow &a = planes.row(p), &b = planes.row(q);
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::fabs(minor(a, b, axes[i])) > std::fabs(minor(a, b, axes[0]))) {
      std::swap(axes[0], axes[i]);
    }
  }
  for (const std::size_t axis : axes) {
    const Sign along = minor_sign(planes, p, q, axis);
    if (along != Sign::Zero) return along * minor_sign(planes, m1, m2, axis);
  }
  return Sign::Zero;
}

using exact3::BigPlane;

namespace {

/// The sign is Zero if the three rows are linearly dependent, and Positive otherwise. The four 3 x
/// 3 minors of the rows are the homogeneous coordinates of the common point. They all vanish if and
/// only if there is more than one common point, that is, a common line.
struct PencilForm {
  template <class Plane>
  Sign operator()(const std::array<Plane, 3>& p) const {
    const auto common = exact3::common_point(p[0], p[1], p[2]);
    const auto is_zero = [](const auto& x) { return exact3::sign_of(x) == Sign::Zero; };
    return is_zero(common.w) && std::all_of(common.x.begin(), common.x.end(), is_zero)
               ? Sign::Zero
               : Sign::Positive;
  }
};

/// Returns the fingerprint of a line whose residues all vanish, from its integer coordinates
/// without their common factor; equal lines share these up to the sign, which the leading residue
/// takes out. Coordinates are linear in the offsets, so in R: the direction u has no R, and the
/// moment is kept in its two parts.
Fingerprint primitive_fingerprint(const PlaneTable& planes, PlaneId p, PlaneId q) {
  const IntegerRow a = planes.coefficients(p), b = planes.coefficients(q);
  std::array<Integer, 3> u, finite, infinite;
  Integer divisor = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Integer of_a = a[3] * b[i], of_b = b[3] * a[i];
    u[i] = a[j] * b[k] - a[k] * b[j];
    (planes.is_frame(p) ? infinite : finite)[i] += of_a;
    (planes.is_frame(q) ? infinite : finite)[i] -= of_b;
    for (const Integer& x : {u[i], finite[i], infinite[i]}) divisor = gcd(divisor, x);
  }
  const auto residue = [&](const Integer& x) { return Residue::of(Integer(x / divisor)); };
  LineResidues row;
  for (std::size_t i = 0; i < 3; ++i) {
    row[i] = residue(u[i]);
    row[i + 3] = residue(finite[i]) + kFrameResidue * residue(infinite[i]);
  }
  return fingerprint(row);
}

}  // namespace

/// If det3 is not zero, the three planes have exactly one common point, so `plane` does not contain
/// the line. The converse requires the exact values of all minors.
bool holds_line(const PlaneTable& planes, PlaneId plane, PlaneId p, PlaneId q) {
  const std::array<PlaneId, 2> pair = {p, q};
  if (plane == p || plane == q || planes.is_wall_of(plane, pair)) {
    count_rung(Predicate::HoldsLine, Rung::Identity);
    return true;
  }
  if (is_decided(rung::det3_filter(planes.row(p), planes.row(q), planes.row(plane)))) {
    count_rung(Predicate::HoldsLine, Rung::Filter);
    return false;
  }
  return exact3::exact_sign(exact3::operands<3>(planes, {p, q, plane}), PencilForm{},
                            [](Rung rung) { count_rung(Predicate::HoldsLine, rung); }) ==
         Sign::Zero;
}

bool is_same_line(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s) {
  return holds_line(planes, r, p, q) && holds_line(planes, s, p, q);
}

Fingerprint line_fingerprint(const PlaneTable& planes, PlaneId p, PlaneId q) {
  const PlaneResidues a = residues(planes, p), b = residues(planes, q);
  const Residues3 u = cross(a.n, b.n), moment = a.d * b.n - b.d * a.n;
  const LineResidues row = {u[0], u[1], u[2], moment[0], moment[1], moment[2]};
  return leading(row).is_zero() ? primitive_fingerprint(planes, p, q) : fingerprint(row);
}

}  // namespace plumb
