// Checks the invariants of a complex in the plane. plane_complex.h states these invariants.
#pragma once

#include <optional>

#include "plumb/base/context.h"
#include "plumb/base/marks.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Checks every invariant of a complex from scratch. Returns the first broken invariant and where
/// it is broken, or nullopt if all hold. The invariants, in the order of the checks:
///   - The arrays have the right sizes, and the ids of each kind of cell are consecutive.
///   - The half-edge structure is sound (Dcel::audit, audit_planar) and has no pinches.
///   - Exactly one ordinary edge ends at each frame vertex.
///   - The indices of points are in range, and the line of each edge runs from left to right.
///   - The vertices are in lexicographic order, and each vertex lies on the lines of its edges.
///   - The edges leave each vertex in counter-clockwise order.
///   - Edges intersect at vertices only, and each loop lies in the face that lists it. A separate
///     sweep checks this.
/// AuditForm::Minimal also checks that no cell can be removed without changing the set. The complex
/// of a Nef2 has this form. Throws ResourceLimit and Cancelled as the Context demands. O(n log n).
std::optional<DcelFlaw> audit(const PlaneComplex& complex, AuditForm form,
                              Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
