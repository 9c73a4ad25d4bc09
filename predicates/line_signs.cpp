#include "plumb/predicates/line_signs.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "plumb/predicates/plane_ladder.h"
#include "plumb/predicates/plane_signs.h"
#include "plumb/predicates/residues3.h"
#include "plumb/predicates/rung_counters.h"

namespace plumb {

using exact3::BigPlane;

namespace {

/// Zero: the three rows are dependent. Their four 3 x 3 minors are the homogeneous point they have
/// in common; that they all vanish is one point too many.
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

/// All residues vanish: the coordinates without a common factor, which equal lines share up to
/// their sign. Coordinates are linear in offsets, so in R: u, then both parts of the moment.
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
