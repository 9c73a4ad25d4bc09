// Exact areas and boundary rings of the faces of a complex (plane_complex.h).
#pragma once

#include <optional>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the area of face f, or nullopt if f is unbounded. The area of the holes is not included.
/// Requires that f is not the face beyond the frame. Cost: O(b) additions of rational numbers for a
/// boundary of b edges.
std::optional<Rational> face_area(const PlaneComplex& complex, FaceId f);

/// Returns the total area of the marked faces, or nullopt if a marked face is unbounded. Throws
/// ResourceLimit if a limit of the Context is exceeded, and Cancelled if a stop is requested. Cost:
/// O(n) additions of rational numbers for n edges.
std::optional<Rational> marked_area(const PlaneComplex& complex,
                                    Context& context = unlimited_context());

/// Returns the closed rings that bound a bounded face f. The outer rings come first and run
/// counter-clockwise. The rings of the holes follow and run clockwise. The first vertex of a ring
/// is not repeated at its end. If a boundary touches itself at a vertex, the boundary is cut at
/// this vertex. So no ring visits a vertex twice. Isolated vertices, and edges with f on both
/// sides, are left out. Cost: O(b log b) for a boundary of b half-edges. For each ring, the degree
/// of the ring's lexicographically least vertex is added to this cost.
std::vector<std::vector<VertexId>> face_rings(const PlaneComplex& complex, FaceId f);

}  // namespace plumb
#pragma GCC visibility pop
