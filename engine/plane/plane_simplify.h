// The unique minimal form of a marked complex, in linear time and without a sweep.
//
// Main flow of simplify():
//  1. an edge goes if its mark is that of both faces beside it; these become one (union-find)
//  2. a vertex that keeps no edge goes if its mark is that of its face; one that keeps two on one
//     line goes if its mark is theirs; else it stays
//  3. chains of edges through gone vertices become one edge each, at the place of the first
//  4. trace_loops and finish (plane_draft.h), with the merged faces as classes
// Cost: O(n a(n)), one cross_sign for each vertex that keeps two edges.
#pragma once

#include "plumb/plane/plane_complex.h"

namespace plumb {

/// Requires a complex that is right but for being minimal. Idempotent.
PlaneComplex simplify(PlaneComplex complex);

/// Marks of the interior: an edge or vertex stays marked only if everything around it is.
PlaneMarks interior_marks(const PlaneComplex& complex);
/// Marks of the closure: an edge or vertex is marked if anything around it is.
PlaneMarks closure_marks(const PlaneComplex& complex);

}  // namespace plumb
