// Exact measures of a set of space: of what its marked volumes fill, and of the boundary of that.
//
// A volume is the sum of signed tetrahedra from the origin over its boundary, a facet the sum of signed triangles
// from one of its corners over its edges, holes included: nothing is triangulated, and sums over vertices
// in doubles stay fractions of powers of two.
//
// Cost: a few rational terms for each edge of a facet, ~10 us. Those with a context stay within its limits.
#pragma once

#include <optional>

#include "plumb/base/context.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/space_complex.h"

#pragma GCC visibility push(default)
namespace plumb {

/// The volume of all marked volumes; none when it is infinite. Lower items have no volume: 0 without
/// marked volumes.
std::optional<Rational> marked_volume(const SpaceComplex& complex);
std::optional<Rational> marked_volume(const SpaceComplex& complex,
                                      Context& context);  ///< As above.

/// The centroid of what the marked volumes fill; none when marked_volume() is none or 0.
std::optional<RationalPoint3> marked_centroid(const SpaceComplex& complex);
/// As above.
std::optional<RationalPoint3> marked_centroid(const SpaceComplex& complex, Context& context);

/// The area of all facets between a marked volume and one that is not; none when it is infinite. The
/// relative error is below 2^-50, but for overflow and subnormal results.
std::optional<double> surface_area(const SpaceComplex& complex);
std::optional<double> surface_area(const SpaceComplex& complex, Context& context);  ///< As above.

}  // namespace plumb
#pragma GCC visibility pop
