// Exact areas and boundary rings of the faces of a complex (plane_complex.h).
#pragma once

#include <optional>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the area of face f without its holes, or nothing if f is unbounded. Requires that f is
/// an ordinary face. O(length of its boundary) rational terms.
std::optional<Rational> face_area(const PlaneComplex& complex, FaceId f);

/// Returns the total area of the marked faces, or nothing if one of them is unbounded. Throws
/// ResourceLimit and Cancelled as the Context demands. O(n) rational terms.
std::optional<Rational> marked_area(const PlaneComplex& complex,
                                    Context& context = unlimited_context());

/// Returns the closed rings that bound a bounded face: the counter-clockwise outer ones first, then
/// the clockwise ones of its holes. The first vertex of a ring is not repeated at its end. A
/// boundary that touches itself at a vertex is cut there, so no ring visits a vertex twice. Edges
/// with f on both sides and isolated vertices are left out. O(b log b) for a boundary of b
/// half-edges, besides finding the least vertex of each ring and its two edges.
std::vector<std::vector<VertexId>> face_rings(const PlaneComplex& complex, FaceId f);

}  // namespace plumb
#pragma GCC visibility pop
