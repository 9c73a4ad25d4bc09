// Signs about planes alone. All of them are determinants of the canonical rows (n, d):
//
//   minor(p, q, i)      component i of n_p x n_q, the direction of the line of p and q
//   det3(p, q, r)       of the three normals
//   det4(p, q, r, s)    of the four rows
//
// and the questions of a polyhedral complex are products of them (SPACE.md 2). Every answer is
// exact. Planes are canonical here: a caller with oriented planes multiplies by their orientations.
//
// Ladder: identity (equal ids) -> rung::*_filter -> fixed widths Narrow, Medium, Wide -> mpz.
// Cost: filter 3-8 ns; fixed 60-250 ns for full mantissas; mpz 2-6 us.
#pragma once

#include <cstddef>

#include "plumb/predicates/plane_table.h"
#include "plumb/predicates/sign.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Zero: parallel to coordinate plane `axis` = 0, 1, 2, or p and q are parallel.
/// Identities: minor_sign(p, q, i) = -minor_sign(q, p, i).
Sign minor_sign(const PlaneTable& planes, PlaneId p, PlaneId q, std::size_t axis);

/// Zero: the normals are dependent (a common direction).
/// Also: the point n_p x n_q of the sphere against the great circle of r; and the turn of
/// half-edges in a plane: (n x m1) x (n x m2) = n det3(n, m1, m2), so that seen from the positive
/// side of n the direction n x m2 is counter-clockwise of n x m1 when det3_sign(n, m1, m2) is
/// positive. Identities: changes sign when two planes are swapped; 0 when two are equal.
Sign det3_sign(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r);

/// Zero: the rows are dependent: the planes share a point, or at least a direction (a point at
/// infinity). The side of the common point of p, q, r on s is det4_sign(p,q,r,s) *
/// det3_sign(p,q,r). Identities: changes sign when two planes are swapped; 0 when two are equal.
Sign det4_sign(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

/// The order of Y = p q s after X = p q r along the direction n_p x n_q: the sign of Y - X.
/// Requires det3(p, q, r) and det3(p, q, s) nonzero. Degree 9.
Sign order_along_line(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

/// The turn from n_m1 to n_m2 about the line of p and q: the sign of l in n_m1 x n_m2 =
/// l (n_p x n_q). Requires p, q not parallel and all four planes parallel to one line. Degree 4.
/// For facets around an edge: Zero means the same or the opposite half-plane's direction. For one
/// line given as p q and as m1 m2: Positive when both run the same way.
Sign turn_about_line(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId m1, PlaneId m2);

/// The rungs, for tests and benchmarks. W: exact3::Narrow, Medium, Wide. A fixed rung is Unsure
/// exactly when the operands do not fit.
namespace rung {

FilteredSign minor_filter(const PlaneRow& p, const PlaneRow& q, std::size_t axis);
FilteredSign det3_filter(const PlaneRow& p, const PlaneRow& q, const PlaneRow& r);
FilteredSign det4_filter(const PlaneRow& p, const PlaneRow& q, const PlaneRow& r,
                         const PlaneRow& s);
/// The parts of a frame's determinant (frame_filters.h).
FilteredSign far_det4_filter(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);
FilteredSign near_det4_filter(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

template <class W>
FilteredSign minor_fixed(const PlaneTable& planes, PlaneId p, PlaneId q, std::size_t axis);
template <class W>
FilteredSign det3_fixed(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r);
template <class W>
FilteredSign det4_fixed(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

Sign minor_big(const PlaneTable& planes, PlaneId p, PlaneId q, std::size_t axis);
Sign det3_big(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r);
Sign det4_big(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

}  // namespace rung

}  // namespace plumb
#pragma GCC visibility pop
