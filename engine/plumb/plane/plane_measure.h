// Exact areas and boundary rings of the faces of a complex (plane_complex.h).
#pragma once

#include <optional>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the area of face f, or nullopt if f is unbounded. Holes of the face do not count.
/// Requires that f is an ordinary face. Cost: a sum of as many rational terms as the boundary has
/// edges, up to a constant factor.
std::optional<Rational> face_area(const PlaneComplex& complex, FaceId f);

/// Returns the total area of the marked faces, or nullopt if a marked face is unbounded. Throws
/// ResourceLimit and Cancelled as the Context demands. Cost: the sum of O(n) rational terms.
std::optional<Rational> marked_area(const PlaneComplex& complex,
                                    Context& context = unlimited_context());

/// Returns the closed rings that bound a bounded face f. The outer rings come first and run
/// counter-clockwise. The rings of the holes follow and run clockwise. The first vertex of a ring
/// is not repeated at its end. A boundary that touches itself at a vertex is cut there, so no ring
/// visits a vertex twice. Isolated vertices, and edges with f on both sides, are left out. Cost:
/// O(b log b) for a boundary of b half-edges. Finding the least vertex of each ring and its two
/// edges costs extra.
std::vector<std::vector<VertexId>> face_rings(const PlaneComplex& complex, FaceId f);

}  // namespace plumb
#pragma GCC visibility pop
