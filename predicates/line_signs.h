// Lines of space, each given by two planes. Nothing of a line is stored. Every answer is exact; planes of the frame
// are planes like others.
//
// Whether p q and r s run along their line the same way: turn_about_line (plane_signs.h).
#pragma once

#include "plumb/predicates/plane_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Does `plane` hold the line of p and q? Requires p, q not parallel. Degree 7 in coordinates.
/// Ladder: identity (one of the two, a wall of both) -> det3 filter -> fixed widths -> mpz.
bool holds_line(const PlaneTable& planes, PlaneId plane, PlaneId p, PlaneId q);

/// Are the line of p, q and the line of r, s the same? Requires p, q and r, s not parallel.
bool is_same_line(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

/// Equal lines have equal fingerprints, whatever planes define them, in any order: those of the line's
/// Plücker coordinates (n_p x n_q, d_p n_q - d_q n_p). Different ones prove different lines; equal
/// ones are confirmed by is_same_line. Requires p, q not parallel.
/// Cost: ~250 ns, most of it an inversion; walls and other planes of exact coefficients ~100 ns more each.
Fingerprint line_fingerprint(const PlaneTable& planes, PlaneId p, PlaneId q);

}  // namespace plumb
#pragma GCC visibility pop
