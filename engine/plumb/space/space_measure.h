// Exact measures of a set of space: volume and centroid of its marked volumes, and the area of
// their boundary.
//
// The volume is a sum over the boundary of signed tetrahedra with the origin as apex. Each facet is
// a sum over its edges, holes included, of signed triangles with one corner of the facet as apex.
// So nothing is triangulated. For vertices with double coordinates, all terms are fractions whose
// denominators are powers of two.
//
// All functions require volumes and marks, and throw what the context throws. Cost: a few rational
// terms for each edge of a facet, about 10 us.
#pragma once

#include <optional>

#include "plumb/base/context.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Returns the exact volume of all marked volumes together, or nothing if it is infinite. Cells of
/// lower dimension do not count, so the result is 0 if there is no marked volume.
std::optional<Rational> marked_volume(const SpaceComplex& complex,
                                      Context& context = unlimited_context());

/// Returns the exact centroid of the union of the marked volumes, or nothing if marked_volume() is
/// infinite or 0.
std::optional<RationalPoint3> marked_centroid(const SpaceComplex& complex,
                                              Context& context = unlimited_context());

/// Returns the area of all facets between a marked and an unmarked volume, or nothing if it is
/// infinite. The relative error is below 2^-50, except for overflow and subnormal results.
std::optional<double> surface_area(const SpaceComplex& complex,
                                   Context& context = unlimited_context());

}  // namespace plumb
#pragma GCC visibility pop
