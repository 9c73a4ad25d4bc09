// Exact areas and boundaries of the faces of a complex.
#pragma once

#include <optional>
#include <vector>

#include "plumb/base/context.h"
#include "plumb/plane/plane_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The area of face f, holes taken off; none when it is unbounded. O(length of its boundary)
/// rational terms.
std::optional<Rational> face_area(const PlaneComplex& complex, FaceId f);

/// The area of all marked faces; none when one of them is unbounded. O(n) rational terms.
std::optional<Rational> marked_area(const PlaneComplex& complex);
std::optional<Rational> marked_area(const PlaneComplex& complex, Context& context);  ///< As above.

/// The closed rings of a bounded face: outer first, counter-clockwise, then the holes clockwise.
/// Rings that touch themselves are cut at the touching vertices; edges with f on both sides and
/// isolated vertices are left out.
std::vector<std::vector<VertexId>> face_rings(const PlaneComplex& complex, FaceId f);

}  // namespace plumb
#pragma GCC visibility pop
