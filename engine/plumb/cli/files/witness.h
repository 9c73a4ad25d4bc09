// Points that prove verdicts on sets of space: a point inside a set, a segment that leaves it, a
// plane between two sets.
#pragma once

#include <optional>

#include "plumb/base/context.h"
#include "plumb/predicates/rational_point.h"
#include "plumb/space/nef3.h"

namespace plumb::cli {

/// Returns a point inside a marked volume of the set, with short coordinates where there are some;
/// nothing if the set has no marked volume.
std::optional<RationalPoint3> inner_point(const Nef3& set, Context& context);

/// A segment between two inner points of a set, and a point of the segment inside a volume that
/// does not belong to the set.
struct LeavingSegment {
  RationalPoint3 from;     ///< An end.
  RationalPoint3 to;       ///< The other end.
  RationalPoint3 outside;  ///< A point strictly between the ends.
};

/// Searches for a segment that leaves the set: first across reflex edges, then between volumes.
/// Returns nothing if none is found; a set may fail to be convex at single points only.
std::optional<LeavingSegment> leaving_segment(const Nef3& set, Context& context);

/// The plane a x + b y + c z + d = 0.
struct SeparatingPlane {
  RationalPoint3 normal;  ///< The vector (a, b, c).
  Rational offset;        ///< The number d.
};

/// Searches for a plane with all vertices of `a` on its negative side and all vertices of `b` on
/// its positive side. Returns no value if the convex hulls meet, if they are so close that doubles
/// cannot separate them, or if a set is unbounded or empty.
std::optional<SeparatingPlane> separating_plane(const Nef3& a, const Nef3& b, Context& context);

}  // namespace plumb::cli
