// Predicates on planes of space, and on lines that are each given by two planes. No line is stored.
// Every result is exact, including the results for planes of the frame (docs/design/frame.md).
//
// The line of the planes p and q has the direction n_p x n_q, where n_p and n_q are the normals of
// the planes. Two pairs of planes can define the same line with opposite directions.
// turn_about_line() compares the two directions.
#pragma once

#include <cstddef>

#include "plumb/predicates/sign.h"
#include "plumb/predicates/space/plane_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Whether `plane` contains the common line of p and q. Requires that p and q are not parallel. The
/// degree in input coordinates is 7. The function uses the following stages in turn until a stage
/// decides:
///   - identity: `plane` is p or q, or was constructed as a wall (a plane given by its position in
///     a pencil) through the common line of p and q;
///   - the filter of det3;
///   - fixed-width integers;
///   - GMP integers.
bool holds_line(const PlaneTable& planes, PlaneId plane, PlaneId p, PlaneId q);

/// Whether the common line of p and q equals the common line of r and s. Requires that p and q are
/// not parallel and that r and s are not parallel. Cost: at most two calls of holds_line.
bool is_same_line(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

/// Returns the fingerprint of the line's Plücker coordinates (n_p x n_q, d_p n_q - d_q n_p). The
/// fingerprint of a line does not depend on the choice or order of the planes that define the line.
/// Different fingerprints prove that the lines differ. Lines with equal fingerprints may differ, so
/// is_same_line must confirm that they are equal. Requires that p and q are not parallel. Cost:
/// about 250 ns, most of it for one modular inversion. Each plane whose exact coefficients are
/// stored, such as a wall, adds about 100 ns.
Fingerprint line_fingerprint(const PlaneTable& planes, PlaneId p, PlaneId q);

// Predicates on planes. The canonical row of a plane is (n, d), where n is its normal vector and d
// is its offset. The result of each predicate is the sign of a determinant of canonical rows, or a
// product of such signs. The determinants are:
//
//   minor(p, q, i)      component i of n_p x n_q, the direction of the line of p and q
//   det3(p, q, r)       determinant of the three normals
//   det4(p, q, r, s)    determinant of the four rows
//
// Every predicate on a polyhedral complex is a product of such signs (docs/design/planes-first.md).
// Every result is exact. Each plane has its canonical orientation. If a caller needs the sign for
// planes with other orientations, the caller multiplies the result by -1 for each reversed plane.
//
// The stages are identity (equal ids), the filters in namespace rung, integers of the fixed widths
// Narrow, Medium and Wide, and GMP integers. The page docs/design/numbers.md proves the error
// bounds of the filters and the bounds for the widths. Cost: a filter takes 3 to 8 ns. A stage of
// fixed width takes 60 to 250 ns for coordinates with full mantissas. GMP takes 2 to 6 us.

/// Returns the sign of component `axis` (0, 1 or 2) of n_p x n_q. The sign is Zero if the line of p
/// and q is orthogonal to the axis, or if p and q are parallel. Swapping p and q flips the sign.
/// The degree in input coordinates is 4.
Sign minor_sign(const PlaneTable& planes, PlaneId p, PlaneId q, std::size_t axis);

/// Returns the sign of det3(p, q, r). The sign is Zero if the normals are linearly dependent. In
/// this case there is a direction parallel to all three planes. The sign has two more meanings:
///   - The sign states on which side of the great circle of r the point n_p x n_q of the sphere
///     lies.
///   - For normals n, m1 and m2, (n x m1) x (n x m2) = n det3(n, m1, m2). Therefore a Positive
///     det3_sign(n, m1, m2) means that the direction n x m2 is counter-clockwise of n x m1, seen
///     from the positive side of n.
/// Swapping two planes flips the sign; the result is Zero if two planes are equal. The degree in
/// input coordinates is 6.
Sign det3_sign(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r);

/// Returns the sign of det4(p, q, r, s). The sign is Zero if the rows are linearly dependent. In
/// this case the four planes have a common point, or there is a direction parallel to all four
/// planes (a common point at infinity). Let X be the common point of p, q and r. The side of s on
/// which X lies is det4_sign(p, q, r, s) * det3_sign(p, q, r). Swapping two planes flips the sign;
/// the result is Zero if two planes are equal. The degree in input coordinates is 9.
Sign det4_sign(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

/// Returns the order of two points on the line of p and q, in the direction n_p x n_q. Let X be the
/// common point of p, q and r. Let Y be the common point of p, q and s. The result is the sign of
/// Y - X: Positive if Y comes after X. Requires that det3(p, q, r) and det3(p, q, s) are not zero.
/// The degree in input coordinates is 9.
Sign order_along_line(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

/// Returns the turn from n_m1 to n_m2 about the line of p and q. The result is the sign of the
/// number t with n_m1 x n_m2 = t (n_p x n_q). Requires that p and q are not parallel and that all
/// four planes are parallel to the same line. The degree in input coordinates is 4. Two examples of
/// the meaning of the sign:
///   - Let m1 and m2 be the planes of two facets at an edge. Zero means that the two facets are
///     coplanar.
///   - Let the pairs (p, q) and (m1, m2) define the same line. Positive means that n_p x n_q and
///     n_m1 x n_m2 have the same direction.
Sign turn_about_line(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId m1, PlaneId m2);

/// The stages of the predicates. Tests and benchmarks can call each stage on its own. W is
/// exact3::Narrow, Medium or Wide. A stage of fixed width returns Unsure if and only if its
/// operands are too long for the width.
namespace rung {

FilteredSign minor_filter(const PlaneRow& p, const PlaneRow& q, std::size_t axis);
FilteredSign det3_filter(const PlaneRow& p, const PlaneRow& q, const PlaneRow& r);
FilteredSign det4_filter(const PlaneRow& p, const PlaneRow& q, const PlaneRow& r,
                         const PlaneRow& s);
/// Filters for planes of the frame (filter_stages.h, docs/design/frame.md). If a plane of the frame
/// occurs in det4, then det4 = c0 + c1 R, where R is the half-width of the frame. far_det4_filter
/// decides the sign of c1. near_det4_filter decides the sign of c0 and requires that c1 is zero.
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
