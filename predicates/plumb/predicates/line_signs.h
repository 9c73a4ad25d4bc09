// Predicates on lines of space, each of which is given by two planes. No line is stored. Every
// result is exact, also for planes of the frame (docs/design/frame.md).
//
// turn_about_line (plane_signs.h) compares the directions in which two pairs of planes run along
// one line.
#pragma once

#include "plumb/predicates/space/plane_table.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Whether `plane` contains the common line of p and q. Requires that p and q are not parallel. The
/// degree in input coordinates is 7. Stages: identity (`plane` is p or q, or a wall of both), the
/// filter of det3, fixed-width integers, GMP integers.
bool holds_line(const PlaneTable& planes, PlaneId plane, PlaneId p, PlaneId q);

/// Whether the common line of p and q equals that of r and s. Requires that neither pair is
/// parallel. Cost: at most two calls of holds_line.
bool is_same_line(const PlaneTable& planes, PlaneId p, PlaneId q, PlaneId r, PlaneId s);

/// Returns the fingerprint of the line's Plücker coordinates (n_p x n_q, d_p n_q - d_q n_p). Equal
/// lines have equal fingerprints, whatever planes define them and in whatever order. Different
/// fingerprints prove that lines differ; equal ones must be confirmed by is_same_line. Requires
/// that p and q are not parallel. Cost: about 250 ns, mostly one modular inversion, and about 100
/// ns more for each plane with stored exact coefficients, such as a wall.
Fingerprint line_fingerprint(const PlaneTable& planes, PlaneId p, PlaneId q);

}  // namespace plumb
#pragma GCC visibility pop
