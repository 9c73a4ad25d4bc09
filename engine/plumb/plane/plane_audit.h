// Checks the invariants of a complex in the plane that plane_complex.h states.
#pragma once

#include <optional>

#include "plumb/base/context.h"
#include "plumb/base/marks.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Checks every invariant of a complex from scratch and returns the first one that is broken, with
/// its place, or nothing:
///   the arrays have the right sizes, and numberings have no holes
///   the half-edge structure is sound (Dcel::audit, audit_planar) and has no pinches
///   one ordinary edge ends at each frame vertex
///   the indices of points are in range, and the line of each edge runs from left to right
///   vertices are in lexicographic order, and each lies on the lines of its edges
///   edges leave each vertex in counter-clockwise order
///   a separate sweep finds that edges intersect at vertices only and that loops lie in the faces
///   that list them
/// AuditForm::Minimal also checks that no cell can be removed without changing the set (the form
/// of a Nef2). Throws ResourceLimit and Cancelled as the Context demands. O(n log n).
std::optional<DcelFlaw> audit(const PlaneComplex& complex, AuditForm form,
                              Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
