// Checks the invariants of a sphere map. sphere_map.h states the notation.
#pragma once

#include <optional>

#include "plumb/base/marks.h"
#include "plumb/dcel/dcel.h"
#include "plumb/sphere/sphere_map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Checks every invariant of a map from scratch. Returns the first broken invariant and where it is
/// broken, or nullopt if all hold. The invariants, in the order of the checks:
///   - The arrays have the right sizes. All ids are in range. Each mark is 0, 1 or kBeyond. A loop
///     has no end points; any other arc has two.
///   - Different circles have different normals. The two planes of each direction cross.
///   - The half-arcs are linked: those that leave a point form one ring around it. All half-arcs of
///     a boundary cycle name the same face.
///   - Points lie on the circles of their arcs. The ring around each point turns clockwise, exactly
///     once around.
///   - No two points are equal. Arcs intersect at points only. There is at most one loop.
///   - Each boundary cycle and each isolated point names the face that it bounds. Every face has a
///     boundary.
/// AuditForm::Minimal also checks that no cell can be removed without changing the set. The cost is
/// that of an overlay of the map with itself, which is O(n^2) for small maps.
std::optional<DcelFlaw> audit(const PlaneTable& planes, const SphereMap& map, AuditForm form);

}  // namespace plumb
#pragma GCC visibility pop
