// Checks the invariants of a sphere map. sphere_map.h states the notation.
#pragma once

#include <optional>

#include "plumb/base/marks.h"
#include "plumb/dcel/dcel.h"
#include "plumb/sphere/sphere_map.h"

#pragma GCC visibility push(default)
namespace plumb {

/// Checks every invariant of a map from scratch. Returns the first broken invariant and its
/// location, or nullopt if all invariants hold. The invariants are checked in the order of this
/// list:
///   - The arrays have the right sizes. All ids are in range. Each mark is 0, 1 or kBeyond. A loop
///     has no end points. Any other arc has two end points.
///   - Different circles have different normals. The two planes of each direction are not parallel.
///   - The links between half-arcs are consistent. All half-arcs that leave the same point form one
///     ring around this point. All half-arcs of a boundary cycle have the same face.
///   - Points lie on the circles of their arcs. The half-arcs in the ring around a point are in
///     clockwise order, and the ring goes around the point exactly once.
///   - No two points are equal. Arcs intersect at points only. There is at most one loop.
///   - Each boundary cycle and each isolated point is stored with a face. The cycle or point must
///     bound this face. Every face has a boundary.
/// If `form` is AuditForm::Minimal, one more invariant is checked: no cell can be removed without
/// changing the set. The audit costs as much as an overlay of the map with itself. For small maps
/// with n cells this is O(n^2).
std::optional<DcelFlaw> audit(const PlaneTable& planes, const SphereMap& map, AuditForm form);

}  // namespace plumb
#pragma GCC visibility pop
