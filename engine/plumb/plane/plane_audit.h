// Checks the invariants of a complex in the plane. plane_complex.h states these invariants.
#pragma once

#include <optional>

#include "plumb/base/context.h"
#include "plumb/base/marks.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Checks every invariant of a complex from scratch. Returns the first broken invariant and its
/// location, or nullopt if all invariants hold. The invariants are checked in the order of this
/// list:
///   - The arrays have the right sizes. The ids of the vertices, of the edges and of the faces are
///     consecutive.
///   - The half-edge structure is sound (Dcel::audit, audit_planar) and has no pinches.
///   - Each frame vertex is the end of exactly one edge that is not a frame edge.
///   - The indices of points are in range, and the line of each edge runs from left to right.
///   - The vertices are in lexicographic order, and each vertex lies on the lines of its edges.
///   - The edges leave each vertex in counter-clockwise order.
///   - Edges intersect only at vertices. Each loop lies in the face that lists the loop. A separate
///     sweep checks these two invariants.
/// If `form` is AuditForm::Minimal, one more invariant is checked: no cell can be removed without
/// changing the set. The complex of a Nef2 is minimal in this sense. Throws ResourceLimit if a
/// limit of the Context is exceeded, and Cancelled if a stop is requested. Cost: O(n log n) for n
/// cells.
std::optional<DcelFlaw> audit(const PlaneComplex& complex, AuditForm form,
                              Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
