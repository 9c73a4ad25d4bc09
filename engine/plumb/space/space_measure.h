// Computes measures of a set of space: the exact volume and the exact centroid of the marked
// volumes, and the rounded area of their boundary.
//
// The volume is computed as a sum of signed volumes of tetrahedra. Each tetrahedron has the origin
// as apex, and a triangle of the boundary as base. There is one signed triangle for each edge of a
// facet, including the edges of holes. The corners of the triangle are the ends of the edge and one
// fixed corner of the facet. So no facet has to be triangulated. If the coordinates of all vertices
// are doubles, the denominators of all terms are powers of two.
//
// All functions require that the complex has volumes and marks. All functions throw the errors of
// the Context. Cost: each edge of a facet adds a few rational terms, which takes about 10 us.
#pragma once

#include <optional>

#include "plumb/base/context.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the sum of the exact volumes of all marked volumes, or nullopt if the sum is infinite.
/// If there is no marked volume, the result is 0, because facets, edges and vertices have no
/// volume.
std::optional<Rational> marked_volume(const SpaceComplex& complex,
                                      Context& context = unlimited_context());

/// Returns the exact centroid of the union of the marked volumes, or nullopt if marked_volume() is
/// infinite or 0.
std::optional<RationalPoint3> marked_centroid(const SpaceComplex& complex,
                                              Context& context = unlimited_context());

/// Returns the area of all facets between a marked and an unmarked volume, or nullopt if the area
/// is infinite. The relative error is below 2^-50, unless the result overflows or is subnormal.
std::optional<double> surface_area(const SpaceComplex& complex,
                                   Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
